// The inverses of the energy's diagonal blocks, as a preconditioner of the free points' system.
#pragma once

#include "interpolate/free_system.hpp"

namespace surpass {

class FreePreconditioner {
 public:
  FreePreconditioner(const FreeSystem& system, Precision precision);

  /// z = the inverse block of point j times r, `kWidth` numbers or, for 0, as many as there are.
  template <std::size_t kWidth>
  void times(std::size_t j, const double* r, double* z) const {
    if (rounded_.empty()) {
      times<kWidth>(&inverse_[j * block_], r, z);
    } else {
      times<kWidth>(&rounded_[j * block_], r, z);
    }
  }

  /// Whether no free point moves in one direction far more easily than in others. If one does,
  /// errors of its gradient come back as much larger ones.
  [[nodiscard]] bool is_tame() const { return tame_; }
  /// 1, or 6: as PatchEnergy::block_size().
  [[nodiscard]] std::size_t block_size() const { return block_; }
  /// #control points by block_size(); empty in single precision. The identity where the energy does
  /// not see the point: its gradient vanishes there, and what else moves the point finds it free to
  /// go.
  [[nodiscard]] const std::vector<double>& inverse() const { return inverse_; }

 private:
  template <std::size_t kWidth, class Real>
  void times(const Real* d, const double* r, double* z) const {
    if (kWidth != 3 || block_ == 1) {
      for (std::size_t c = 0; c < (kWidth == 0 ? width_ : kWidth); ++c) z[c] = d[0] * r[c];
      return;
    }
    z[0] = d[0] * r[0] + d[1] * r[1] + d[2] * r[2];
    z[1] = d[1] * r[0] + d[3] * r[1] + d[4] * r[2];
    z[2] = d[2] * r[0] + d[4] * r[1] + d[5] * r[2];
  }
  template <class Real>
  void invert(const FreeSystem& system, std::vector<Real>& blocks);
  // Whether the block is tame.
  template <class Real>
  bool invert(Real* block) const;

  std::size_t width_;
  std::size_t block_;
  std::vector<double> inverse_;
  std::vector<float> rounded_;  // the same in single precision, instead
  bool tame_ = true;
};

/// A preconditioner, and the precision of products that is good enough beside it.
struct Preconditioned {
  FreePreconditioner inverse;
  Precision precision;
};

/// Single precision where time matters, the tolerance is loose and the preconditioner tame; the
/// preconditioner itself only without constraints, for they rely on the full one.
[[nodiscard]] Preconditioned precondition(const FreeSystem& system, double tolerance);

}  // namespace surpass

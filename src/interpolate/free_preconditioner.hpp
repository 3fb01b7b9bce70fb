// The inverses of the energy's diagonal blocks, as a preconditioner of the free points' system.
#pragma once

#include "interpolate/free_system.hpp"

namespace surpass {

class FreePreconditioner {
 public:
  explicit FreePreconditioner(const FreeSystem& system);

  /// z = the inverse block of point j times r, `kWidth` numbers or, for 0, as many as there are.
  template <std::size_t kWidth>
  void times(std::size_t j, const double* r, double* z) const {
    const double* d = &inverse_[j * block_];
    if (kWidth != 3 || block_ == 1) {
      for (std::size_t c = 0; c < (kWidth == 0 ? width_ : kWidth); ++c) z[c] = d[0] * r[c];
      return;
    }
    z[0] = d[0] * r[0] + d[1] * r[1] + d[2] * r[2];
    z[1] = d[1] * r[0] + d[3] * r[1] + d[4] * r[2];
    z[2] = d[2] * r[0] + d[4] * r[1] + d[5] * r[2];
  }

  /// Whether no free point moves in one direction far more easily than in others. If one does,
  /// errors of its gradient come back as much larger ones.
  [[nodiscard]] bool is_tame() const { return tame_; }
  /// 1, or 6: as PatchEnergy::block_size().
  [[nodiscard]] std::size_t block_size() const { return block_; }
  /// #control points by block_size(). The identity where the energy does not see the point: its
  /// gradient vanishes there, and what else moves the point finds it free to go.
  [[nodiscard]] const std::vector<double>& inverse() const { return inverse_; }

 private:
  // Whether the block is tame.
  bool invert(double* d) const;

  std::size_t width_;
  std::size_t block_;
  std::vector<double> inverse_;
  bool tame_;
};

}  // namespace surpass

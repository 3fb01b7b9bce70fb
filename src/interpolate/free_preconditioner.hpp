// The inverses of the energy's diagonal blocks, as a preconditioner of the free points' system.
#pragma once

#include "interpolate/free_system.hpp"

namespace surpass {

class FreePreconditioner {
 public:
  explicit FreePreconditioner(const FreeSystem& system);

  /// use(i, z) for each number i of point j: z is that of the inverse block times those of r.
  template <class Use>
  void apply(std::size_t j, std::span<const double> r, Use&& use) const {
    const std::size_t at = j * width_;
    const double* d = &inverse_[j * block_];
    if (block_ == 1) {
      for (std::size_t i = at; i < at + width_; ++i) use(i, d[0] * r[i]);
      return;
    }
    const double x = r[at];
    const double y = r[at + 1];
    const double z = r[at + 2];
    use(at, d[0] * x + d[1] * y + d[2] * z);
    use(at + 1, d[1] * x + d[3] * y + d[4] * z);
    use(at + 2, d[2] * x + d[4] * y + d[5] * z);
  }

  /// 1, or 6: as PatchEnergy::block_size().
  [[nodiscard]] std::size_t block_size() const { return block_; }
  /// #control points by block_size(). The identity where the energy does not see the point: its
  /// gradient vanishes there, and what else moves the point finds it free to go.
  [[nodiscard]] const std::vector<double>& inverse() const { return inverse_; }

 private:
  void invert(double* d) const;

  std::size_t width_;
  std::size_t block_;
  std::vector<double> inverse_;
};

}  // namespace surpass

// The inverses of the energy's diagonal blocks, as a preconditioner of the free points' system.
#pragma once

#include "interpolate/free_system.hpp"

namespace surpass {

class FreePreconditioner {
 public:
  explicit FreePreconditioner(const FreeSystem& system);

  /// z = the inverse blocks times r; back comes r.z.
  double apply(std::span<const double> r, std::span<double> z) const;

  /// 1, or 6: as PatchEnergy::block_size().
  [[nodiscard]] std::size_t block_size() const { return block_; }
  /// #control points by block_size(). The identity where the energy does not see the point: its
  /// gradient vanishes there, and what else moves the point finds it free to go.
  [[nodiscard]] const std::vector<double>& inverse() const { return inverse_; }

 private:
  void invert(double* d) const;

  const FreeSystem& system_;
  std::size_t block_;
  std::vector<double> inverse_;
};

}  // namespace surpass

#include "interpolate/free_preconditioner.hpp"

namespace surpass {

FreePreconditioner::FreePreconditioner(const FreeSystem& system)
    : width_(system.width),
      block_(system.energy.block_size()),
      inverse_(system.energy.diagonal(system.context)) {
  const auto invert_range = [&](std::size_t begin, std::size_t end) {
    bool tame = true;
    for (std::size_t j = begin; j < end; ++j) {
      const bool own = invert(&inverse_[j * block_]);
      tame = tame && (own || !system.elimination.is_free(static_cast<Index>(j)));
    }
    return tame;
  };
  tame_ = parallel::reduce(system.context, system.elimination.control_count(), true, invert_range,
                           [](bool all, bool part) { return all && part; });
}

bool FreePreconditioner::invert(double* d) const {
  if (block_ == 1) {
    *d = *d > 0 ? 1 / *d : 1;
    return true;
  }
  // A symmetric block of 3; where it is singular or nearly so, its mean diagonal stands in.
  const double a = d[3] * d[5] - d[4] * d[4];
  const double b = d[2] * d[4] - d[1] * d[5];
  const double c = d[1] * d[4] - d[2] * d[3];
  const double determinant = d[0] * a + d[1] * b + d[2] * c;
  const double mean = (d[0] + d[3] + d[5]) / 3;
  constexpr double kFlat = 1e-9;
  constexpr double kTame = 1e-3;
  if (!(determinant > kFlat * mean * mean * mean)) {
    const double inverse = mean > 0 ? 1 / mean : 1;
    d[0] = d[3] = d[5] = inverse;
    d[1] = d[2] = d[4] = 0;
    return !(mean > 0);
  }
  const double e = (d[0] * d[5] - d[2] * d[2]) / determinant;
  const double f = (d[1] * d[2] - d[0] * d[4]) / determinant;
  const double g = (d[0] * d[3] - d[1] * d[1]) / determinant;
  d[0] = a / determinant;
  d[1] = b / determinant;
  d[2] = c / determinant;
  d[3] = e;
  d[4] = f;
  d[5] = g;
  return determinant > kTame * mean * mean * mean;
}

}  // namespace surpass

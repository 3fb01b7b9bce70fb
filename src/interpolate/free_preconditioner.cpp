#include "interpolate/free_preconditioner.hpp"

#include <algorithm>
#include <initializer_list>

namespace surpass {

FreePreconditioner::FreePreconditioner(const FreeSystem& system, Precision precision)
    : width_(system.width), block_(system.energy.block_size()) {
  if (precision == Precision::single) rounded_ = system.energy.diagonal_in_single(system.context);
  if (!rounded_.empty()) {
    invert(system, rounded_);
  } else {
    inverse_ = system.energy.diagonal(system.context);
    invert(system, inverse_);
  }
}

template <class Real>
void FreePreconditioner::invert(const FreeSystem& system, std::vector<Real>& blocks) {
  const auto invert_range = [&](std::size_t begin, std::size_t end) {
    bool tame = true;
    for (std::size_t j = begin; j < end; ++j) {
      const bool own = invert(&blocks[j * block_]);
      tame = tame && (own || !system.elimination.is_free(static_cast<Index>(j)));
    }
    return tame;
  };
  tame_ = parallel::reduce(system.context, system.elimination.control_count(), true, invert_range,
                           [](bool all, bool part) { return all && part; });
}

template <class Real>
bool FreePreconditioner::invert(Real* block) const {
  const auto set = [&](std::initializer_list<double> to) {
    std::transform(to.begin(), to.end(), block, [](double x) { return static_cast<Real>(x); });
  };
  if (block_ == 1) {
    set({block[0] > 0 ? 1.0 / block[0] : 1.0});
    return true;
  }
  double d[6];
  std::copy_n(block, 6, d);
  const double a = d[3] * d[5] - d[4] * d[4];
  const double b = d[2] * d[4] - d[1] * d[5];
  const double c = d[1] * d[4] - d[2] * d[3];
  const double determinant = d[0] * a + d[1] * b + d[2] * c;
  const double mean = (d[0] + d[3] + d[5]) / 3;
  constexpr double kFlat = 1e-9;
  constexpr double kTame = 1e-3;
  constexpr double kTiny = 1e-30;  // single precision still has the inverses of such blocks
  // A symmetric block of 3; where it is singular or nearly so, its mean diagonal stands in.
  if (!(determinant > kFlat * mean * mean * mean)) {
    const double inverse = mean > 0 ? 1 / mean : 1;
    set({inverse, 0, 0, inverse, 0, inverse});
    return !(mean > 0);
  }
  set({a / determinant, b / determinant, c / determinant, (d[0] * d[5] - d[2] * d[2]) / determinant,
       (d[1] * d[2] - d[0] * d[4]) / determinant, (d[0] * d[3] - d[1] * d[1]) / determinant});
  return mean > kTiny && determinant > kTame * mean * mean * mean;
}

// A tolerance is loose if a few steps reach it. Single precision loses a little of what makes the
// directions conjugate in each step: at 1e-3 it took a fifth more of them, which was all that it
// had saved.
Preconditioned precondition(const FreeSystem& system, double tolerance) {
  constexpr double kLoose = 1e-2;
  constexpr Index kMany = 65536;
  const bool enough = tolerance >= kLoose && system.elimination.control_count() >= kMany;
  if (enough && system.constraints == nullptr) {
    FreePreconditioner rounded(system, Precision::single);
    if (rounded.is_tame()) return {std::move(rounded), Precision::single};
  }
  FreePreconditioner full(system, Precision::full);
  const bool tame = full.is_tame();
  return {std::move(full), enough && tame ? Precision::single : Precision::full};
}

}  // namespace surpass

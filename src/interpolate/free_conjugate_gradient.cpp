#include "interpolate/free_preconditioner.hpp"
#include "interpolate/free_progress.hpp"
#include "interpolate/linear_constraints.hpp"

namespace surpass {
namespace {

// Of a gradient: its squared length, and its product with the preconditioned one.
struct Lengths {
  double squared = 0;
  double rho = 0;
};

// The arrays are far larger than any cache, and what is done with their numbers takes no time. So
// each function is one pass over them, and the preconditioned gradient is computed where it is
// needed: once for its length, once for the direction. Three numbers a point, the case that
// matters, stay in registers.

// Room for those of a point; kWidth is 0 for any width.
template <std::size_t kWidth>
class Numbers {
 public:
  explicit Numbers(std::size_t width) : numbers_(kWidth == 0 ? width : 0) {}
  [[nodiscard]] double* place() { return kWidth == 0 ? numbers_.data() : fixed_; }

 private:
  double fixed_[kWidth == 0 ? 1 : kWidth] = {};
  std::vector<double> numbers_;
};

template <std::size_t kWidth>
Lengths descend_range(const FreeSystem& system, const FreePreconditioner& preconditioner,
                      double length, const double* image, double* gradient, std::size_t begin,
                      std::size_t end) {
  const std::size_t width = kWidth == 0 ? system.width : kWidth;
  Numbers<kWidth> r(width);
  Numbers<kWidth> z(width);
  Lengths sums;
  for (std::size_t j = begin; j < end; ++j) {
    double squared = 0;
    double rho = 0;
    system.elimination.restricted<kWidth>(j, width, image, r.place());
    for (std::size_t c = 0; c < width; ++c) {
      r.place()[c] = gradient[j * width + c] + length * r.place()[c];
    }
    preconditioner.times<kWidth>(j, r.place(), z.place());
    for (std::size_t c = 0; c < width; ++c) {
      gradient[j * width + c] = r.place()[c];
      squared += r.place()[c] * r.place()[c];
      rho += r.place()[c] * z.place()[c];
    }
    sums.squared += squared;
    sums.rho += rho;
  }
  return sums;
}

// The gradient goes along the direction by that direction's image, restricted.
Lengths descend(const FreeSystem& system, const FreePreconditioner& preconditioner, double length,
                std::span<const double> image, std::span<double> gradient) {
  const auto range = system.width == 3 ? descend_range<3> : descend_range<0>;
  return parallel::reduce(
      system.context, system.elimination.control_count(), Lengths{},
      [&](std::size_t begin, std::size_t end) {
        return range(system, preconditioner, length, image.data(), gradient.data(), begin, end);
      },
      [](const Lengths& sum, const Lengths& part) {
        return Lengths{sum.squared + part.squared, sum.rho + part.rho};
      });
}

struct Turn {
  double length;
  double share;
  const double* gradient;
  double* direction;
  double* x;
};

template <std::size_t kWidth>
void turn_range(const FreeSystem& system, const FreePreconditioner& preconditioner, const Turn& by,
                std::size_t begin, std::size_t end) {
  const std::size_t width = kWidth == 0 ? system.width : kWidth;
  Numbers<kWidth> z(width);
  for (std::size_t j = begin; j < end; ++j) {
    preconditioner.times<kWidth>(j, by.gradient + j * width, z.place());
    for (std::size_t c = 0; c < width; ++c) {
      const double direction = by.direction[j * width + c];
      by.x[j * width + c] += by.length * direction;
      by.direction[j * width + c] = by.share * direction - z.place()[c];
    }
  }
}

// x goes along the direction, which then becomes share times itself minus the preconditioned
// gradient.
void turn(const FreeSystem& system, const FreePreconditioner& preconditioner, double length,
          double share, std::span<const double> gradient, std::span<double> direction,
          std::span<double> x) {
  const auto range = system.width == 3 ? turn_range<3> : turn_range<0>;
  const Turn by{length, share, gradient.data(), direction.data(), x.data()};
  parallel::for_ranges(
      system.context, system.elimination.control_count(),
      [&](std::size_t begin, std::size_t end) { range(system, preconditioner, by, begin, end); });
}

void move(const FreeSystem& system, double length, std::span<const double> direction,
          std::span<double> x) {
  parallel::for_ranges(system.context, x.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) x[i] += length * direction[i];
  });
}

}  // namespace

FreeOutcome conjugate_gradient(const FreeSystem& system, const Preconditioned& preconditioned,
                               const StopAt& stop, std::vector<double> first,
                               std::span<double> gradient, std::span<double> x) {
  if (system.constraints != nullptr) system.constraints->clear(gradient);
  FreeProgress progress(system, stop, gradient);
  if (!progress.goes_on()) return std::move(progress).outcome();
  const FreePreconditioner& preconditioner = preconditioned.inverse;
  const Precision precision = preconditioned.precision;
  std::vector<double> direction = std::move(first);
  std::vector<double> image(system.size());
  const auto go = [&](double length) {
    Lengths now = descend(system, preconditioner, length, image, gradient);
    if (system.constraints != nullptr) {
      system.constraints->clear(gradient);
      now = descend(system, preconditioner, 0, image, gradient);
    }
    progress.note(now.squared);
    return now;
  };
  if (system.constraints != nullptr) system.constraints->keep(direction);
  const double bending = system.product(precision, direction, image);
  const double reach = bending > 0 ? -system.dot(direction, gradient) / bending : 0;
  double rho =
      bending > 0 ? go(reach).rho : descend(system, preconditioner, 0, image, gradient).rho;
  turn(system, preconditioner, reach, 0, gradient, direction, x);
  while (rho > 0 && progress.goes_on()) {
    const double curvature = system.product(precision, direction, image);
    if (!(curvature > 0)) break;  // nothing is left but what the energy does not see
    const double length = rho / curvature;
    const Lengths now = go(length);
    if (progress.reached()) {
      move(system, length, direction, x);
      break;
    }
    turn(system, preconditioner, length, now.rho / rho, gradient, direction, x);
    rho = now.rho;
  }
  return std::move(progress).outcome();
}

}  // namespace surpass

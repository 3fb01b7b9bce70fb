#include <cmath>

#include "interpolate/free_system.hpp"

namespace surpass {
namespace {

// The inverse of each diagonal block; 0 where the energy does not see the point.
class Preconditioner {
 public:
  explicit Preconditioner(const FreeSystem& system)
      : system_(system),
        block_(system.energy.block_size()),
        inverse_(system.energy.diagonal(system.context)) {
    parallel::for_ranges(system.context, system.elimination.control_count(),
                         [&](std::size_t begin, std::size_t end) {
                           for (std::size_t j = begin; j < end; ++j) invert(&inverse_[j * block_]);
                         });
  }

  void apply(std::span<const double> r, std::span<double> z) const {
    const std::size_t width = system_.width;
    parallel::for_ranges(system_.context, system_.elimination.control_count(),
                         [&](std::size_t begin, std::size_t end) {
                           for (std::size_t j = begin; j < end; ++j) {
                             const double* d = &inverse_[j * block_];
                             const double* from = &r[j * width];
                             double* to = &z[j * width];
                             if (block_ == 1) {
                               for (std::size_t c = 0; c < width; ++c) to[c] = d[0] * from[c];
                             } else {
                               to[0] = d[0] * from[0] + d[1] * from[1] + d[2] * from[2];
                               to[1] = d[1] * from[0] + d[3] * from[1] + d[4] * from[2];
                               to[2] = d[2] * from[0] + d[4] * from[1] + d[5] * from[2];
                             }
                           }
                         });
  }

 private:
  void invert(double* d) const {
    if (block_ == 1) {
      *d = *d > 0 ? 1 / *d : 0;
      return;
    }
    // A symmetric block of 3; where it is singular or nearly so, its mean diagonal stands in.
    const double a = d[3] * d[5] - d[4] * d[4];
    const double b = d[2] * d[4] - d[1] * d[5];
    const double c = d[1] * d[4] - d[2] * d[3];
    const double determinant = d[0] * a + d[1] * b + d[2] * c;
    const double mean = (d[0] + d[3] + d[5]) / 3;
    constexpr double kFlat = 1e-9;
    if (!(determinant > kFlat * mean * mean * mean)) {
      const double inverse = mean > 0 ? 1 / mean : 0;
      d[0] = d[3] = d[5] = inverse;
      d[1] = d[2] = d[4] = 0;
      return;
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
  }

  const FreeSystem& system_;
  std::size_t block_;
  std::vector<double> inverse_;  // #control points by block
};

// y += factor * x.
void add(const FreeSystem& system, double factor, std::span<const double> x, std::span<double> y) {
  parallel::for_ranges(system.context, x.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) y[i] += factor * x[i];
  });
}

}  // namespace

FreeOutcome conjugate_gradient(const FreeSystem& system, const StopAt& stop,
                               std::span<double> gradient, std::span<double> change) {
  FreeOutcome outcome;
  const double start = std::sqrt(system.dot(gradient, gradient));
  if (start == 0 || stop.max_iterations == 0) return outcome;
  const Preconditioner preconditioner(system);
  std::vector<double> z(system.size());
  std::vector<double> direction(system.size());
  std::vector<double> image(system.size());
  preconditioner.apply(gradient, z);
  for (std::size_t i = 0; i < z.size(); ++i) direction[i] = -z[i];
  double rho = system.dot(gradient, z);
  while (outcome.iterations < stop.max_iterations && rho > 0) {
    if (system.context.cancelled()) {
      outcome.cancelled = true;
      return outcome;
    }
    system.product(direction, image);
    const double curvature = system.dot(direction, image);
    if (!(curvature > 0)) break;  // nothing is left but what the energy does not see
    add(system, rho / curvature, direction, change);
    add(system, rho / curvature, image, gradient);
    ++outcome.iterations;
    const double residual = std::sqrt(system.dot(gradient, gradient)) / start;
    outcome.residuals.push_back(residual);
    system.context.report({.stage = "solve",
                           .fraction = std::min(1.0, std::log(residual) / std::log(stop.tolerance)),
                           .iteration = outcome.iterations,
                           .error = residual});
    if (residual <= stop.tolerance) break;
    preconditioner.apply(gradient, z);
    const double next = system.dot(gradient, z);
    const double share = next / rho;
    parallel::for_ranges(system.context, z.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) direction[i] = share * direction[i] - z[i];
    });
    rho = next;
  }
  return outcome;
}

}  // namespace surpass

#include "interpolate/linear_system.hpp"

#include <algorithm>

namespace surpass {
namespace {

ErrorNorms join(const ErrorNorms& a, const ErrorNorms& b) {
  // Written so that a NaN stays visible.
  return {b.max > a.max || std::isnan(b.max) ? b.max : a.max, a.sum + b.sum};
}

void include_distance(ErrorNorms& norms, double squared) {
  const double distance = std::sqrt(squared);
  if (distance > norms.max || std::isnan(distance)) norms.max = distance;
  norms.sum += distance;
}

// use(index of a value, its row's product) for every value of row v.
template <class Use>
void for_row(const LinearSystem& s, Index v, const double* x, Use&& use) {
  s.op.rows.row_times(v, s.width, x,
                      [&](std::size_t c, double product) { use(v * s.width + c, product); });
}

}  // namespace

ErrorNorms LinearSystem::residual(std::span<const double> x, std::span<double> r) const {
  return parallel::reduce(
      context, block.vertices.size(), ErrorNorms{},
      [&](std::size_t begin, std::size_t end) {
        ErrorNorms norms;
        for (std::size_t i = begin; i < end; ++i) {
          double squared = 0;
          for_row(*this, block.vertices[i], x.data(), [&](std::size_t at, double product) {
            r[at] = target[at] - product;
            squared += (r[at] * scale) * (r[at] * scale);
          });
          include_distance(norms, squared);
        }
        return norms;
      },
      join);
}

ErrorNorms LinearSystem::block_norms(std::span<const double> r) const {
  return parallel::reduce(
      context, block.vertices.size(), ErrorNorms{},
      [&](std::size_t begin, std::size_t end) {
        ErrorNorms norms;
        for (std::size_t i = begin; i < end; ++i) {
          double squared = 0;
          for (std::size_t c = 0; c < width; ++c) {
            const double value = r[block.vertices[i] * width + c] * scale;
            squared += value * value;
          }
          include_distance(norms, squared);
        }
        return norms;
      },
      join);
}

void LinearSystem::product(std::span<const double> p, std::span<double> y) const {
  parallel::for_ranges(context, block.vertices.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for_row(*this, block.vertices[i], p.data(),
              [&](std::size_t at, double product) { y[at] = product; });
    }
  });
}

ErrorNorms LinearSystem::sweep(std::span<const double> x, std::span<double> previous,
                               double momentum, double step, bool measure) const {
  return parallel::reduce(
      context, block.vertices.size(), ErrorNorms{},
      [&](std::size_t begin, std::size_t end) {
        ErrorNorms norms;
        for (std::size_t i = begin; i < end; ++i) {
          double squared = 0;
          for_row(*this, block.vertices[i], x.data(), [&](std::size_t at, double product) {
            const double r = target[at] - product;
            previous[at] = x[at] + momentum * (x[at] - previous[at]) + step * r;
            squared += (r * scale) * (r * scale);
          });
          if (measure) include_distance(norms, squared);
        }
        return norms;
      },
      join);
}

std::vector<double> LinearSystem::dot(std::span<const double> a, std::span<const double> b,
                                      const std::vector<double>* weights) const {
  return parallel::reduce(
      context, block.vertices.size(), std::vector<double>(width, 0.0),
      [&](std::size_t begin, std::size_t end) {
        std::vector<double> sums(width, 0.0);
        for (std::size_t i = begin; i < end; ++i) {
          const Index v = block.vertices[i];
          const double weight = weights != nullptr ? (*weights)[v] : 1.0;
          for (std::size_t c = 0; c < width; ++c) {
            const std::size_t at = v * width + c;
            sums[c] += weight * (a[at] * scale) * (b[at] * scale);
          }
        }
        return sums;
      },
      [](std::vector<double> sum, const std::vector<double>& part) {
        for (std::size_t c = 0; c < part.size(); ++c) sum[c] += part[c];
        return sum;
      });
}

double power_of_two_scale(double unit) {
  int exponent = 0;
  std::frexp(unit, &exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
}

}  // namespace surpass

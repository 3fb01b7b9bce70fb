// What the free control points are to make small: a sum over the derivatives sampled on every
// patch.
#pragma once

#include <surpass/similarity.hpp>

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "interpolate/patch_layout.hpp"

namespace surpass {

/// `single`: less exact, where that is faster. What is lost is about 1e-7 of the largest of the
/// numbers that were added up for a point.
enum class Precision { full, single };

/// A quadratic form x'Hx over control points, H symmetric and not negative. Applied without being
/// assembled; arrays are #control points by width.
class PatchEnergy {
 public:
  PatchEnergy() = default;
  PatchEnergy(const PatchEnergy&) = delete;
  PatchEnergy& operator=(const PatchEnergy&) = delete;
  virtual ~PatchEnergy() = default;

  /// y = H x; back comes x'Hx, the sum over all columns.
  virtual double product(const Context& context, std::size_t width, Precision precision,
                         std::span<const double> x, std::span<double> y) const = 0;
  /// Numbers a diagonal block has: 1, the same for every right-hand side, or 6, the upper triangle
  /// of a 3 by 3 block, row after row (width is 3 then).
  [[nodiscard]] virtual std::size_t block_size() const = 0;
  /// #control points by block_size().
  [[nodiscard]] virtual std::vector<double> diagonal(const Context& context) const = 0;
  /// The same in single precision; empty where that is not good enough.
  [[nodiscard]] virtual std::vector<float> diagonal_in_single(const Context& /*context*/) const {
    return {};
  }
  /// Adds the patch's part of H: use(a, b, block) for each pair of its columns, of which it is
  /// given the control points, with block_size() numbers; not for pairs that have nothing in
  /// common. For solvers that need H assembled.
  using UseBlock = std::function<void(std::size_t a, std::size_t b, const double* block)>;
  virtual void for_blocks(std::size_t patch, std::span<const Index> columns,
                          const UseBlock& use) const = 0;
};

/// Weight of a row in a sum of squares |row x|^2.
using RowWeight = double (*)(const PatchKind& kind, std::size_t row, double thin_plate,
                             double membrane);

/// sum over rows of count |row x|^2 over the first, second and third derivatives.
[[nodiscard]] double vectors_weight(const PatchKind& kind, std::size_t row, double, double);
/// Thin plate and membrane, each sample times the area that it stands for.
[[nodiscard]] double fair_weight(const PatchKind& kind, std::size_t row, double thin_plate,
                                 double membrane);

/// The same for every right-hand side; depends on the topology alone. `layout` must outlive it.
[[nodiscard]] std::unique_ptr<PatchEnergy> sum_of_squares(const PatchLayout& layout,
                                                          RowWeight weight, double thin_plate,
                                                          double membrane);

/// sum over rows of w count |g x row x|^2, g = row * reference. `layout` and `reference` (#control
/// points by 3) must outlive it.
[[nodiscard]] std::unique_ptr<PatchEnergy> cross_products(const PatchLayout& layout,
                                                          std::span<const double> reference,
                                                          RowWeights weights,
                                                          const Context& context);

}  // namespace surpass

// The points as the steps of reconstruction see them, and what is measured of them.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>

#include <optional>
#include <span>
#include <vector>

#include "reconstruct/neighbours.hpp"

namespace surpass::reconstruction {

/// The functions below fail with `cancelled` only, unless they say more.

/// Finite, different points, moved into a box of side 1, with their numbers among the given ones.
struct Cloud {
  std::vector<Point> points;
  std::vector<Index> source;
  std::size_t not_finite = 0;
  std::size_t duplicates = 0;
  double box_side = 0;
};

/// Errors: the box overflows; fewer than four points are left.
[[nodiscard]] Result<Cloud> clean(std::span<const Point> given);

/// The chosen points of the cloud, in their order.
[[nodiscard]] Cloud subset(const Cloud& cloud, const std::vector<unsigned char>& keep);

/// The median over the points of the mean distance to six neighbours.
[[nodiscard]] Result<double> spacing_of(const Cloud& cloud, const Neighbours& neighbours,
                                        const Context& context);

/// Measured at some thousand points spread over the cloud; lengths in spacings. Nothing is found in
/// clouds of fewer than 180 points.
struct Roughness {
  /// Median deviation from the local quadric of a point's own sheet. Absent where no sheet has
  /// enough points near each other.
  std::optional<double> noise;
  double share_of_sheets = 0;       ///< of the points that have a second sheet near them
  std::optional<double> sheet_gap;  ///< median distance to it, where two sheets are that near
};
[[nodiscard]] Result<Roughness> roughness_of(const Cloud& cloud, const Neighbours& neighbours,
                                             double spacing, const Context& context);

/// 1 for the points that stand alone, 0 for others (#points). With `always` false, all 0 unless
/// some points stand so far off that no even sampling explains them, and unless fewer than a tenth
/// would be left out.
[[nodiscard]] Result<std::vector<unsigned char>> find_outliers(const Cloud& cloud,
                                                               const Neighbours& neighbours,
                                                               double spacing, bool always,
                                                               const Context& context);

/// Every point moved to the quadric through its 24 neighbours, `passes` times over.
[[nodiscard]] Result<std::vector<Point>> smooth(const Cloud& cloud, unsigned passes,
                                                const Context& context);

}  // namespace surpass::reconstruction

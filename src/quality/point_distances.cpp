#include <surpass/quality.hpp>
#include <surpass/repair.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "mesh/refusals.hpp"
#include "parallel/parallel.hpp"
#include "quality/triangle_tree.hpp"

namespace surpass {
namespace {

bool is_finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

Result<void> check_surface(const Mesh& surface) {
  if (surface.face_count() == 0) {
    return fail(ErrorCode::empty_mesh, "there are no faces, so there is no surface to measure to");
  }
  return refusal::check_measurable(surface);
}

// The lower 21 bits, each at three times its place.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32U) & 0x1f00000000ffffU;
  x = (x | x << 16U) & 0x1f0000ff0000ffU;
  x = (x | x << 8U) & 0x100f00f00f00f00fU;
  x = (x | x << 4U) & 0x10c30c30c30c30c3U;
  return (x | x << 2U) & 0x1249249249249249U;
}

// A box of side 1 around the surface, where nothing overflows.
struct UnitBox {
  Point origin = {};
  double unit = 1;
  [[nodiscard]] Eigen::Vector3d in(const Point& p) const {
    return {(p[0] - origin[0]) / unit, (p[1] - origin[1]) / unit, (p[2] - origin[2]) / unit};
  }
};

TriangleTree unit_tree(const Mesh& surface, const UnitBox& unit_box) {
  std::vector<SolidTriangle> triangles;
  const auto add = [&](const Mesh& mesh) {
    triangles.reserve(mesh.face_count());
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      triangles.emplace_back(unit_box.in(mesh.points[face[0]]), unit_box.in(mesh.points[face[1]]),
                             unit_box.in(mesh.points[face[2]]));
    }
  };
  if (all_triangles(surface)) {
    add(surface);
  } else {
    add(triangulate(surface).mesh);
  }
  return TriangleTree(std::move(triangles));
}

// Numbers of the finite points, neighbours near each other: along G. Morton's curve (A computer
// oriented geodetic data base, 1966). The nearest triangle of one is then a good guess for the
// next, which saves most of the search.
std::vector<std::size_t> near_each_other(std::span<const Point> points) {
  constexpr double kCells = 1 << 21;  // along a side: 63 bits in all
  std::vector<Point> finite;
  for (const Point& p : points) {
    if (is_finite(p)) finite.push_back(p);
  }
  const Box box = bounding_box(finite);
  const double side = box.side() > 0 ? box.side() : 1;
  std::vector<std::pair<std::uint64_t, std::size_t>> keys;
  keys.reserve(finite.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) continue;
    std::uint64_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double cell = (points[i][k] / side - box.low[k] / side) * (kCells - 1);
      key |= spread(static_cast<std::uint64_t>(std::clamp(cell, 0.0, kCells - 1))) << k;
    }
    keys.emplace_back(key, i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> order;
  order.reserve(keys.size());
  for (const auto& [key, i] : keys) order.push_back(i);
  return order;
}

constexpr std::size_t kBlock = 16384;  // some ten milliseconds of work between looks at `cancel`
constexpr std::size_t kChunk = 256;

}  // namespace

Result<std::vector<double>> distances_to(std::span<const Point> points, const Mesh& surface,
                                         const Context& context) {
  if (auto checked = check_surface(surface); !checked) return tl::make_unexpected(checked.error());
  const Box box = bounding_box(surface.points);
  const UnitBox unit_box = {box.low, box.side() > 0 ? box.side() : 1};
  const TriangleTree tree = unit_tree(surface, unit_box);
  std::vector<double> distances(points.size(), std::nan(""));
  const std::vector<std::size_t> order = near_each_other(points);
  for (std::size_t first = 0; first < order.size(); first += kBlock) {
    if (context.cancelled()) return fail(ErrorCode::cancelled, "the measurement was interrupted");
    const double share = static_cast<double>(first) / static_cast<double>(order.size());
    context.report({.stage = "distances", .fraction = share});
    const auto measure = [&](std::size_t begin, std::size_t end) {
      Index guess = 0;
      for (std::size_t k = first + begin; k < first + end; ++k) {
        const std::size_t i = order[k];
        const Sample nearest = tree.nearest(unit_box.in(points[i]), guess);
        distances[i] = nearest.distance * unit_box.unit;
        guess = nearest.triangle;
      }
    };
    parallel::for_ranges(context, std::min(kBlock, order.size() - first), measure, kChunk);
  }
  return distances;
}

PointDistances summary_of(std::span<const double> distances) {
  PointDistances found;
  std::vector<double> finite;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (std::isnan(distances[i])) continue;
    if (finite.empty() || distances[i] > found.max) {
      found.max = distances[i];
      found.farthest = static_cast<Index>(i);
    }
    finite.push_back(distances[i]);
  }
  found.count = finite.size();
  if (finite.empty()) return found;
  // Relative to the largest, so that no square is too large or too small.
  const double unit = found.max > 0 ? found.max : 1;
  double sum = 0;
  double sum_of_squares = 0;
  for (const double d : finite) {
    sum += d / unit;
    sum_of_squares += d / unit * (d / unit);
  }
  const auto count = static_cast<double>(finite.size());
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.99 * count)) - 1;
  std::nth_element(finite.begin(), finite.begin() + rank, finite.end());
  found.percentile99 = finite[static_cast<std::size_t>(rank)];
  found.mean = sum / count * unit;
  found.rms = std::sqrt(sum_of_squares / count) * unit;
  return found;
}

Result<PointDistances> point_distances(std::span<const Point> points, const Mesh& surface,
                                       const Context& context) {
  const auto distances = distances_to(points, surface, context);
  if (!distances) return tl::make_unexpected(distances.error());
  const PointDistances found = summary_of(*distances);
  if (found.count == 0) return fail(ErrorCode::empty_mesh, "there is no finite point to measure");
  return found;
}

}  // namespace surpass

#include <surpass/reconstruct.hpp>

#include <algorithm>
#include <cmath>

namespace surpass {
namespace {

constexpr double kMostTriangles = 800000;
constexpr int kMostLevels = 3;  // chords of an eighth of an edge

// Triangles of the limit mesh, about: each of the schemes makes four faces of one, from quads where
// faces were no triangles before.
double triangles_at(const Mesh& control, const Rules& rules, int levels) {
  const bool stays_triangular = rules.scheme == Scheme::loop;
  const double first = stays_triangular ? 4.0 * control.face_count() : 2.0 * control.corner_count();
  return first * std::pow(4.0, levels - 1);
}

int affordable_levels(const Mesh& control, const Rules& rules) {
  int levels = 0;
  while (levels < kMostLevels && triangles_at(control, rules, levels + 1) <= kMostTriangles) {
    ++levels;
  }
  return levels;
}

Result<Mesh> surface_at(const Mesh& control, const Rules& rules, int levels,
                        const Context& context) {
  if (levels > 0) return limit_mesh(control, rules, levels, context);
  Result<std::vector<Point>> limit = limit_positions(control, rules, context);
  if (!limit) return tl::make_unexpected(limit.error());
  Mesh mesh = control;
  mesh.points = std::move(*limit);
  return mesh;
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

Result<LimitDistances> limit_distances(std::span<const Point> points, std::span<const Index> source,
                                       std::span<const Index> unused, const Mesh& control,
                                       const Rules& rules, const Context& context) {
  LimitDistances found;
  std::vector<double> distances(points.size(), std::nan(""));
  const auto limit = limit_positions(control, rules, context);
  if (!limit) return tl::make_unexpected(limit.error());
  for (std::size_t v = 0; v < source.size(); ++v) {
    distances[source[v]] = distance(points[source[v]], (*limit)[v]);
  }
  std::vector<Point> others;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isnan(distances[i])) continue;
    others.push_back(points[i]);
    numbers.push_back(i);
  }
  if (!others.empty()) {
    found.levels = affordable_levels(control, rules);
    const auto surface = surface_at(control, rules, found.levels, context);
    if (!surface) return tl::make_unexpected(surface.error());
    const auto measured = distances_to(others, *surface, context);
    if (!measured) return tl::make_unexpected(measured.error());
    for (std::size_t k = 0; k < numbers.size(); ++k) distances[numbers[k]] = (*measured)[k];
    if (found.levels > 0) {
      const auto coarser = surface_at(control, rules, found.levels - 1, context);
      if (!coarser) return tl::make_unexpected(coarser.error());
      const auto between = point_distances(surface->points, *coarser, context);
      if (!between) return tl::make_unexpected(between.error());
      // Chords of a curved surface are off by the square of their length: a quarter at each level,
      // so what is left is a third of the last step.
      found.sampling = between->max / 3;
    }
  }
  found.all = summary_of(distances);
  for (const Index i : unused) distances[i] = std::nan("");
  found.used = summary_of(distances);
  return found;
}

}  // namespace surpass

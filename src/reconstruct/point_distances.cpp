#include "reconstruct/point_distances.hpp"

#include <surpass/repair.hpp>

#include <algorithm>
#include <cmath>

#include "mesh/refusals.hpp"
#include "quality/triangle_tree.hpp"
#include "reconstruct/point_loop.hpp"

namespace surpass {
namespace {

bool is_finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

Result<void> check(const Mesh& surface) {
  if (surface.face_count() == 0) {
    return fail(ErrorCode::empty_mesh, "there are no faces, so there is no surface to measure to");
  }
  for (Index f = 0; f < surface.face_count(); ++f) {
    if (surface.face(f).size() < 3) {
      return tl::make_unexpected(refusal::degenerate_face(f, surface.face(f).size()));
    }
    for (const Index v : surface.face(f)) {
      if (v >= surface.points.size()) {
        return tl::make_unexpected(refusal::index_out_of_range(f, v, surface.points.size()));
      }
      if (!is_finite(surface.points[v])) {
        return tl::make_unexpected(refusal::not_finite(v, surface.points[v]));
      }
    }
  }
  return {};
}

// A box of side 1 around the surface, where nothing overflows.
struct Frame {
  Point origin = {};
  double unit = 1;
  [[nodiscard]] Eigen::Vector3d in(const Point& p) const {
    return {(p[0] - origin[0]) / unit, (p[1] - origin[1]) / unit, (p[2] - origin[2]) / unit};
  }
};

TriangleTree tree_of(const Mesh& surface, const Frame& frame) {
  std::vector<SolidTriangle> triangles;
  const auto add = [&](const Mesh& mesh) {
    triangles.reserve(mesh.face_count());
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      triangles.emplace_back(frame.in(mesh.points[face[0]]), frame.in(mesh.points[face[1]]),
                             frame.in(mesh.points[face[2]]));
    }
  };
  if (all_triangles(surface)) {
    add(surface);
  } else {
    add(triangulate(surface).mesh);
  }
  return TriangleTree(std::move(triangles));
}

}  // namespace

namespace reconstruction {

Result<std::vector<double>> distances_to(std::span<const Point> points, const Mesh& surface,
                                         const Context& context) {
  if (auto checked = check(surface); !checked) return tl::make_unexpected(checked.error());
  const Box box = bounding_box(surface.points);
  const Frame frame = {box.low, box.side() > 0 ? box.side() : 1};
  const TriangleTree tree = tree_of(surface, frame);
  std::vector<double> distances(points.size(), std::nan(""));
  const auto done =
      for_points(context, "distances", points.size(), [&](std::size_t begin, std::size_t end) {
        Index guess = 0;
        for (std::size_t i = begin; i < end; ++i) {
          if (!is_finite(points[i])) continue;
          const Sample nearest = tree.nearest(frame.in(points[i]), guess);
          distances[i] = nearest.distance * frame.unit;
          guess = nearest.triangle;
        }
      });
  if (!done) return tl::make_unexpected(done.error());
  return distances;
}

PointDistances summary(const std::vector<double>& distances) {
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

}  // namespace reconstruction

Result<PointDistances> point_distances(std::span<const Point> points, const Mesh& surface,
                                       const Context& context) {
  const auto distances = reconstruction::distances_to(points, surface, context);
  if (!distances) return tl::make_unexpected(distances.error());
  const PointDistances found = reconstruction::summary(*distances);
  if (found.count == 0) return fail(ErrorCode::empty_mesh, "there is no finite point to measure");
  return found;
}

}  // namespace surpass

// Where the smooth curve of a boundary or crease would turn the surface over.
//
// The curve passes through its vertices, so after the first step it lies beyond them: at the end of
// a slit, or where faces are crumpled, further than the points inside. The surface is folded there,
// and its normal is on the other side of the faces. Loop's curve only comes near its vertices and
// does not fold. A corner leaves along its edges and does not, either.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mesh/select.hpp"
#include "mesh/wording.hpp"
#include "scheme/nonstationary_impl.hpp"

namespace surpass {
namespace {

/// The faces at curves, which are all that decides their normals.
Selection around_curves(const Mesh& mesh, const Topology& topology, const Sharpness& sharpness) {
  const auto on_curve = [&](Index v) { return !topology.is_isolated(v) && !sharpness.is_plain(v); };
  std::vector<Index> faces;
  std::vector<unsigned char> used(mesh.vertex_count(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (std::none_of(face.begin(), face.end(), on_curve)) continue;
    faces.push_back(f);
    for (const Index v : face) used[v] = 1;
  }
  Selection selection = Selection::of_vertices(used);
  for (const Index f : faces) selection.add_face(mesh, f);
  return selection;
}

/// The sum of the faces' area vectors, or zero where these cancel.
Point area_vector(const Mesh& mesh, const Topology& topology, Index v) {
  Point sum = {};
  double whole = 0;
  topology.for_each_outgoing(v, [&](Index h) {
    const Point& p = mesh.points[v];
    const Point& a = mesh.points[topology.head(h)];
    const Point& b = mesh.points[topology.tail(topology.previous(h))];
    Point twice = {};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t d = (c + 1) % 3;
      const std::size_t e = (c + 2) % 3;
      twice[c] = (a[d] - p[d]) * (b[e] - p[e]) - (a[e] - p[e]) * (b[d] - p[d]);
      sum[c] += twice[c];
    }
    whole += std::hypot(twice[0], twice[1], twice[2]);
  });
  constexpr double kSmall = 1e-12;
  return std::hypot(sum[0], sum[1], sum[2]) > kSmall * whole ? sum : Point{};
}

}  // namespace

Result<std::vector<Index>> NonstationaryLoop::Impl::folds(const Neighbourhood& around,
                                                          const Context& context) const {
  const auto& [topology, sharpness] = around;
  const Selection chosen = around_curves(mesh, topology, sharpness);
  Impl part;
  part.state = state;
  part.first_step_is_its_own = true;
  part.mesh = select(mesh, chosen);
  part.mesh.channels.clear();
  part.state.vertices.assign(part.mesh.points.size(), state.options.shape);
  const auto found = part.at_limit(part.mesh, true, context);
  if (!found) return tl::make_unexpected(found.error());

  std::vector<Index> folded;
  for (std::size_t i = 0; i < chosen.vertex_source.size(); ++i) {
    const Index v = chosen.vertex_source[i];
    if (sharpness.is_plain(v) || topology.is_isolated(v) ||
        Ring::around(topology, sharpness, v).rule() != VertexRule::crease) {
      continue;
    }
    const Point area = area_vector(mesh, topology, v);
    const Point& normal = found->normals[i];
    if (normal[0] * area[0] + normal[1] * area[1] + normal[2] * area[2] < 0) folded.push_back(v);
  }
  return folded;
}

Result<void> NonstationaryLoop::Impl::make_corners_at_folds(Neighbourhood& around,
                                                            const Context& context) {
  std::vector<Index> corners;
  for (;;) {
    // A corner bends the curve beside it, which may fold in its turn.
    const auto more = folds(around, context);
    if (!more) return tl::make_unexpected(more.error());
    if (more->empty()) break;
    for (const Index v : *more) mesh.corners.push_back({v, kInfinitelySharp});
    auto sharpness = Sharpness::build(mesh, around.topology, state.options.boundary);
    if (!sharpness) return tl::make_unexpected(sharpness.error());
    around.sharpness = std::move(*sharpness);
    corners.insert(corners.end(), more->begin(), more->end());
  }
  if (corners.empty()) return {};
  std::sort(corners.begin(), corners.end());
  constexpr std::size_t kMostNamed = 8;
  std::vector<std::string> names;
  for (const Index v : corners) {
    names.push_back(names.size() < kMostNamed ? std::to_string(v) : "...");
    if (names.size() > kMostNamed) break;
  }
  notes.push_back(fmt::format(
      "{} on boundaries or creases became {}, as the smooth curve would turn the surface over "
      "there: {}",
      counted(corners.size(), "vertex", "vertices"), corners.size() == 1 ? "a corner" : "corners",
      joined(names, ", ")));
  return {};
}

}  // namespace surpass

#include "render/display_mesh.hpp"

#include <surpass/repair.hpp>

#include <algorithm>
#include <numeric>

#include "render/corner_normals.hpp"

namespace surpass::picture {
namespace {

// A corner channel whose rows are the corners themselves: after cutting, each triangle's corner
// names the polygon corner that it was.
Mesh numbered_corners(const Mesh& mesh) {
  Mesh numbered;
  numbered.points = mesh.points;
  numbered.face_offsets = mesh.face_offsets;
  numbered.face_vertices = mesh.face_vertices;
  numbered.hole_faces = mesh.hole_faces;
  CornerChannel& corner = numbered.corner_channels.emplace_back();
  corner.name = "corner";
  corner.width = 1;
  corner.values.assign(mesh.corner_count(), 0);
  corner.indices.resize(mesh.corner_count());
  std::iota(corner.indices.begin(), corner.indices.end(), Index{0});
  return numbered;
}

// The corner after each corner in its polygon.
std::vector<Index> next_corners(const Mesh& mesh) {
  std::vector<Index> next(mesh.corner_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index begin = mesh.face_offsets[f];
    const Index end = mesh.face_offsets[f + 1];
    for (Index c = begin; c < end; ++c) next[c] = c + 1 == end ? begin : c + 1;
  }
  return next;
}

std::vector<Triangle> cut_into_triangles(const Mesh& mesh) {
  Mesh cut = numbered_corners(mesh);
  if (!all_triangles(mesh)) cut = triangulate(cut).mesh;
  const std::vector<Index>& corner = cut.corner_channels.front().indices;
  const std::vector<Index> next = next_corners(mesh);
  std::vector<Triangle> triangles;
  triangles.reserve(cut.face_count());
  for (Index f = 0; f < cut.face_count(); ++f) {
    if (std::binary_search(cut.hole_faces.begin(), cut.hole_faces.end(), f)) continue;
    Triangle& t = triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      t.vertices[k] = cut.face_vertices[cut.face_offsets[f] + k];
      t.corners[k] = corner[cut.face_offsets[f] + k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      t.own_side[k] = next[t.corners[k]] == t.corners[(k + 1) % 3];
    }
  }
  return triangles;
}

// What Topology refuses although it can be drawn.
bool drawable(ErrorCode code) {
  return code == ErrorCode::non_manifold_edge || code == ErrorCode::inconsistent_orientation ||
         code == ErrorCode::repeated_vertex;
}

Result<void> check_positions(const Mesh& mesh) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!to_vector(mesh.points[v]).allFinite()) {
      return fail(ErrorCode::not_finite,
                  "a position is infinite or not a number: nothing can be "
                  "drawn until it is mended",
                  {.vertex = v});
    }
  }
  return {};
}

Result<std::vector<Vec3>> shading_normals(const Mesh& mesh, const RenderOptions& options,
                                          const Context& context) {
  const auto topology = Topology::build(mesh);
  if (!topology && !drawable(topology.error().code)) return tl::make_unexpected(topology.error());
  if (!topology || !options.smooth) return facet_normals(mesh, context);
  return smooth_normals(mesh, *topology, options.crease_angle, context);
}

}  // namespace

Result<DisplayMesh> make_display_mesh(const Mesh& mesh, const RenderOptions& options,
                                      const Context& context) {
  if (auto checked = check_positions(mesh); !checked) return tl::make_unexpected(checked.error());
  auto normals = shading_normals(mesh, options, context);
  if (!normals) return tl::make_unexpected(normals.error());
  DisplayMesh display{cut_into_triangles(mesh), std::move(*normals)};
  const bool is_cloud = mesh.face_count() == 0 && !mesh.points.empty();
  if (display.triangles.empty() && !is_cloud) {
    return fail(ErrorCode::empty_mesh, mesh.face_count() == 0
                                           ? "there are neither faces nor points to draw"
                                           : "every face is a hole: nothing can be drawn");
  }
  return display;
}

std::vector<Point> drawn_points(const Mesh& mesh, const DisplayMesh& display) {
  if (display.triangles.empty()) return mesh.points;
  std::vector<bool> drawn(mesh.vertex_count());
  for (const Triangle& triangle : display.triangles) {
    for (const Index v : triangle.vertices) drawn[v] = true;
  }
  std::vector<Point> points;
  points.reserve(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (drawn[v]) points.push_back(mesh.points[v]);
  }
  return points;
}

}  // namespace surpass::picture

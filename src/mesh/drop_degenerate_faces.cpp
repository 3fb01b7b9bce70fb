#include <algorithm>

#include "mesh/repair_steps.hpp"
#include "mesh/select.hpp"
#include "mesh/wording.hpp"

namespace surpass::repair_step {
namespace {

// The corners of a face that do not repeat the vertex of the corner before, around its cycle.
void keep_changes(const Mesh& mesh, Index face, std::vector<Index>& kept) {
  kept.clear();
  const auto vertices = mesh.face(face);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i == 0 || vertices[i] != vertices[i - 1]) {
      kept.push_back(mesh.face_offsets[face] + static_cast<Index>(i));
    }
  }
  const auto vertex = [&](Index corner) { return mesh.face_vertices[corner]; };
  while (kept.size() > 1 && vertex(kept.back()) == vertex(kept.front())) kept.pop_back();
}

// Three different vertices, given that no two consecutive ones are equal: true if some vertex
// differs from the first two.
bool has_three_vertices(const Mesh& mesh, const std::vector<Index>& corners) {
  return std::any_of(corners.begin(), corners.end(), [&](Index c) {
    return mesh.face_vertices[c] != mesh.face_vertices[corners[0]] &&
           mesh.face_vertices[c] != mesh.face_vertices[corners[1]];
  });
}

}  // namespace

void drop_degenerate_faces(Mended& mended) {
  const Mesh& mesh = mended.mesh;
  Selection s = Selection::of_all_vertices(mesh);
  std::size_t degenerate = 0;
  std::size_t out_of_range = 0;
  std::vector<Index> kept;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto vertices = mesh.face(f);
    if (std::any_of(vertices.begin(), vertices.end(),
                    [&](Index v) { return v >= mesh.points.size(); })) {
      ++out_of_range;
      continue;
    }
    keep_changes(mesh, f, kept);
    if (kept.size() < 3 || !has_three_vertices(mesh, kept)) {
      ++degenerate;
      continue;
    }
    for (const Index corner : kept) s.add_corner(mesh, corner);
    s.end_face(f);
  }
  const std::size_t kept_corners = s.corner_source.size();
  std::size_t corners_of_kept_faces = 0;
  for (const Index f : s.face_source) corners_of_kept_faces += mesh.face(f).size();
  if (out_of_range > 0) {
    mended.done.push_back(fmt::format("dropped {} naming vertices that do not exist",
                                      counted(out_of_range, "face", "faces")));
  }
  if (degenerate > 0) {
    mended.done.push_back(fmt::format("dropped {} with fewer than three different vertices",
                                      counted(degenerate, "face", "faces")));
  }
  if (corners_of_kept_faces > kept_corners) {
    mended.done.push_back(
        fmt::format("dropped {} on the same vertex as the corner before",
                    counted(corners_of_kept_faces - kept_corners, "face corner", "face corners")));
  }
  if (kept_corners < mesh.face_vertices.size() || degenerate > 0) {
    mended.mesh = select(mesh, std::move(s));
  }
}

}  // namespace surpass::repair_step

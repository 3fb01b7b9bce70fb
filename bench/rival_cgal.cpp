// CGAL: polygon soups, which hold as little connectivity as our meshes, and Surface_mesh.
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "contenders.hpp"
#include "judges.hpp"

namespace surpass::bench {
namespace {

using Position = CGAL::Simple_cartesian<double>::Point_3;
using Halfedges = CGAL::Surface_mesh<Position>;

struct Soup {
  std::vector<Position> points;
  std::vector<std::vector<std::size_t>> faces;
};

Halfedges build(const Mesh& mesh) {
  using Size = Halfedges::size_type;
  Halfedges out;
  out.reserve(static_cast<Size>(mesh.points.size()), static_cast<Size>(3 * mesh.points.size()),
              mesh.face_count());
  for (const Point& p : mesh.points) out.add_vertex({p[0], p[1], p[2]});
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    out.add_face(Halfedges::Vertex_index(face[0]), Halfedges::Vertex_index(face[1]),
                 Halfedges::Vertex_index(face[2]));
  }
  return out;
}

Soup read(const std::string& path) {
  Soup soup;
  CGAL::IO::read_polygon_soup(path, soup.points, soup.faces);
  return soup;
}

Verdict judge_connectivity(const Workload& workload, const Halfedges& mesh) {
  std::vector<Index> valences;
  for (const auto v : mesh.vertices()) valences.push_back(static_cast<Index>(mesh.degree(v)));
  return judge_valences(workload, valences);
}

Verdict judge_soup(const Workload& workload, const Soup& soup) {
  std::vector<Point> points;
  for (const Position& p : soup.points) points.push_back({p.x(), p.y(), p.z()});
  std::vector<Index> corners;
  for (const auto& face : soup.faces) {
    for (const std::size_t v : face) corners.push_back(static_cast<Index>(v));
  }
  return judge_file(workload, points, corners, Precision::doubles);
}

}  // namespace

void add_cgal(Harness& harness, Index side) {
  harness.add(
      {.step = "topology",
       .tool = "CGAL",
       .counted = "Surface_mesh: reserve, add_vertex and add_face"},
      side, [](const Workload& w) { return [&mesh = w.mesh()] { return build(mesh); }; },
      judge_connectivity);
  harness.add(
      {.step = "read OBJ", .tool = "CGAL", .counted = "IO::read_polygon_soup", .slow = true}, side,
      [](const Workload& w) { return [path = w.obj()] { return read(path); }; }, judge_soup);
  harness.add(
      {.step = "read PLY", .tool = "CGAL", .counted = "IO::read_polygon_soup", .slow = true}, side,
      [](const Workload& w) { return [path = w.ply()] { return read(path); }; }, judge_soup);
}

}  // namespace surpass::bench

// CGAL's subdivision methods, which change a Surface_mesh in place.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include "refinement.hpp"

namespace surpass::bench {
namespace {

using Position = CGAL::Simple_cartesian<double>::Point_3;
using Halfedges = CGAL::Surface_mesh<Position>;

Halfedges build(const Mesh& mesh) {
  Halfedges out;
  std::vector<Halfedges::Vertex_index> face;
  for (const Point& p : mesh.points) out.add_vertex({p[0], p[1], p[2]});
  for (Index f = 0; f < mesh.face_count(); ++f) {
    face.clear();
    for (const Index v : mesh.face(f)) face.emplace_back(v);
    out.add_face(face);
  }
  return out;
}

RefinedFaces faces_of(const Halfedges& mesh, Index size) {
  RefinedFaces faces{.size = size};
  for (const auto v : mesh.vertices()) {
    const Position& p = mesh.point(v);
    faces.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : mesh.faces()) {
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh)) faces.corners.push_back(v);
  }
  return faces;
}

Halfedges refined(Halfedges mesh, Scheme scheme) {
  const auto once = CGAL::parameters::number_of_iterations(1);
  if (scheme == Scheme::loop) {
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, once);
  } else {
    CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh, once);
  }
  return mesh;
}

}  // namespace

void add_cgal_refinement(Harness& harness, Index side) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    harness.add(
        {.step = step_name("refine", scheme),
         .tool = "CGAL",
         .counted = "Loop_subdivision or CatmullClark_subdivision on a copy of the "
                    "Surface_mesh; building its connectivity is not counted",
         .slow = true},
        side,
        [scheme](const Workload& w) {
          return [base = build(given(w, scheme)), scheme] { return refined(base, scheme); };
        },
        [scheme](const Workload& w, const Halfedges& mesh) {
          return judge_refined(w, scheme, faces_of(mesh, scheme == Scheme::loop ? 3 : 4),
                               Agreement::doubles);
        });
  }
}

}  // namespace surpass::bench

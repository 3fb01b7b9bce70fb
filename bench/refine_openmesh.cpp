// OpenMesh's subdividers, which change a mesh in place.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include "refinement.hpp"

namespace surpass::bench {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using Triangles = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Polygons = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

template <class Halfedges>
Halfedges build(const Mesh& mesh) {
  Halfedges out;
  std::vector<OpenMesh::VertexHandle> face;
  for (const Point& p : mesh.points) out.add_vertex({p[0], p[1], p[2]});
  for (Index f = 0; f < mesh.face_count(); ++f) {
    face.clear();
    for (const Index v : mesh.face(f)) face.emplace_back(static_cast<int>(v));
    out.add_face(face);
  }
  return out;
}

template <class Halfedges>
RefinedFaces faces_of(const Halfedges& mesh, Index size) {
  RefinedFaces faces{.size = size};
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    faces.points.push_back({p[0], p[1], p[2]});
  }
  for (const auto f : mesh.faces()) {
    for (const auto v : mesh.fv_range(f)) faces.corners.push_back(static_cast<Index>(v.idx()));
  }
  return faces;
}

template <class Halfedges, template <class, class> class Subdivider>
void add(Harness& harness, Index side, Scheme scheme, const char* counted) {
  harness.add(
      {.step = step_name("refine", scheme), .tool = "OpenMesh", .counted = counted, .slow = true},
      side,
      [scheme](const Workload& w) {
        return [base = build<Halfedges>(given(w, scheme))] {
          Halfedges mesh = base;
          Subdivider<Halfedges, double>()(mesh, 1);
          return mesh;
        };
      },
      [scheme](const Workload& w, const Halfedges& refined) {
        return judge_refined(w, scheme, faces_of(refined, scheme == Scheme::loop ? 3 : 4),
                             Agreement::float_weights);
      });
}

}  // namespace

void add_openmesh_refinement(Harness& harness, Index side) {
  using namespace OpenMesh::Subdivider::Uniform;
  add<Triangles, LoopT>(harness, side, Scheme::loop,
                        "LoopT on a copy of the mesh; building its connectivity is not counted");
  add<Polygons, CatmullClarkT>(
      harness, side, Scheme::catmull_clark,
      "CatmullClarkT on a copy of the mesh; building its connectivity is not counted");
}

}  // namespace surpass::bench

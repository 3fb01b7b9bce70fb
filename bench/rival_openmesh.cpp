// OpenMesh: a half-edge mesh with double points. Its readers always build the connectivity, so they
// are compared with reading and topology together.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "contenders.hpp"
#include "judges.hpp"

namespace surpass::bench {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using Halfedges = OpenMesh::TriMesh_ArrayKernelT<Traits>;

Halfedges build(const Mesh& mesh) {
  Halfedges out;
  out.reserve(mesh.points.size(), 3 * mesh.points.size(), mesh.face_count());
  std::vector<Halfedges::VertexHandle> handles;
  handles.reserve(mesh.points.size());
  for (const Point& p : mesh.points) handles.push_back(out.add_vertex({p[0], p[1], p[2]}));
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    out.add_face(handles[face[0]], handles[face[1]], handles[face[2]]);
  }
  return out;
}

Halfedges read(const std::string& path) {
  Halfedges out;
  OpenMesh::IO::Options options;
  OpenMesh::IO::read_mesh(out, path, options);
  return out;
}

Verdict judge_connectivity(const Workload& workload, const Halfedges& mesh) {
  std::vector<Index> valences;
  for (const auto v : mesh.vertices()) valences.push_back(mesh.valence(v));
  return judge_valences(workload, valences);
}

Verdict judge_mesh(const Workload& workload, const Halfedges& mesh) {
  std::vector<Point> points;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    points.push_back({p[0], p[1], p[2]});
  }
  std::vector<Index> corners;
  for (const auto f : mesh.faces()) {
    for (const auto v : mesh.fv_range(f)) corners.push_back(static_cast<Index>(v.idx()));
  }
  return judge_file(workload, points, corners, Precision::floats);
}

}  // namespace

void add_openmesh(Harness& harness, Index side) {
  harness.add(
      {.step = "topology",
       .tool = "OpenMesh",
       .counted = "reserve, add_vertex and add_face of a mesh with double points"},
      side, [](const Workload& w) { return [&mesh = w.mesh()] { return build(mesh); }; },
      judge_connectivity);
  harness.add(
      {.step = "read OBJ to topology",
       .tool = "OpenMesh",
       .counted = "IO::read_mesh",
       .slow = true},
      side, [](const Workload& w) { return [path = w.obj()] { return read(path); }; }, judge_mesh);
  harness.add(
      {.step = "read PLY to topology",
       .tool = "OpenMesh",
       .counted = "IO::read_mesh",
       .slow = true},
      side, [](const Workload& w) { return [path = w.ply()] { return read(path); }; }, judge_mesh);
}

}  // namespace surpass::bench

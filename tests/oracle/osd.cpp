#include "osd.hpp"

#include <cmath>
#include <memory>

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

namespace surpass::test {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

struct Value {
  Point p = {};
  void Clear() { p = {}; }
  void AddWithWeight(const Value& other, double weight) {
    for (std::size_t k = 0; k < 3; ++k) p[k] += weight * other.p[k];
  }
};

std::unique_ptr<Far::TopologyRefiner> base_of(const Mesh& mesh, const Rules& rules) {
  std::vector<int> sizes;
  for (Index f = 0; f < mesh.face_count(); ++f)
    sizes.push_back(static_cast<int>(mesh.face(f).size()));
  const std::vector<int> vertices(mesh.face_vertices.begin(), mesh.face_vertices.end());
  std::vector<int> crease_ends;
  std::vector<float> crease_weights;
  for (const Crease& c : mesh.creases) {
    for (const Index v : c.vertices) crease_ends.push_back(static_cast<int>(v));
    crease_weights.push_back(c.sharpness);
  }
  std::vector<int> corners;
  std::vector<float> corner_weights;
  for (const Corner& c : mesh.corners) {
    corners.push_back(static_cast<int>(c.vertex));
    corner_weights.push_back(c.sharpness);
  }
  Far::TopologyDescriptor d;
  d.numVertices = static_cast<int>(mesh.points.size());
  d.numFaces = static_cast<int>(sizes.size());
  d.numVertsPerFace = sizes.data();
  d.vertIndicesPerFace = vertices.data();
  d.numCreases = static_cast<int>(crease_weights.size());
  d.creaseVertexIndexPairs = crease_ends.data();
  d.creaseWeights = crease_weights.data();
  d.numCorners = static_cast<int>(corner_weights.size());
  d.cornerVertexIndices = corners.data();
  d.cornerWeights = corner_weights.data();
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(rules.boundary == Boundary::edge_only
                                          ? Sdc::Options::VTX_BOUNDARY_EDGE_ONLY
                                          : Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  const Sdc::SchemeType type =
      rules.scheme == Scheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  return std::unique_ptr<Far::TopologyRefiner>(Factory::Create(d, Factory::Options(type, options)));
}

std::unique_ptr<Far::TopologyRefiner> refiner_of(const Mesh& mesh, const Rules& rules, int levels) {
  auto refiner = base_of(mesh, rules);
  Far::TopologyRefiner::UniformOptions uniform(levels);
  uniform.fullTopologyInLastLevel = true;
  refiner->RefineUniform(uniform);
  return refiner;
}

struct Walk {
  std::vector<Value> values;
  std::vector<Index> descendant;
};

Walk walk(const Far::TopologyRefiner& refiner, const Mesh& mesh, int levels) {
  Walk w;
  for (const Point& p : mesh.points) w.values.push_back({p});
  for (Index v = 0; v < mesh.vertex_count(); ++v) w.descendant.push_back(v);
  const Far::PrimvarRefinerReal<double> primvars(refiner);
  for (int level = 1; level <= levels; ++level) {
    std::vector<Value> next(static_cast<std::size_t>(refiner.GetLevel(level).GetNumVertices()));
    primvars.Interpolate(level, w.values, next);
    for (Index& v : w.descendant) {
      v = static_cast<Index>(refiner.GetLevel(level - 1).GetVertexChildVertex(static_cast<int>(v)));
    }
    w.values = std::move(next);
  }
  return w;
}

}  // namespace

std::unique_ptr<Far::TopologyRefiner> osd_refiner(const Mesh& mesh, const Rules& rules) {
  return base_of(mesh, rules);
}

OsdRefined osd_refine(const Mesh& mesh, const Rules& rules, int levels) {
  const auto refiner = refiner_of(mesh, rules, levels);
  const Walk w = walk(*refiner, mesh, levels);
  OsdRefined refined;
  for (const Value& value : w.values) refined.points.push_back(value.p);
  refined.descendant = w.descendant;
  return refined;
}

std::vector<Point> osd_normals(const Mesh& mesh, const Rules& rules) {
  const auto refiner = refiner_of(mesh, rules, 1);
  const Walk w = walk(*refiner, mesh, 1);
  std::vector<Value> limit(w.values.size());
  std::vector<Value> first(w.values.size());
  std::vector<Value> second(w.values.size());
  Far::PrimvarRefinerReal<double>(*refiner).Limit(w.values, limit, first, second);
  std::vector<Point> normals;
  for (const Index v : w.descendant) {
    const Point& a = first[v].p;
    const Point& b = second[v].p;
    Point n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (double& x : n) x /= length;
    normals.push_back(n);
  }
  return normals;
}

}  // namespace surpass::test

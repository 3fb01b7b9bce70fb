// Limit positions by OpenSubdiv. Most vertices take its limit mask after one uniform refinement of
// the whole mesh. Where sharpness still fades, and where its mask is not the limit of its own
// refined points (at darts, and at interior vertices of valence 2 on Catmull-Clark surfaces), the
// one-ring is cut out and refined by OpenSubdiv alone until nothing moves: the one-ring of a vertex
// determines the one-ring of its child.
#include <surpass/oracle.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/version.h>

namespace surpass {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using Level = Far::TopologyLevel;

// The interface that OpenSubdiv's refiner expects of interpolated values.
struct Value {
  Point p = {};
  void Clear() { p = {}; }
  void AddWithWeight(const Value& other, double weight) {
    for (std::size_t k = 0; k < 3; ++k) p[k] += weight * other.p[k];
  }
};

struct Shape {
  std::vector<Value> points;
  std::vector<int> face_sizes;
  std::vector<int> face_vertices;
  std::vector<int> crease_vertices;
  std::vector<float> crease_sharpness;
  std::vector<int> corner_vertices;
  std::vector<float> corner_sharpness;
};

using Refiner = std::unique_ptr<Far::TopologyRefiner>;

std::optional<Sdc::SchemeType> type_of(Scheme scheme) {
  switch (scheme) {
    case Scheme::loop: return Sdc::SCHEME_LOOP;
    case Scheme::catmull_clark: return Sdc::SCHEME_CATMARK;
    case Scheme::doo_sabin: break;
  }
  return std::nullopt;
}

Refiner make_refiner(const Shape& shape, const Rules& rules) {
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(rules.boundary == Boundary::edge_only
                                          ? Sdc::Options::VTX_BOUNDARY_EDGE_ONLY
                                          : Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  Far::TopologyDescriptor d;
  d.numVertices = static_cast<int>(shape.points.size());
  d.numFaces = static_cast<int>(shape.face_sizes.size());
  d.numVertsPerFace = shape.face_sizes.data();
  d.vertIndicesPerFace = shape.face_vertices.data();
  d.numCreases = static_cast<int>(shape.crease_sharpness.size());
  d.creaseVertexIndexPairs = shape.crease_vertices.data();
  d.creaseWeights = shape.crease_sharpness.data();
  d.numCorners = static_cast<int>(shape.corner_sharpness.size());
  d.cornerVertexIndices = shape.corner_vertices.data();
  d.cornerWeights = shape.corner_sharpness.data();
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  Refiner refiner(Factory::Create(d, Factory::Options(*type_of(rules.scheme), options)));
  if (refiner) {
    Far::TopologyRefiner::UniformOptions once(1);
    once.fullTopologyInLastLevel = true;
    refiner->RefineUniform(once);
  }
  return refiner;
}

std::vector<Value> refined_points(const Far::TopologyRefiner& refiner, const Shape& shape) {
  std::vector<Value> points(static_cast<std::size_t>(refiner.GetLevel(1).GetNumVertices()));
  Far::PrimvarRefinerReal<double>(refiner).Interpolate(1, shape.points, points);
  return points;
}

Shape shape_of(const Mesh& mesh) {
  Shape shape;
  for (const Point& p : mesh.points) shape.points.push_back({p});
  for (Index f = 0; f < mesh.face_count(); ++f) {
    shape.face_sizes.push_back(static_cast<int>(mesh.face(f).size()));
  }
  shape.face_vertices.assign(mesh.face_vertices.begin(), mesh.face_vertices.end());
  for (const Crease& crease : mesh.creases) {
    for (const Index v : crease.vertices) shape.crease_vertices.push_back(static_cast<int>(v));
    shape.crease_sharpness.push_back(crease.sharpness);
  }
  for (const Corner& corner : mesh.corners) {
    shape.corner_vertices.push_back(static_cast<int>(corner.vertex));
    shape.corner_sharpness.push_back(corner.sharpness);
  }
  return shape;
}

// The faces at a vertex of a level, with the sharpness of its spokes; the vertex becomes number 0.
Shape cut_ring(const Level& level, const std::vector<Value>& points, int center) {
  Shape shape;
  std::map<int, int> number;
  const auto add = [&](int v) {
    const auto [at, added] = number.try_emplace(v, static_cast<int>(shape.points.size()));
    if (added) shape.points.push_back(points[static_cast<std::size_t>(v)]);
    return at->second;
  };
  add(center);
  for (const int face : level.GetVertexFaces(center)) {
    const auto vertices = level.GetFaceVertices(face);
    shape.face_sizes.push_back(vertices.size());
    for (const int v : vertices) shape.face_vertices.push_back(add(v));
  }
  for (const int edge : level.GetVertexEdges(center)) {
    const float sharpness = level.GetEdgeSharpness(edge);
    if (sharpness <= 0 || level.IsEdgeBoundary(edge)) continue;
    const auto ends = level.GetEdgeVertices(edge);
    shape.crease_vertices.insert(shape.crease_vertices.end(), {add(ends[0]), add(ends[1])});
    shape.crease_sharpness.push_back(sharpness);
  }
  if (level.GetVertexSharpness(center) > 0) {
    shape.corner_vertices.push_back(0);
    shape.corner_sharpness.push_back(level.GetVertexSharpness(center));
  }
  return shape;
}

bool fades(float sharpness) { return sharpness > 0 && sharpness < kInfinitelySharp; }

bool is_semi_sharp(const Level& level, int v) {
  if (fades(level.GetVertexSharpness(v))) return true;
  const auto edges = level.GetVertexEdges(v);
  return std::any_of(edges.begin(), edges.end(),
                     [&](int e) { return fades(level.GetEdgeSharpness(e)); });
}

bool has_wrong_mask(const Level& level, int v, Scheme scheme) {
  const Sdc::Crease::Rule rule = level.GetVertexRule(v);
  if (rule == Sdc::Crease::RULE_DART) return true;
  return scheme == Scheme::catmull_clark && rule == Sdc::Crease::RULE_SMOOTH &&
         level.GetVertexEdges(v).size() == 2;
}

// Limit of vertex 0 of a cut ring.
Point limit_of_ring(Shape ring, const Rules& rules) {
  constexpr int kDeep = 120;  // the slowest mode of a ring fades by 5/8 a step: 1e-24
  for (int step = 0; step < kDeep; ++step) {
    const Refiner refiner = make_refiner(ring, rules);
    const std::vector<Value> points = refined_points(*refiner, ring);
    const int child = refiner->GetLevel(0).GetVertexChildVertex(0);
    const Level& level = refiner->GetLevel(1);
    if (!is_semi_sharp(level, child) && !has_wrong_mask(level, child, rules.scheme)) {
      std::vector<Value> limits(points.size());
      Far::PrimvarRefinerReal<double>(*refiner).Limit(points, limits);
      return limits[static_cast<std::size_t>(child)].p;
    }
    ring = cut_ring(level, points, child);
  }
  return ring.points.front().p;
}

}  // namespace

std::string opensubdiv_version() {
  return fmt::format("OpenSubdiv {}.{}.{}", OPENSUBDIV_VERSION_MAJOR, OPENSUBDIV_VERSION_MINOR,
                     OPENSUBDIV_VERSION_PATCH);
}

Result<void> opensubdiv_knows(const Rules& rules) {
  if (!type_of(rules.scheme)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("OpenSubdiv has no {} surfaces", name_of(rules.scheme)));
  }
  if (rules.boundary == Boundary::hoppe || rules.boundary == Boundary::interior) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("OpenSubdiv has no boundary rule `{}`; it has edge-only and "
                            "edge-and-corner",
                            name_of(rules.boundary)));
  }
  return {};
}

Result<std::vector<Point>> opensubdiv_limit_positions(const Mesh& control, const Rules& rules,
                                                      std::vector<std::string>* notes) {
  if (auto ok = opensubdiv_knows(rules); !ok) return tl::make_unexpected(ok.error());
  if (face_size(rules.scheme) == 3 && !all_triangles(control)) {
    return fail(ErrorCode::unsuitable_for_scheme, "Loop surfaces are made of triangles");
  }
  const Shape shape = shape_of(control);
  const Refiner refiner = make_refiner(shape, rules);
  if (!refiner) {
    return fail(ErrorCode::unsuitable_for_scheme, "OpenSubdiv refuses the topology of this mesh");
  }
  const std::vector<Value> refined = refined_points(*refiner, shape);
  std::vector<Value> limits(refined.size());
  Far::PrimvarRefinerReal<double>(*refiner).Limit(refined, limits);

  const Level& base = refiner->GetLevel(0);
  std::vector<Point> positions(control.points);
  std::size_t deep = 0;
  for (int v = 0; v < base.GetNumVertices(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (base.GetVertexFaces(v).empty()) continue;  // isolated: its own limit
    if (is_semi_sharp(base, v) || has_wrong_mask(base, v, rules.scheme)) {
      positions[i] = limit_of_ring(cut_ring(base, shape.points, v), rules);
      ++deep;
    } else {
      positions[i] = limits[static_cast<std::size_t>(base.GetVertexChildVertex(v))].p;
    }
  }
  if (notes != nullptr && deep > 0) {
    notes->push_back(fmt::format(
        "vertices where OpenSubdiv has no exact mask (darts, semi-sharp creases, interior valence "
        "2) were evaluated by its deep refinement: {}",
        deep));
  }
  return positions;
}

Result<Certificate> certify_with_opensubdiv(const Mesh& control, std::span<const Point> given,
                                            const Rules& rules) {
  if (auto ok = check_vertex_counts(control, given.size()); !ok) {
    return tl::make_unexpected(ok.error());
  }
  std::vector<std::string> notes;
  const auto limit = opensubdiv_limit_positions(control, rules, &notes);
  if (!limit) return tl::make_unexpected(limit.error());
  auto certificate =
      compare_points(std::span(*limit).first(given.size()), given, opensubdiv_version());
  if (certificate) certificate->notes = std::move(notes);
  return certificate;
}

}  // namespace surpass

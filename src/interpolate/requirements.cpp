#include <surpass/requirements.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "interpolate/requirement_places.hpp"
#include "mesh/wording.hpp"
#include "scheme/sharpness.hpp"
#include "scheme/tangents.hpp"

namespace surpass {
namespace {

constexpr std::array kKinds = {Requirement::Kind::position, Requirement::Kind::normal,
                               Requirement::Kind::direction, Requirement::Kind::derivative,
                               Requirement::Kind::remove};

// #V: how many infinitely sharp edges inside the surface end at each vertex, and two for one that
// is infinitely sharp itself.
Result<std::vector<Index>> sharp_ends(const Mesh& mesh, const Topology& topology,
                                      const Rules& rules) {
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  std::vector<Index> ends(mesh.points.size(), 0);
  for (Index e = 0; !mesh.creases.empty() && e < topology.edge_count(); ++e) {
    if (topology.is_boundary_edge(e) || !is_infinite(sharpness->edge(topology, e))) continue;
    for (const Index v : topology.edge_vertices(e)) ++ends[v];
  }
  for (const Corner& corner : mesh.corners) {
    // Such a vertex stays fixed with or without a tag, and has a plane.
    const bool one_face =
        topology.is_boundary(corner.vertex) && topology.faces_at(corner.vertex) == 1;
    if (!one_face && is_infinite(sharpness->vertex(corner.vertex))) ends[corner.vertex] = 2;
  }
  return ends;
}

// Normals of a whole mesh point to the back of its faces where one or the other was turned over.
Result<void> check_sides(const Mesh& mesh, const Topology& topology,
                         std::span<const Requirement> normals) {
  const auto points_back = [&](const Requirement& r) {
    const Point face = mean_face_normal(mesh, topology, r.vertex);
    return std::inner_product(face.begin(), face.end(), r.value.begin(), 0.0) < 0;
  };
  const auto back = std::count_if(normals.begin(), normals.end(), points_back);
  if (2 * static_cast<std::size_t>(back) <= normals.size()) return {};
  return fail(
      ErrorCode::mismatch,
      fmt::format("{} of {} point to the back of the faces at their vertices: these normals, "
                  "or the faces, are the wrong way round",
                  back, counted(normals.size(), "normal", "normals")));
}

}  // namespace

const char* name_of(Requirement::Kind kind) {
  switch (kind) {
    case Requirement::Kind::position: return "position";
    case Requirement::Kind::normal: return "normal";
    case Requirement::Kind::direction: return "direction";
    case Requirement::Kind::derivative: return "derivative";
    case Requirement::Kind::remove: return "remove";
  }
  return "unknown";
}

Result<Requirement::Kind> requirement_kind_named(std::string_view name) {
  for (const Requirement::Kind kind : kKinds) {
    if (name == name_of(kind)) return kind;
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("there is no requirement \"{}\"; there are position, normal, direction, "
                          "derivative and remove",
                          name));
}

std::string describe(const Requirement& r) {
  if (r.vertex != kNone) {
    const std::string towards =
        r.towards == kNone ? "" : fmt::format(" towards vertex {}", r.towards);
    return fmt::format("{} at vertex {}{}", name_of(r.kind), r.vertex, towards);
  }
  const std::string corner =
      r.place.corner == kNone ? "" : fmt::format(", corner {}", r.place.corner);
  return fmt::format("{} on face {}{} at ({:.6g}, {:.6g})", name_of(r.kind), r.place.face, corner,
                     r.place.u, r.place.v);
}

Result<std::vector<Requirement>> normals_everywhere(const Mesh& mesh, const Rules& rules,
                                                    std::span<const Point> normals) {
  if (normals.size() != mesh.points.size()) {
    return fail(ErrorCode::mismatch, fmt::format("{} normals were given for {} vertices",
                                                 normals.size(), mesh.points.size()));
  }
  const auto topology = Topology::build(mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  const auto sharp = sharp_ends(mesh, *topology, rules);
  if (!sharp) return tl::make_unexpected(sharp.error());
  std::vector<Requirement> requirements;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const bool one_face = rules.boundary == Boundary::edge_only && topology->is_boundary(v) &&
                          topology->faces_at(v) == 1;
    const bool on_boundary = topology->is_boundary(v) && !topology->is_isolated(v);
    const Index allowed = on_boundary ? 0 : 1;  // one crease is a dart
    const bool two_faces =
        rules.scheme == Scheme::catmull_clark && !on_boundary && topology->faces_at(v) == 2;
    if (two_faces || topology->is_isolated(v) || topology->is_bowtie(v) || (*sharp)[v] > allowed ||
        one_face) {
      continue;
    }
    const Point& n = normals[v];
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0) || !std::isfinite(length)) continue;
    Requirement& r = requirements.emplace_back();
    r.kind = Requirement::Kind::normal;
    r.vertex = v;
    r.value = n;
  }
  if (auto ok = check_sides(mesh, *topology, requirements); !ok) {
    return tl::make_unexpected(ok.error());
  }
  return requirements;
}

namespace {

// Whether a place on face f lies on a side without a neighbour, or in a vertex of the boundary.
bool lies_on_boundary(const Topology& topology, const SurfacePlace& place) {
  if (place.face >= topology.face_count()) return false;
  const Index begin = topology.face_begin(place.face);
  const Index degree = topology.face_degree(place.face);
  const auto is_open = [&](Index side) {
    return topology.opposite(begin + side % degree) == kNone;
  };
  if (const Index k = corner_at(place); k < degree) {
    return topology.is_boundary(topology.tail(begin + k));
  }
  if (place.corner == kNone) {
    return (place.v == 0 && is_open(0)) || (place.u == 1 && is_open(1)) ||
           (place.v == 1 && is_open(2)) || (place.u == 0 && is_open(3));
  }
  return (place.v == 0 && is_open(place.corner)) ||
         (place.u == 0 && is_open(place.corner + degree - 1));
}

}  // namespace

bool prescribes_at_boundary(const Mesh& given, std::span<const Requirement> requirements) {
  if (requirements.empty()) return false;
  const auto topology = Topology::build(given);
  if (!topology || topology->boundary_edge_count() == 0) return false;
  return std::any_of(requirements.begin(), requirements.end(), [&](const Requirement& r) {
    if (r.kind == Requirement::Kind::position || r.kind == Requirement::Kind::remove) return false;
    if (r.vertex == kNone) return lies_on_boundary(*topology, r.place);
    return r.vertex < topology->vertex_count() && topology->is_boundary(r.vertex);
  });
}

}  // namespace surpass

#include <surpass/scheme.hpp>

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "mesh/select.hpp"
#include "mesh/wording.hpp"
#include "scheme/catmull_clark.hpp"
#include "scheme/doo_sabin.hpp"
#include "scheme/limit_points.hpp"
#include "scheme/loop.hpp"
#include "scheme/subdivision_scheme.hpp"

namespace surpass {

namespace {

constexpr std::array kSchemes = {Scheme::loop, Scheme::catmull_clark, Scheme::doo_sabin};
constexpr std::array kBoundaries = {Boundary::edge_only, Boundary::edge_and_corner, Boundary::hoppe,
                                    Boundary::interior};

}  // namespace

const SubdivisionScheme& scheme_of(Scheme scheme) {
  static const loop::Loop loop;
  static const catmull_clark::CatmullClark catmull_clark;
  static const doo_sabin::DooSabin doo_sabin;
  switch (scheme) {
    case Scheme::loop: break;
    case Scheme::catmull_clark: return catmull_clark;
    case Scheme::doo_sabin: return doo_sabin;
  }
  return loop;
}

const char* name_of(Scheme scheme) { return scheme_of(scheme).name(); }

const char* name_of(Boundary boundary) {
  switch (boundary) {
    case Boundary::edge_only: return "edge-only";
    case Boundary::edge_and_corner: return "edge-and-corner";
    case Boundary::hoppe: return "hoppe";
    case Boundary::interior: return "interior";
  }
  return "unknown";
}

Result<Scheme> scheme_named(std::string_view name) {
  std::vector<std::string> known;
  for (const Scheme s : kSchemes) {
    if (name == name_of(s)) return s;
    known.emplace_back(name_of(s));
  }
  return fail(
      ErrorCode::invalid_argument,
      fmt::format("there is no scheme \"{}\"; this version has: {}", name, joined(known, ", ")));
}

Result<Boundary> boundary_named(std::string_view name) {
  for (const Boundary b : kBoundaries) {
    if (name == name_of(b)) return b;
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("there is no boundary rule \"{}\"; there are edge-only, edge-and-corner, "
                          "hoppe and interior",
                          name));
}

const char* name_of(Weights weights) { return weights == Weights::cosine ? "cosine" : "averaging"; }

Result<Weights> weights_named(std::string_view name) {
  for (const Weights w : {Weights::averaging, Weights::cosine}) {
    if (name == name_of(w)) return w;
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("there are no weights \"{}\"; there are averaging and cosine", name));
}

void annotate(Mesh& mesh, const Rules& rules) {
  mesh.annotate("scheme", name_of(rules.scheme));
  mesh.annotate("boundary", name_of(rules.boundary));
  mesh.forget("weights");
  if (rules.weights != Weights{}) mesh.annotate("weights", name_of(rules.weights));
}

void forget_rules(Mesh& mesh) {
  for (const char* key : {"scheme", "boundary", "weights", "refined"}) mesh.forget(key);
}

std::vector<Scheme> all_schemes() { return {kSchemes.begin(), kSchemes.end()}; }

Scheme suggested_scheme(const Mesh& mesh) {
  return all_triangles(mesh) ? Scheme::loop : Scheme::catmull_clark;
}

Index face_size(Scheme scheme) { return scheme_of(scheme).face_size(); }

Result<void> require_suitable(const SubdivisionScheme& scheme, const Topology& topology,
                              const Rules& rules) {
  if (!scheme.has_boundary_rule(rules.boundary)) {
    std::vector<std::string> known;
    for (const Boundary b : kBoundaries) {
      if (scheme.has_boundary_rule(b)) known.emplace_back(name_of(b));
    }
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} surfaces have no boundary rule `{}`; they have {}", scheme.title(),
                            name_of(rules.boundary), joined(known, " and ")));
  }
  const Index size = scheme.face_size();
  for (Index f = 0; size != 0 && f < topology.face_count(); ++f) {
    if (topology.face_degree(f) == size) continue;
    return fail(ErrorCode::unsuitable_for_scheme,
                fmt::format("{} surfaces are made of triangles, and a face has {} vertices; "
                            "triangulate the mesh first",
                            scheme.title(), topology.face_degree(f)),
                {.face = f});
  }
  return {};
}

namespace {

// What every question about a mesh begins with.
Result<Topology> suitable_topology(const Mesh& mesh, const Rules& rules) {
  auto topology = Topology::build(mesh);
  if (!topology) return topology;
  if (auto ok = require_suitable(scheme_of(rules.scheme), *topology, rules); !ok) {
    return tl::make_unexpected(ok.error());
  }
  return topology;
}

}  // namespace

Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                     const Context& context) {
  const SubdivisionScheme& scheme = scheme_of(rules.scheme);
  if (auto ok = require_suitable(scheme, topology, rules); !ok) {
    return tl::make_unexpected(ok.error());
  }
  return scheme.limit_operator(mesh, topology, rules, context);
}

Result<std::vector<Point>> limit_positions(const Mesh& control, const Rules& rules,
                                           const Context& context) {
  const auto topology = suitable_topology(control, rules);
  if (!topology) return tl::make_unexpected(topology.error());
  const auto op = scheme_of(rules.scheme).limit_operator(control, *topology, rules, context);
  if (!op) return tl::make_unexpected(op.error());
  return limit_points(op->rows, control.points, context);
}

Result<std::vector<Point>> limit_normals(const Mesh& control, const Rules& rules,
                                         const Context& context) {
  const auto topology = suitable_topology(control, rules);
  if (!topology) return tl::make_unexpected(topology.error());
  return scheme_of(rules.scheme).limit_normals(control, *topology, rules, context);
}

Result<std::vector<Point>> given_limit_points(const Mesh& refined, const Mesh& given,
                                              const Rules& rules, const Context& context) {
  const auto topology = suitable_topology(refined, rules);
  if (!topology) return tl::make_unexpected(topology.error());
  const auto rows = scheme_of(rules.scheme).given_limits(refined, *topology, rules, given, context);
  if (!rows) return tl::make_unexpected(rows.error());
  return limit_points(*rows, refined.points, context);
}

namespace {

Result<Mesh> refine_once(const Mesh& mesh, const Rules& rules, const Context& context,
                         Steps& steps) {
  const auto topology = suitable_topology(mesh, rules);
  if (!topology) return tl::make_unexpected(topology.error());
  return steps.take(mesh, context, [&](RowSink& sink) {
    auto refined = scheme_of(rules.scheme).refinement(mesh, *topology, rules, context, sink);
    // It told how the mesh before was made from one that is given.
    if (refined) refined->forget("refined");
    return refined;
  });
}

}  // namespace

Result<Mesh> refine(const Mesh& control, const Rules& rules, int levels, const Context& context,
                    Steps& steps) {
  if (levels < 0) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the number of levels is {}; it must be 0 or more", levels));
  }
  if (levels == 0) return control;
  Result<Mesh> mesh;
  for (int level = 0; level < levels; ++level) {
    if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while subdividing");
    context.report({.stage = "subdivide",
                    .fraction = static_cast<double>(level) / levels,
                    .iteration = static_cast<std::uint64_t>(level)});
    mesh = refine_once(level == 0 ? control : *mesh, rules, context, steps);
    if (!mesh) return mesh;
  }
  return mesh;
}

Result<Mesh> refine(const Mesh& control, const Rules& rules, int levels, const Context& context) {
  Steps steps;
  return refine(control, rules, levels, context, steps);
}

void add_limit_normals(Mesh& mesh, const std::vector<Point>& normals) {
  std::erase_if(mesh.channels, [](const Channel& c) { return c.name == "normal"; });
  std::erase_if(mesh.corner_channels, [](const CornerChannel& c) { return c.name == "normal"; });
  const auto values = flat(normals);
  mesh.channels.push_back({"normal", {"nx", "ny", "nz"}, {values.begin(), values.end()}});
  forget_rules(mesh);
}

void move_to_limit(Mesh& mesh, const SparseRows& rows, const std::vector<Point>& normals,
                   const Context& context, Steps& steps) {
  std::erase_if(mesh.channels, [](const Channel& c) { return c.name == "normal"; });
  steps.move(mesh, rows, context);
  add_limit_normals(mesh, normals);
}

Result<std::unique_ptr<const SurfaceEvaluator>> SubdivisionScheme::evaluator(
    const Mesh& /*mesh*/, const Topology& /*topology*/, const Rules& /*rules*/,
    const Context& /*context*/) const {
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} surfaces are evaluated at their vertices only", title()));
}

Result<Mesh> SubdivisionScheme::limit_mesh(const Mesh& control, const Rules& rules, int levels,
                                           const Context& context, Steps& steps) const {
  auto mesh = refine(control, rules, levels, context, steps);
  if (!mesh) return mesh;
  const auto topology = suitable_topology(*mesh, rules);
  if (!topology) return tl::make_unexpected(topology.error());
  const auto op = limit_operator(*mesh, *topology, rules, context);
  if (!op) return tl::make_unexpected(op.error());
  const auto normals = limit_normals(*mesh, *topology, rules, context);
  if (!normals) return tl::make_unexpected(normals.error());
  move_to_limit(*mesh, op->rows, *normals, context, steps);
  return mesh;
}

namespace {

// Control vertices that stay in a surface though nothing of it is drawn at them: a written surface
// is compared with the given vertices by their numbers, which come first. On a mesh that was
// refined once, the given vertices are the first corners of its quads, and those without faces. The
// others there that are not drawn may be dummies, far from the surface.
std::vector<unsigned char> kept_vertices(const Mesh& control, const Rules& rules) {
  const bool quads = rules.scheme == Scheme::catmull_clark &&
                     control.annotation("refined") == "1" &&
                     control.corner_count() == 4 * static_cast<std::size_t>(control.face_count());
  if (!quads) return std::vector<unsigned char>(control.vertex_count(), 1);
  std::vector<unsigned char> used(control.vertex_count(), 0);
  for (const Index v : control.face_vertices) used[v] = 1;
  std::vector<unsigned char> kept(control.vertex_count(), 0);
  for (Index v = 0; v < control.vertex_count(); ++v) kept[v] = used[v] == 0 ? 1 : 0;
  for (Index f = 0; f < control.face_count(); ++f) kept[control.face(f).front()] = 1;
  return kept;
}

}  // namespace

Result<Mesh> limit_mesh(const Mesh& control, const Rules& rules, int levels, const Context& context,
                        Steps& steps) {
  auto mesh = scheme_of(rules.scheme).limit_mesh(control, rules, levels, context, steps);
  if (!mesh || mesh->hole_faces.empty()) return mesh;
  Selection visible = visible_part(*mesh, kept_vertices(control, rules));
  steps.pick(visible.vertex_source, context);
  return select(*mesh, std::move(visible));
}

Result<Mesh> limit_mesh(const Mesh& control, const Rules& rules, int levels,
                        const Context& context) {
  Steps steps;
  return limit_mesh(control, rules, levels, context, steps);
}

}  // namespace surpass

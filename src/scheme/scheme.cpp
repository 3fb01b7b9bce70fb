#include <surpass/scheme.hpp>

#include <algorithm>

#include <fmt/format.h>

#include "scheme/limit_operator.hpp"
#include "scheme/loop.hpp"

namespace surpass {

const char* name_of(Scheme scheme) {
  switch (scheme) {
    case Scheme::loop: return "loop";
  }
  return "unknown";
}

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
  if (name == "loop") return Scheme::loop;
  return fail(ErrorCode::invalid_argument,
              fmt::format("there is no scheme \"{}\"; this version has: loop", name));
}

Result<Boundary> boundary_named(std::string_view name) {
  for (const Boundary b :
       {Boundary::edge_only, Boundary::edge_and_corner, Boundary::hoppe, Boundary::interior}) {
    if (name == name_of(b)) return b;
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("there is no boundary rule \"{}\"; there are edge-only, edge-and-corner, "
                          "hoppe and interior",
                          name));
}

Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                     const Context& context) {
  return loop::limit_operator(mesh, topology, rules.boundary, context);
}

Result<Refinement> refinement(const Mesh& mesh, const Topology& topology, const Rules& rules,
                              const Context& context) {
  return loop::refinement(mesh, topology, rules.boundary, context);
}

Result<std::vector<Point>> limit_positions(const Mesh& control, const Rules& rules,
                                           const Context& context) {
  const auto topology = Topology::build(control);
  if (!topology) return tl::make_unexpected(topology.error());
  const auto op = limit_operator(control, *topology, rules, context);
  if (!op) return tl::make_unexpected(op.error());
  return op->rows.apply(context, control.points);
}

Result<std::vector<Point>> limit_normals(const Mesh& control, const Rules& rules,
                                         const Context& context) {
  const auto topology = Topology::build(control);
  if (!topology) return tl::make_unexpected(topology.error());
  return loop::limit_normals(control, *topology, rules.boundary, context);
}

namespace {

Result<Mesh> refine_once(const Mesh& mesh, const Rules& rules, const Context& context) {
  const auto topology = Topology::build(mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  auto step = refinement(mesh, *topology, rules, context);
  if (!step) return tl::make_unexpected(step.error());
  step->mesh.points = step->stencil.apply(context, mesh.points);
  for (const Channel& channel : mesh.channels) {
    Channel& refined = step->mesh.channels.emplace_back(channel);
    refined.values.resize(step->stencil.row_count() * channel.width());
    step->stencil.apply(context, channel.width(), channel.values, refined.values);
  }
  return std::move(step->mesh);
}

}  // namespace

Result<Mesh> refine(const Mesh& control, const Rules& rules, int levels, const Context& context) {
  if (levels < 0) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the number of levels is {}; it must be 0 or more", levels));
  }
  Mesh mesh = control;
  for (int level = 0; level < levels; ++level) {
    if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while subdividing");
    context.report({.stage = "subdivide",
                    .fraction = static_cast<double>(level) / levels,
                    .iteration = static_cast<std::uint64_t>(level)});
    auto refined = refine_once(mesh, rules, context);
    if (!refined) return refined;
    mesh = std::move(*refined);
  }
  return mesh;
}

Result<Mesh> limit_mesh(const Mesh& control, const Rules& rules, int levels,
                        const Context& context) {
  auto mesh = refine(control, rules, levels, context);
  if (!mesh) return mesh;
  const auto topology = Topology::build(*mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  const auto op = limit_operator(*mesh, *topology, rules, context);
  if (!op) return tl::make_unexpected(op.error());
  const auto normals = loop::limit_normals(*mesh, *topology, rules.boundary, context);
  if (!normals) return tl::make_unexpected(normals.error());

  mesh->points = op->rows.apply(context, mesh->points);
  std::erase_if(mesh->channels, [](const Channel& c) { return c.name == "normal"; });
  for (Channel& channel : mesh->channels) {
    const std::vector<double> control_values = channel.values;
    op->rows.apply(context, channel.width(), control_values, channel.values);
  }
  std::erase_if(mesh->corner_channels, [](const CornerChannel& c) { return c.name == "normal"; });
  const auto values = flat(*normals);
  mesh->channels.push_back({"normal", {"nx", "ny", "nz"}, {values.begin(), values.end()}});
  // What lies on the limit surface is no control mesh any more.
  std::erase_if(mesh->annotations,
                [](const auto& a) { return a.first == "scheme" || a.first == "boundary"; });
  return mesh;
}

}  // namespace surpass

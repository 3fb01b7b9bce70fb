#include "scheme/nonstationary_checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "scheme/subdivision_scheme.hpp"

namespace surpass::nonstationary {
namespace {

bool has_valence_3(const Topology& topology, const Sharpness& sharpness) {
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (!topology.is_isolated(v) && sharpness.is_plain(v) && topology.valence(v) == 3) return true;
  }
  return false;
}

Result<void> check_sharpness(const Mesh& mesh) {
  for (const Crease& crease : mesh.creases) {
    if (!is_semi_sharp(crease.sharpness)) continue;
    return fail(ErrorCode::unsuitable_for_scheme,
                fmt::format("a crease has sharpness {}; non-stationary Loop surfaces have smooth "
                            "edges and infinitely sharp ones (10 and more)",
                            crease.sharpness),
                {.edge = crease.vertices});
  }
  for (const Corner& corner : mesh.corners) {
    if (!is_semi_sharp(corner.sharpness)) continue;
    return fail(ErrorCode::unsuitable_for_scheme,
                fmt::format("a corner has sharpness {}; non-stationary Loop surfaces have smooth "
                            "vertices and infinitely sharp ones (10 and more)",
                            corner.sharpness),
                {.vertex = corner.vertex});
  }
  return {};
}

Result<void> check_vertex(const Topology& topology, const Sharpness& sharpness, Index v,
                          bool closed_only) {
  if (topology.is_isolated(v)) return {};
  if (sharpness.is_plain(v)) {
    if (topology.valence(v) >= 3) return {};
    return fail(ErrorCode::unsuitable_for_scheme,
                fmt::format("an interior vertex has {} neighbours; non-stationary Loop surfaces "
                            "need 3 or more",
                            topology.valence(v)),
                {.vertex = v});
  }
  if (closed_only) {
    return fail(ErrorCode::unsuitable_for_scheme,
                "edge parameters that are means have no rules at boundaries, creases and corners",
                {.vertex = v});
  }
  if (Ring::around(topology, sharpness, v).rule() != VertexRule::dart) return {};
  return fail(ErrorCode::unsuitable_for_scheme,
              "a crease ends inside of the surface; non-stationary Loop surfaces have no rule for "
              "its end: take the crease away, or lead it to a boundary or corner",
              {.vertex = v});
}

Result<void> check_targets(const NonstationaryOptions& options, const Topology& topology,
                           const Sharpness& sharpness) {
  if (options.targets.empty()) return {};
  if (options.rule != NonstationaryRule::interpolating || !options.vertex_parameters.empty()) {
    return fail(ErrorCode::invalid_argument,
                "targets are for the rule interpolating, whose parameters are solved for");
  }
  std::vector<unsigned char> seen(topology.vertex_count(), 0);
  for (const LineTarget& target : options.targets) {
    const Index v = target.vertex;
    if (v >= topology.vertex_count()) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("a target is for vertex {}; the mesh has {}, counted from 0", v,
                              topology.vertex_count()),
                  {.vertex = v});
    }
    if (topology.is_isolated(v) || !sharpness.is_plain(v)) {
      return fail(ErrorCode::invalid_argument,
                  "a target is for a vertex on a boundary, crease or corner or without faces; only "
                  "smooth interior vertices can have one",
                  {.vertex = v});
    }
    if (std::exchange(seen[v], 1) != 0) {
      return fail(ErrorCode::invalid_argument, "a vertex has two targets", {.vertex = v});
    }
  }
  return {};
}

}  // namespace

Result<void> check_options(const NonstationaryOptions& options, Index vertices) {
  const auto refuse = [](std::string sentence) {
    return fail(ErrorCode::invalid_argument, std::move(sentence));
  };
  if (!std::isfinite(options.shape)) {
    return refuse(fmt::format("the shape parameter is {}; it must be a number", options.shape));
  }
  if (options.boundary != Boundary::edge_only && options.boundary != Boundary::edge_and_corner) {
    return refuse(
        fmt::format("non-stationary Loop surfaces have no boundary rule `{}`; they have "
                    "edge-only and edge-and-corner",
                    name_of(options.boundary)));
  }
  if (options.steps < 0) {
    return refuse(
        fmt::format("the number of steps is {}; it must be 0 (the limit) or more", options.steps));
  }
  if (!(options.rate > 1)) {
    return refuse(fmt::format("the rate is {}; it must be above 1", options.rate));
  }
  const std::vector<double>& own = options.vertex_parameters;
  if (!own.empty() && own.size() != vertices) {
    return fail(ErrorCode::mismatch, fmt::format("there are {} vertex parameters for {} vertices",
                                                 own.size(), vertices));
  }
  for (Index v = 0; v < own.size(); ++v) {
    const bool root = options.iteration == ParameterIteration::geometric || own[v] > -1;
    if (std::isfinite(own[v]) && root) continue;
    return fail(ErrorCode::invalid_argument,
                fmt::format("a vertex parameter is {}; it must be a number, above -1 under the "
                            "exponential iteration",
                            own[v]),
                {.vertex = v});
  }
  if (options.iteration == ParameterIteration::exponential && options.shape <= -1) {
    return refuse(fmt::format(
        "the {} parameter is {}; under the exponential iteration it must be above -1",
        options.rule == NonstationaryRule::uniform ? "uniform" : "shape", options.shape));
  }
  return {};
}

Result<void> check_mesh(const Mesh& mesh, const Topology& topology, const Sharpness& sharpness,
                        const NonstationaryOptions& options) {
  const SubdivisionScheme& loop = scheme_of(Scheme::loop);
  if (auto ok = require_suitable(loop, topology, {Scheme::loop, options.boundary}); !ok) return ok;
  if (auto ok = check_sharpness(mesh); !ok) return ok;
  const bool closed_only = options.rule == NonstationaryRule::mean;
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (auto ok = check_vertex(topology, sharpness, v, closed_only); !ok) return ok;
  }
  return check_targets(options, topology, sharpness);
}

double allowed_shape(const NonstationaryOptions& options, const Topology& topology,
                     const Sharpness& sharpness, std::vector<std::string>& notes) {
  if (options.rule == NonstationaryRule::quadratic) return 1;
  const bool valence_3 = has_valence_3(topology, sharpness);
  const auto [low, high] = shape_range(valence_3);
  const double shape = std::clamp(options.shape, low, high);
  if (shape != options.shape) {
    notes.push_back(fmt::format(
        "the parameter {} is outside of the range from {} to {}{}; {} is taken", options.shape, low,
        high, valence_3 ? " (the mesh has an interior vertex of valence 3)" : "", shape));
  }
  return shape;
}

Result<std::vector<double>> first_parameters(const NonstationaryOptions& options,
                                             const Topology& topology, const Sharpness& sharpness) {
  if (!options.vertex_parameters.empty()) return options.vertex_parameters;
  std::vector<double> parameters(topology.vertex_count(), options.shape);
  if (options.rule == NonstationaryRule::uniform || options.rule == NonstationaryRule::quadratic) {
    return parameters;
  }
  std::vector<double> along(topology.vertex_count(), 0.0);
  for (const LineTarget& target : options.targets) along[target.vertex] = target.along;
  std::map<std::pair<Index, double>, double> solved;
  for (Index v = 0; v < parameters.size(); ++v) {
    if (topology.is_isolated(v) || !sharpness.is_plain(v)) continue;
    const auto key = std::pair(topology.valence(v), along[v]);
    auto at = solved.find(key);
    if (at == solved.end()) {
      auto found = interpolating_parameter(key.first, options, key.second);
      if (!found) {
        found.error().place.vertex = v;
        return tl::make_unexpected(found.error());
      }
      at = solved.emplace(key, *found).first;
    }
    parameters[v] = at->second;
  }
  return parameters;
}

}  // namespace surpass::nonstationary

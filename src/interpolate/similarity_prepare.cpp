#include <cmath>

#include <fmt/format.h>

#include "interpolate/similarity_prepared.hpp"
#include "scheme/subdivision_scheme.hpp"

namespace surpass {
namespace {

constexpr int kLargestLevel = 4;

// Samples along a side of a patch are 2^level + 1.
int level_of(unsigned samples) {
  for (int level = 1; level <= kLargestLevel; ++level) {
    if (samples == (1U << level) + 1) return level;
  }
  return 0;
}

bool is_weight(double x) { return x >= 0 && std::isfinite(x); }

Result<void> check_options(const SimilarityOptions& options) {
  if (level_of(options.samples) == 0) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("there cannot be {} samples along the side of a patch; there can be 3, "
                            "5, 9 or 17",
                            options.samples));
  }
  if (!(options.solver_tolerance > 0) || !(options.solver_tolerance < 1)) {
    return fail(ErrorCode::invalid_argument,
                "the solver's tolerance must be a number between 0 and 1");
  }
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    return fail(ErrorCode::invalid_argument, "the tolerance must be a number of at least 0");
  }
  if (options.similarity == Similarity::fair) {
    const bool weighted = is_weight(options.thin_plate) && is_weight(options.membrane) &&
                          options.thin_plate + options.membrane > 0;
    if (!weighted) {
      return fail(ErrorCode::invalid_argument,
                  "the weights of thin plate and membrane must be numbers of at least 0, and not "
                  "both 0");
    }
  }
  return {};
}

void annotate(Mesh& mesh, const Rules& rules) {
  mesh.annotate("scheme", name_of(rules.scheme));
  mesh.annotate("boundary", name_of(rules.boundary));
  if (rules.weights != Weights{}) mesh.annotate("weights", name_of(rules.weights));
  mesh.annotate("refined", "1");
}

}  // namespace

Result<SimilarityPrepared> prepare_similarity(const Mesh& mesh, const SimilarityOptions& options,
                                              const Context& context) {
  if (auto ok = check_options(options); !ok) return tl::make_unexpected(ok.error());
  const SubdivisionScheme& scheme = scheme_of(options.rules.scheme);
  context.report({.stage = "topology"});
  std::vector<unsigned char> isolated;
  Result<Refinement> refinement = [&]() -> Result<Refinement> {
    const auto topology = Topology::build(mesh);
    if (!topology) return tl::make_unexpected(topology.error());
    if (auto ok = require_suitable(scheme, *topology, options.rules); !ok) {
      return tl::make_unexpected(ok.error());
    }
    isolated.resize(topology->vertex_count());
    for (Index v = 0; v < topology->vertex_count(); ++v) {
      isolated[v] = topology->is_isolated(v) ? 1 : 0;
    }
    return scheme.refinement(mesh, *topology, options.rules, context);
  }();
  if (!refinement) return tl::make_unexpected(refinement.error());
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while setting up");
  Mesh& refined = refinement->mesh;
  const Index control_points = refinement->stencil.row_count();
  refined.points.resize(control_points);
  const auto topology = Topology::build(refined);
  if (!topology) return tl::make_unexpected(topology.error());
  auto limits =
      scheme.given_limits(refined, *topology, options.rules, mesh.vertex_count(), context);
  if (!limits) return tl::make_unexpected(limits.error());
  auto elimination = Elimination::build(std::move(*limits), control_points, context);
  if (!elimination) return tl::make_unexpected(elimination.error());
  auto rows =
      PatchRows::build(refined, *topology, options.rules, level_of(options.samples), {}, context);
  if (!rows) return tl::make_unexpected(rows.error());
  auto layout = std::make_unique<const PatchLayout>(std::move(*rows), control_points);
  const RowWeight weight = options.similarity == Similarity::fair ? fair_weight : vectors_weight;
  auto scalar = sum_of_squares(*layout, weight, options.thin_plate, options.membrane);
  refined.points = {};
  annotate(refined, options.rules);
  return SimilarityPrepared{
      options,           std::move(*refinement), std::move(isolated), std::move(*elimination),
      std::move(layout), std::move(scalar)};
}

}  // namespace surpass

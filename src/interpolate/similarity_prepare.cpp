#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpolate/dummy_ring.hpp"
#include "interpolate/patch_order.hpp"
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

Mesh structure_of(const Mesh& mesh) {
  Mesh structure;
  structure.face_offsets = mesh.face_offsets;
  structure.face_vertices = mesh.face_vertices;
  structure.creases = mesh.creases;
  structure.corners = mesh.corners;
  return structure;
}

// The given mesh after one step, and how it came about.
struct Refined {
  std::vector<unsigned char> isolated;  // #given
  TiledRows stencil;
  std::vector<Index> dummies;
  std::vector<Index> kept;
  Mesh mesh;
  std::vector<unsigned char> sampled;  // #faces of the mesh; empty: all
};

Result<void> step(const Mesh& mesh, const Topology& topology, const SimilarityOptions& options,
                  const Context& context, Refined& refined) {
  auto made = scheme_of(options.rules.scheme)
                  .refinement(mesh, topology, options.rules, context, refined.stencil);
  if (!made) return tl::make_unexpected(made.error());
  refined.mesh = std::move(*made);
  refined.mesh.points.resize(refined.stencil.row_count());
  return {};
}

Result<void> step_with_dummies(const Mesh& mesh, const Topology& topology,
                               const SimilarityOptions& options, const Context& context,
                               Refined& refined) {
  const SubdivisionScheme& scheme = scheme_of(options.rules.scheme);
  if (!scheme.makes_corners_faces()) {
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("the dummy ring is not for {} surfaces; choose the scheme catmull-clark, "
                    "which takes triangles, too",
                    scheme.title()));
  }
  ExtendedMesh extended = with_dummy_ring(mesh, topology);
  const auto around = Topology::build(extended.mesh);
  if (!around) return tl::make_unexpected(around.error());
  if (auto ok = step(extended.mesh, *around, options, context, refined); !ok) return ok;
  DummyParts parts = without_outer_ring(std::move(refined.mesh), mesh);
  refined.mesh = std::move(parts.mesh);
  refined.dummies = std::move(extended.at);
  refined.kept = std::move(parts.kept);
  refined.sampled = std::move(parts.sampled);
  return {};
}

Result<Refined> refined_once(const Mesh& mesh, const SimilarityOptions& options,
                             const Context& context) {
  const auto topology = Topology::build(mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  if (auto ok = require_suitable(scheme_of(options.rules.scheme), *topology, options.rules); !ok) {
    return tl::make_unexpected(ok.error());
  }
  Refined refined;
  refined.isolated.resize(topology->vertex_count());
  for (Index v = 0; v < topology->vertex_count(); ++v) {
    refined.isolated[v] = topology->is_isolated(v) ? 1 : 0;
  }
  const bool around = options.open == OpenMeshes::dummy_ring && topology->boundary_edge_count() > 0;
  const auto ok = around ? step_with_dummies(mesh, *topology, options, context, refined)
                         : step(mesh, *topology, options, context, refined);
  if (!ok) return tl::make_unexpected(ok.error());
  return refined;
}

auto cancelled() { return fail(ErrorCode::cancelled, "cancelled while setting up"); }

}  // namespace

std::vector<double> refine_given(const SimilarityPrepared& prepared, std::size_t width,
                                 std::span<const double> given, const Context& context) {
  std::vector<double> extended;
  if (!prepared.dummies.empty()) {
    extended.assign(given.begin(), given.end());
    for (const Index v : prepared.dummies) {
      const auto at = given.begin() + static_cast<std::ptrdiff_t>(v * width);
      extended.insert(extended.end(), at, at + static_cast<std::ptrdiff_t>(width));
    }
    given = extended;
  }
  std::vector<double> refined(prepared.stencil.row_count() * width);
  prepared.stencil.apply(context, width, given, refined);
  if (prepared.kept.empty()) return refined;
  std::vector<double> chosen;
  chosen.reserve(prepared.kept.size() * width);
  for (const Index i : prepared.kept) {
    const auto at = refined.begin() + static_cast<std::ptrdiff_t>(i * width);
    chosen.insert(chosen.end(), at, at + static_cast<std::ptrdiff_t>(width));
  }
  return chosen;
}

Result<SimilarityPrepared> prepare_similarity(const Mesh& mesh, const SimilarityOptions& options,
                                              const Context& context) {
  if (auto ok = check_options(options); !ok) return tl::make_unexpected(ok.error());
  const SubdivisionScheme& scheme = scheme_of(options.rules.scheme);
  context.report({.stage = "topology"});
  auto refined = refined_once(mesh, options, context);
  if (!refined) return tl::make_unexpected(refined.error());
  if (context.cancelled()) return cancelled();
  const Index control_points = refined->mesh.vertex_count();
  const auto topology = Topology::build(refined->mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  if (context.cancelled()) return cancelled();
  auto limits = scheme.given_limits(refined->mesh, *topology, options.rules, mesh, context);
  if (!limits) return tl::make_unexpected(limits.error());
  auto elimination = Elimination::build(std::move(*limits), control_points, context);
  if (!elimination) return tl::make_unexpected(elimination.error());
  auto rows = PatchRows::build(refined->mesh, *topology, options.rules, level_of(options.samples),
                               refined->sampled, context, Sides::joined);
  if (!rows) return tl::make_unexpected(rows.error());
  if (context.cancelled()) return cancelled();
  auto order = patches_by_neighbourhood(*topology, *rows, PatchLayout::kColumns);
  auto layout =
      std::make_unique<const PatchLayout>(std::move(*rows), std::move(order), control_points);
  if (context.cancelled()) return cancelled();
  const RowWeight weight = options.similarity == Similarity::fair ? fair_weight : vectors_weight;
  // Only their ratio matters, and squares of the smallest numbers would vanish.
  const double larger = std::max(options.thin_plate, options.membrane);
  auto scalar =
      sum_of_squares(*layout, weight, options.thin_plate / larger, options.membrane / larger);
  refined->mesh.points = std::vector<Point>();  // {} would keep the memory
  annotate(refined->mesh, options.rules);
  refined->mesh.annotate("refined", "1");
  return SimilarityPrepared{options,
                            std::move(refined->mesh),
                            std::move(refined->stencil),
                            std::move(refined->dummies),
                            std::move(refined->kept),
                            std::move(refined->isolated),
                            structure_of(mesh),
                            std::move(*elimination),
                            std::move(layout),
                            std::move(scalar)};
}

}  // namespace surpass

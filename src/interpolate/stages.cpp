#include "interpolate/stages.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mesh/wording.hpp"

namespace surpass {
namespace {

// How far the data of a singular part is from having a solution: the length of its part along the
// null vector. Only for symmetric blocks, where that vector is its own adjoint.
double incompatibility(const Prepared& prepared, const SingularPart& part, const Task& task,
                       const Context& context) {
  const Block& block = prepared.blocks.surface[part.block];
  const LinearSystem system{
      prepared.op, block, task.width, task.target, power_of_two_scale(task.unit), context};
  std::vector<double> r(system.values(), 0.0);
  system.residual(task.x, r);
  double length = 0;
  for (std::size_t c = 0; c < task.width; ++c) {
    double along = 0;
    double whole = 0;
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      const Index v = part.vertices[i];
      const double weighted = prepared.op.symmetric_weight[v] * part.null_vector[i];
      along += weighted * (r[v * task.width + c] / task.unit);
      whole += weighted * part.null_vector[i];
    }
    length = std::hypot(length, along / whole);
  }
  return length;
}

std::string numbers(const std::vector<Index>& components) {
  constexpr std::size_t kMost = 20;
  std::vector<std::string> words;
  words.reserve(components.size());
  for (const Index c : components) words.push_back(std::to_string(c));
  if (words.size() > kMost) {
    words.resize(kMost);
    words.emplace_back("...");
  }
  return fmt::format("{} {}", components.size() == 1 ? "component" : "components",
                     joined(words, ","));
}

// The component numbers of some singular parts.
std::vector<Index> components_of(const Prepared& prepared,
                                 const std::vector<const SingularPart*>& parts) {
  std::vector<Index> found;
  for (const SingularPart* part : parts) {
    const Index component = prepared.components.of_vertex[part->vertices.front()];
    found.push_back(component);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

tl::unexpected<Error> no_interpolant(const Prepared& prepared,
                                     const std::vector<const SingularPart*>& parts) {
  return fail(
      ErrorCode::singular,
      fmt::format("{}: no control mesh interpolates these points, for the {} surface is the "
                  "same when control points move along a null vector of its limit "
                  "operator; choose another scheme, subdivide the mesh once and "
                  "interpolate that, or leave the named components as they are",
                  numbers(components_of(prepared, parts)), name_of(prepared.options.rules.scheme)),
      {.vertex = parts.front()->vertices.front()});
}

// Before solving: data that has no solution is refused.
Result<void> require_compatible(const Prepared& prepared, const Task& task, const Context& context,
                                std::vector<std::string>& notes) {
  std::vector<const SingularPart*> none;
  std::vector<const SingularPart*> many;
  for (const SingularPart& part : prepared.singular) {
    if (!prepared.blocks.surface[part.block].symmetric) continue;
    const bool compatible = incompatibility(prepared, part, task, context) <= task.tolerance;
    (compatible ? many : none).push_back(&part);
  }
  if (!none.empty()) return no_interpolant(prepared, none);
  if (many.empty()) return {};
  std::string note =
      fmt::format("{}: the control mesh is not unique; the nearest to the given points was taken",
                  numbers(components_of(prepared, many)));
  // Channels come here after the positions, with the same to say.
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(std::move(note));
  return {};
}

// `at` picks the iteration of a block's outcome that counts.
Iteration combine(const Solved& solved, const Blocks& blocks, Iteration BlockOutcome::*at) {
  Iteration all = solved.curve.*at;
  all.iteration = 0;
  double sum = all.mean * static_cast<double>(blocks.curve.vertices.size());
  for (std::size_t b = 0; b < blocks.surface.size(); ++b) {
    const Iteration& part = solved.surface[b].*at;
    all.iteration = std::max(all.iteration, part.iteration);
    all.max = std::max(all.max, part.max);
    sum += part.mean * static_cast<double>(blocks.surface[b].vertices.size());
  }
  all.mean = sum / static_cast<double>(std::max<std::size_t>(1, blocks.interpolated));
  return all;
}

Iteration at_start(Iteration error) {
  error.iteration = 0;
  return error;
}

}  // namespace

Iteration final_error(const Solved& solved, const Blocks& blocks) {
  return combine(solved, blocks, &BlockOutcome::final);
}

Iteration initial_error(const Prepared& prepared, const Solved& solved, const Task& task,
                        const Context& context) {
  // The first evaluation of a block is that of its targets; but a surface with curves in it starts
  // when these are done.
  const bool was_measured = prepared.blocks.curve.vertices.empty() && !prepared.options.direct;
  if (was_measured) return at_start(combine(solved, prepared.blocks, &BlockOutcome::first));
  std::vector<double> r(task.target.size(), 0.0);
  const auto measure = [&](const Block& block) {
    const LinearSystem system{
        prepared.op, block, task.width, task.target, power_of_two_scale(task.unit), context};
    const ErrorNorms norms = system.residual(task.target, r);
    const auto count = static_cast<double>(std::max<std::size_t>(1, block.vertices.size()));
    const double unit = task.unit * system.scale;
    BlockOutcome outcome;
    outcome.first = {1, norms.max / unit, norms.sum / count / unit};
    return outcome;
  };
  Solved start;
  start.curve = measure(prepared.blocks.curve);
  for (const Block& block : prepared.blocks.surface) start.surface.push_back(measure(block));
  return at_start(combine(start, prepared.blocks, &BlockOutcome::first));
}

std::string solvers_used(const Solved& solved) {
  std::vector<std::string> names;
  const auto add = [&](const BlockOutcome& outcome) {
    const std::string name = name_of(outcome.solver);
    const bool known = std::find(names.begin(), names.end(), name) != names.end();
    if (outcome.solver != Solver::automatic && !known) names.push_back(name);
  };
  for (const BlockOutcome& outcome : solved.surface) add(outcome);
  if (names.empty()) add(solved.curve);
  return joined(names, ", ");
}

Result<Solved> solve_in_stages(const Prepared& prepared, const Task& task, const Context& context,
                               std::vector<std::string>& notes) {
  Solved solved;
  auto curve = solve_block(prepared.options, prepared.op, prepared.blocks.curve, task, "curves",
                           context, notes);
  if (!curve) return tl::make_unexpected(curve.error());
  solved.curve = std::move(*curve);
  if (auto ok = require_compatible(prepared, task, context, notes); !ok) {
    return tl::make_unexpected(ok.error());
  }
  for (std::size_t b = 0; b < prepared.blocks.surface.size(); ++b) {
    auto surface = solve_block(prepared.options, prepared.op, prepared.blocks.surface[b], task,
                               "surface", context, notes);
    // Of symmetric parts it is known by now that there is a solution; of others, only a solver that
    // had its time and found none says that there is not.
    const bool stalled = surface && !surface->converged &&
                         surface->final.iteration < prepared.options.max_iterations;
    const bool failed = stalled || (!surface && surface.error().code == ErrorCode::singular);
    std::vector<const SingularPart*> parts;
    for (const SingularPart& part : prepared.singular) {
      if (part.block == b && !prepared.blocks.surface[b].symmetric) parts.push_back(&part);
    }
    if (failed && !parts.empty()) return no_interpolant(prepared, parts);
    if (!surface) return tl::make_unexpected(surface.error());
    solved.surface.push_back(std::move(*surface));
  }
  return solved;
}

}  // namespace surpass

// The control values that interpolate given numbers and resemble a reference: a solve of similarity
// interpolation, for points or for a channel.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "interpolate/linear_constraints.hpp"
#include "interpolate/similarity_prepared.hpp"

namespace surpass {

struct Wanted {
  std::span<const double> given;      // #given by width
  std::span<const double> reference;  // #given or #control by width; empty: the given points
  std::size_t width;
  bool positions;  // and not a channel
  const Elimination& elimination;
  // Besides the given vertices, for positions, in the units of the solve. A function, so that what
  // makes them is only in programs that ask for it.
  std::function<Result<LinearConstraints>(const FreeSystem&, std::span<const double>,
                                          const ConstraintUnits&)>
      constraints = {};
};

// Control values, #control by width, and how they were found.
struct Found {
  std::vector<double> values;
  std::vector<double> reference;
  std::vector<double> scale;
  FreeOutcome outcome;
  RowFates fates;  // of the requirements' equations, if there are any
};

[[nodiscard]] Result<Found> find(const SimilarityPrepared& prepared, const Wanted& wanted,
                                 const Context& context);

/// What find() makes the values resemble, #control by width.
[[nodiscard]] Result<std::vector<double>> reference_of(const SimilarityPrepared& prepared,
                                                       const Wanted& wanted,
                                                       const Context& context);

}  // namespace surpass

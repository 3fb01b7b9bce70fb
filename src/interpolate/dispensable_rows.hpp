// Rows that are met only where nothing else is the worse for it.
#pragma once

#include "interpolate/independent_rows.hpp"

namespace surpass {

/// Of the length of a row: what it has of its own. For the sake of a nearer one a surface would go
/// farther than it asks by the inverse.
constexpr double kFarFromOthers = 0.03;

/// Keeps those of the `dispensable` rows, ascending, that are far from the span of all that is kept
/// and of each other - so none is kept for what little it has of its own - the farthest first. What
/// the others are is told as far as it can be. Method: pivots of a decomposition, as in
/// independent_rows(), tell which rows are near others, and what these are expressed by tells which
/// dispensable ones are to blame. Only those are expressed by the rest, and near_rows() chooses.
void add_dispensable(const RowMatrix& rows, const RowNumbers& dispensable, const Context& context,
                     IndependentRows& found);

}  // namespace surpass

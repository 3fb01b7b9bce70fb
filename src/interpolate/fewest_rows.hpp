// As few rows as a row that contradicts others can be expressed by.
#pragma once

#include "interpolate/independent_rows.hpp"

namespace surpass {

/// Of the rows that `d` is the sum of as few as suffice still: without any one of them the others
/// do not. Method: those with the largest shares, twice as many each time, until they suffice; of
/// these parts are left out, halves first and single rows last (Zeller and Hildebrandt, Simplifying
/// and isolating failure-inducing input, 2002). Each try is a decomposition of the rows that it is
/// of, about as many as are left times the logarithm of those that were. `d` itself where its rows
/// do not suffice, or the context was cancelled.
[[nodiscard]] DependentRow by_fewest_rows(const RowMatrix& rows, const DependentRow& d,
                                          const Suffices& suffices, const Context& context);

}  // namespace surpass

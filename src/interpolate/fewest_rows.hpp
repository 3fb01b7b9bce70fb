// As few rows as a row that contradicts others can be expressed by.
#pragma once

#include "interpolate/independent_rows.hpp"

namespace surpass {

/// Of the rows that `d` is the sum of as few as suffice still: without any one of them the others
/// do not. Method: those with the largest shares, twice as many each time, until they suffice; then
/// leave_out(). Each try is a decomposition of the rows that it is of. `d` itself where its rows do
/// not suffice, or the context was cancelled.
[[nodiscard]] DependentRow by_fewest_rows(const RowMatrix& rows, const DependentRow& d,
                                          const Suffices& suffices, const Context& context);

}  // namespace surpass

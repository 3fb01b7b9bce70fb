// Which requirements contradict each other, in a sentence.
#pragma once

#include <span>

#include "interpolate/row_check.hpp"

namespace surpass {

/// `contradictory`, naming them, ascending. `amount`: together they miss, in box sides.
[[nodiscard]] tl::unexpected<Error> contradiction(std::span<const std::size_t> numbers,
                                                  double amount,
                                                  std::span<const Requirement> requirements);

/// The same, of a row that is a sum of others and says something else: with as few requirements as
/// contradict each other. Without any one of them the others are not found to; where hundreds take
/// part there may be more than that. Cost: that of by_fewest_rows(), twice, and decompositions of
/// no more than 5,000 rows in all. `cancelled` if the context was.
[[nodiscard]] tl::unexpected<Error> contradiction_of(const DependentRow& d, const RowCheck& check,
                                                     const RowMatrix& scaled,
                                                     std::span<const Requirement> requirements,
                                                     const Context& context);

/// `contradictory`, for equations that only rounding tells apart.
[[nodiscard]] tl::unexpected<Error> not_told_apart();

}  // namespace surpass

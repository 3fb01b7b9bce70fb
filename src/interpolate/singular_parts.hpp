// Where the limit operator is singular: decided numerically, on the operator with its creases.
#pragma once

#include <vector>

#include "interpolate/blocks.hpp"

namespace surpass {

/// A connected part of a block with a vector that L takes to zero.
struct SingularPart {
  std::size_t block = 0;  ///< position in Blocks::surface
  std::vector<Index> vertices;
  std::vector<double> null_vector;  ///< parallel to vertices; its largest entry is 1
};

/// Solves L y = L r for an irregular r, on the blocks under suspicion: where L is regular y = r,
/// and what y lacks elsewhere lies along null vectors, for y is made of images of L. Cost: two
/// solves of one right-hand side on those blocks.
[[nodiscard]] std::vector<SingularPart> find_singular_parts(const LimitOperator& op,
                                                            const Blocks& blocks,
                                                            const Context& context);

}  // namespace surpass

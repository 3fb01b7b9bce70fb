// Which unknowns are solved together, and in which order.
#pragma once

#include <surpass/interpolate.hpp>

#include <vector>

#include "scheme/limit_operator.hpp"

namespace surpass {

/// Unknowns that are solved together while all others stand still.
struct Block {
  std::vector<Index> vertices;  ///< ascending
  bool symmetric = true;        ///< diag(symmetric_weight) L is symmetric on the block
  double lowest = 1;       ///< proven lower bound of its eigenvalues, or 0 if nothing is proven
  Index obstacle = kNone;  ///< a vertex for which nothing is proven, if there is one

  [[nodiscard]] bool proven() const { return symmetric && lowest > 0; }
};

/// Curves (boundaries and creases) do not look at the surface, so they can be solved first: the
/// paper's section 4, for every rule. Vertices that are their own limit are in neither block.
struct Blocks {
  Block curve;
  Block surface;
  std::size_t interpolated = 0;  ///< vertices that are to be met, fixed ones included
};

/// `only` lists the vertices to interpolate, or is empty for all.
Result<Blocks> find_blocks(const LimitOperator& op, const std::vector<Index>& only);

}  // namespace surpass

// Which unknowns are solved together, and in which order.
#pragma once

#include <surpass/interpolate.hpp>

#include <memory>
#include <vector>

#include "interpolate/ordered_rows.hpp"
#include "interpolate/sweep_arrays.hpp"
#include "scheme/limit_operator.hpp"

namespace surpass {

/// Unknowns that are solved together while all others stand still.
struct Block {
  std::vector<Index> vertices;  ///< ascending
  bool symmetric = true;        ///< diag(symmetric_weight) L is symmetric on the block
  /// Lower bound of the eigenvalues where the block is symmetric; else the smallest bound of those
  /// rows that alone would be. 0 where nothing but the sign is proven, negative where not even
  /// that.
  double lowest = 1;
  double mean_lowest = 1;  ///< mean of the rows' bounds of the lowest eigenvalue, proven or not
  bool suspect = false;    ///< L may be singular on some component of the block
  Index obstacle = kNone;  ///< a vertex for which no bound is proven, if there is one
  /// The block's rows, where a semi-iteration may run on them and they could be ordered.
  std::shared_ptr<const OrderedRows> ordered = nullptr;
  std::shared_ptr<SpareArrays> spare = nullptr;  ///< for their sweeps

  [[nodiscard]] bool proven() const { return symmetric && lowest > 0; }
};

/// Curves (boundaries and creases) do not look at the surface, so they can be solved first: the
/// paper's section 4, for every rule. Vertices that are their own limit are in no block.
struct Blocks {
  Block curve;
  /// Components of the surface that need the same solver are solved together: all of them, on most
  /// meshes.
  std::vector<Block> surface;
  std::size_t interpolated = 0;  ///< vertices that are to be met, fixed ones included
};

/// `listed` marks the vertices to interpolate (#V).
[[nodiscard]] Blocks find_blocks(const LimitOperator& op, const std::vector<unsigned char>& listed);

/// The connected parts of a block, each ascending: unknowns that see each other, directly or
/// through others.
[[nodiscard]] std::vector<std::vector<Index>> connected_parts(const SparseRows& rows,
                                                              const std::vector<Index>& vertices);

}  // namespace surpass

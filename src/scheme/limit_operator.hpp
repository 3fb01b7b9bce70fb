// The limit operator L of a control mesh, and what is proven about its spectrum.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>
#include <surpass/topology.hpp>

#include <vector>

#include "scheme/sparse_rows.hpp"

namespace surpass {

/// What is known of a row's place in the symmetric form; see the arrays of LimitOperator.
struct RowFacts {
  double weight = 0;
  double lowest = 0;
  bool curve = false;
};

/// limit points = rows * control points; each row sums to 1.
struct LimitOperator {
  SparseRows rows;

  /// #V weights d > 0 such that diag(d) * rows is symmetric among rows of the same kind (surface
  /// rows with surface rows, curve rows with curve rows), or 0 where no such weight exists (darts,
  /// semi-sharp vertices). See the methods page for the proofs.
  std::vector<double> symmetric_weight;

  /// #V lower bounds: a principal submatrix of rows of one kind, all with positive weight, has its
  /// eigenvalues in [smallest of these, 1]; it is singular, if that is 0, only where no row of a
  /// connected part has a positive bound. Negative bounds need not be sharp. 0 where there is no
  /// weight.
  std::vector<double> lowest_eigenvalue;

  /// #V: 1 where the row takes part in curves (boundaries, creases), 0 on the smooth surface.
  std::vector<unsigned char> on_curve;

  /// Room for the facts of n vertices that are their own limits.
  explicit LimitOperator(Index n = 0)
      : symmetric_weight(n, 1.0), lowest_eigenvalue(n, 1.0), on_curve(n, 1) {}
  void note(Index v, const RowFacts& facts) {
    symmetric_weight[v] = facts.weight;
    lowest_eigenvalue[v] = facts.lowest;
    on_curve[v] = facts.curve ? 1 : 0;
  }
};

/// Rows for every vertex. Fails if the scheme does not take the mesh's faces or its creases.
Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                     const Context& context);

}  // namespace surpass

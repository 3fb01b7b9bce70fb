// The interpolation problem as a general solver needs it, written from the formulas alone and
// without the library's code, so that it can also judge the library's results.
#pragma once

#include <surpass/mesh.hpp>

#include <span>
#include <vector>

#include <Eigen/SparseCore>

namespace surpass::bench {

using ColumnMatrix = Eigen::SparseMatrix<double>;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;  ///< a column per coordinate
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  ///< a row per vertex

/// Loop's limit weight of a vertex with n edges: limit = b x + (1 - b) / n * sum of the neighbours.
[[nodiscard]] double limit_weight(Index n);

/// S x = diag(n / (1 - b)) v, the symmetric positive definite form of L x = v on a closed mesh:
/// ones for neighbours and n b / (1 - b) on the diagonal. Compressed, rows ascending in each
/// column.
[[nodiscard]] ColumnMatrix symmetric_system(const Mesh& mesh);
[[nodiscard]] Columns right_hand_sides(const ColumnMatrix& system, std::span<const Point> points);

/// L itself, for evaluating.
[[nodiscard]] RowMatrix limit_matrix(const Mesh& mesh);

[[nodiscard]] Rows as_rows(std::span<const Point> points);
[[nodiscard]] std::vector<Point> as_points(const Columns& columns);

}  // namespace surpass::bench

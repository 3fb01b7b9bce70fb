// Two passes over the faces: in a closed mesh every vertex has as many neighbours as half-edges
// leaving it, and the head of each is one of them.
#include "loop_system.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surpass::bench {
namespace {

// The pattern with ones everywhere; the diagonal is left for the caller.
ColumnMatrix neighbour_matrix(const Mesh& mesh) {
  const auto n = static_cast<Eigen::Index>(mesh.points.size());
  const auto& corners = mesh.face_vertices;
  ColumnMatrix matrix(n, n);
  matrix.resizeNonZeros(n + static_cast<Eigen::Index>(corners.size()));
  int* const start = matrix.outerIndexPtr();
  int* const row = matrix.innerIndexPtr();

  std::fill_n(start, n + 1, 0);
  for (const Index v : corners) ++start[v + 1];
  for (Eigen::Index v = 0; v < n; ++v) start[v + 1] += start[v] + 1;
  std::vector<int> end(start, start + n);
  for (Eigen::Index v = 0; v < n; ++v)
    row[end[static_cast<std::size_t>(v)]++] = static_cast<int>(v);
  for (std::size_t h = 0; h < corners.size(); h += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      row[end[corners[h + k]]++] = static_cast<int>(corners[h + (k + 1) % 3]);
    }
  }
  for (Eigen::Index v = 0; v < n; ++v) std::sort(row + start[v], row + start[v + 1]);
  std::fill_n(matrix.valuePtr(), matrix.nonZeros(), 1.0);
  return matrix;
}

// Limit weights of the valences that occur, computed once each.
std::vector<double> limit_weights(const ColumnMatrix& matrix) {
  const int* const start = matrix.outerIndexPtr();
  int most = 0;
  for (Eigen::Index v = 0; v < matrix.cols(); ++v)
    most = std::max(most, start[v + 1] - start[v] - 1);
  std::vector<double> weights(static_cast<std::size_t>(most) + 1);
  for (std::size_t n = 1; n < weights.size(); ++n) weights[n] = limit_weight(static_cast<Index>(n));
  return weights;
}

}  // namespace

double limit_weight(Index n) {
  const double c = 3.0 / 8 + std::cos(2 * std::numbers::pi / n) / 4;
  return 3 / (11 - 8 * (3.0 / 8 + c * c));
}

ColumnMatrix symmetric_system(const Mesh& mesh) {
  ColumnMatrix system = neighbour_matrix(mesh);
  const auto weights = limit_weights(system);
  const int* const start = system.outerIndexPtr();
  const int* const row = system.innerIndexPtr();
  for (int v = 0; v < system.cols(); ++v) {
    const int valence = start[v + 1] - start[v] - 1;
    const double b = weights[static_cast<std::size_t>(valence)];
    const auto diagonal = std::lower_bound(row + start[v], row + start[v + 1], v) - row;
    system.valuePtr()[diagonal] = valence * b / (1 - b);
  }
  return system;
}

Columns right_hand_sides(const ColumnMatrix& system, std::span<const Point> points) {
  const auto weights = limit_weights(system);
  const int* const start = system.outerIndexPtr();
  Columns right(system.cols(), 3);
  for (Eigen::Index v = 0; v < system.cols(); ++v) {
    const int valence = start[v + 1] - start[v] - 1;
    const double scale = valence / (1 - weights[static_cast<std::size_t>(valence)]);
    const Point& p = points[static_cast<std::size_t>(v)];
    for (Eigen::Index k = 0; k < 3; ++k) right(v, k) = scale * p[static_cast<std::size_t>(k)];
  }
  return right;
}

RowMatrix limit_matrix(const Mesh& mesh) {
  const ColumnMatrix pattern = neighbour_matrix(mesh);  // symmetric, so its columns are its rows
  const auto weights = limit_weights(pattern);
  RowMatrix limit = pattern.transpose();
  for (int v = 0; v < limit.rows(); ++v) {
    const int begin = limit.outerIndexPtr()[v];
    const int end = limit.outerIndexPtr()[v + 1];
    const int valence = end - begin - 1;
    const double b = weights[static_cast<std::size_t>(valence)];
    for (int k = begin; k < end; ++k) {
      limit.valuePtr()[k] = limit.innerIndexPtr()[k] == v ? b : (1 - b) / valence;
    }
  }
  return limit;
}

Rows as_rows(std::span<const Point> points) {
  return Eigen::Map<const Rows>(points.data()->data(), static_cast<Eigen::Index>(points.size()), 3);
}

std::vector<Point> as_points(const Columns& columns) {
  std::vector<Point> points(static_cast<std::size_t>(columns.rows()));
  for (Eigen::Index v = 0; v < columns.rows(); ++v) {
    points[static_cast<std::size_t>(v)] = {columns(v, 0), columns(v, 1), columns(v, 2)};
  }
  return points;
}

}  // namespace surpass::bench

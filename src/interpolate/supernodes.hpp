// In which order a sparse symmetric matrix is decomposed, and which columns of its factor have the
// same rows: they are decomposed together, as dense matrices.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/SparseCore>

namespace surpass {

/// Both triangles are there, with entries at the same places.
using Symmetric = Eigen::SparseMatrix<double>;

/// Eigen's numbers as the standard library has them.
[[nodiscard]] inline std::size_t to_size(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// Columns are numbered in the order of the decomposition.
struct Supernodes {
  std::vector<int> order;   ///< the columns of the matrix, as they are numbered
  std::vector<int> place;   ///< #columns of the matrix: their numbers
  std::vector<int> first;   ///< where the columns of each supernode start; one more at the end
  std::vector<int> parent;  ///< of each: the one that needs it first, a later one, or -1
  std::vector<std::size_t> start;  ///< where the rows of each start; one more at the end
  std::vector<int> row;            ///< of each, ascending: rows below its own columns

  [[nodiscard]] int count() const { return static_cast<int>(parent.size()); }
  [[nodiscard]] int width(int s) const { return first[to_size(s) + 1] - first[to_size(s)]; }
  [[nodiscard]] std::span<const int> rows(int s) const {
    return std::span(row).subspan(start[to_size(s)], start[to_size(s) + 1] - start[to_size(s)]);
  }
};

/// The order is that of approximate minimum degree
/// (Amestoy, Davis, Duff 1996), then by subtrees; supernodes are joined where that adds few zeros
/// (Ashcraft, Grimes, The influence of relaxed supernode partitions on the multifrontal method,
/// 1989). Time and memory are a part of what the decomposition takes.
[[nodiscard]] Supernodes find_supernodes(const Symmetric& matrix);

}  // namespace surpass

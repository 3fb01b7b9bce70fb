// The derivatives of one kind of patch.
#pragma once

#include <surpass/mesh.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace surpass {

/// In parameters that run from 0 to 1 along the sides of the patch.
enum class Derivative : unsigned char { first, second, mixed, third };

/// Neighbouring patches have the samples on a side between them in common.
enum class Sides {
  each,    ///< every patch has the rows of all its samples
  shared,  ///< one patch has those on a side for both, with twice their count and area, where the
           ///< surface is smooth and the side's numbers in the two patches differ: half the work
  joined,  ///< besides, the patches around a vertex are one where Stars finds them: it needs 25
           ///< vertices around a regular one, where four patches need 16 each
};

/// Rows of weights, one a sampled derivative.
struct PatchKind {
  std::size_t columns = 0;             ///< control points that they are taken of
  std::vector<double> weights;         ///< #rows by columns
  std::vector<Derivative> derivative;  ///< #rows
  std::vector<double> count;           ///< #rows: samples that the row stands for
  std::vector<double> area;  ///< #rows: part of the patch, and of its neighbour where sides are
                             ///< shared, around the sample

  [[nodiscard]] std::size_t row_count() const { return derivative.size(); }
  [[nodiscard]] std::span<const double> row(std::size_t r) const {
    return std::span(weights).subspan(r * columns, columns);
  }
  void add(std::span<const double> row, Derivative which, double samples, double part) {
    weights.insert(weights.end(), row.begin(), row.end());
    derivative.push_back(which);
    count.push_back(samples);
    area.push_back(part);
  }
};

}  // namespace surpass

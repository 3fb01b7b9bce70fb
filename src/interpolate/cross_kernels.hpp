// What the similarity of directions does for several patches of a kind at once: their derivatives,
// and the transposed sums.
#pragma once

#include <vector>

#include "interpolate/lanes.hpp"
#include "scheme/patch_kind.hpp"

namespace surpass {

/// The weight of a row times its count, from g.g of the reference's derivative g: numerator /
/// (slope g.g + constant), but 0 where g.g is not above the threshold. All rows of a kind have
/// thresholds, or none has.
template <class Real>
struct RowLaw {
  Real numerator = 0;
  Real slope = 0;
  Real constant = 1;
  Real threshold = -1;

  [[nodiscard]] bool is_bounded() const { return threshold >= 0; }
};

/// The rows of a kind of patch without their zeros, and without mixed derivatives.
struct CrossKind {
  struct Row {
    std::size_t begin;
    std::size_t end;
    double count;
    std::size_t order;  ///< of the derivative, from 0
    double scale;       ///< the functions below find derivatives divided by this
  };
  std::size_t columns = 0;
  std::vector<Row> rows;
  std::vector<unsigned> column;  ///< of row r: column[begin] to column[end - 1]
  std::vector<double> weight;    ///< as many

  /// The other way round: the rows that have a column, and the squares of their weights there,
  /// divided by their scales.
  struct Entry {
    std::size_t row;
    double square;
  };
  std::vector<std::vector<Entry>> of_column;
  /// A regular patch three samples along its side, of which two sides belong to its neighbours: the
  /// rows are found by one refinement, then differences, with a third of the operations.
  bool is_regular = false;
  /// Faces of a star of such patches, for which the same holds, or 0.
  std::size_t star = 0;

  explicit CrossKind(const PatchKind& kind);

  /// Fine points of a star.
  [[nodiscard]] std::size_t fine_points() const;
  /// What the functions below need besides.
  [[nodiscard]] std::size_t work_size() const { return 3 * fine_points() + 2 * rows.size(); }

 private:
  bool add_star(const PatchKind& kind);
  void add(const PatchKind& kind, std::size_t row, double scale);
};

// Points, #columns, hold a patch in every lane; lanes without one are 0. `laws`, #rows, are for the
// functions' own scale, as scaled_laws() makes them. `work` has work_size() places.

/// squares, #rows: g.g.
void squares_of_patches(const CrossKind& kind, const LaneVectors<double>* reference,
                        LaneNumbers* squares, LaneVectors<double>* work);

/// sums, #columns: the gradient at x of half the sum over rows of weight times |g x q|^2, q the
/// derivative of x.
template <class Real>
void gradient_of_patches(const CrossKind& kind, const RowLaw<Real>* laws,
                         const LaneVectors<Real>* reference, const LaneVectors<Real>* x,
                         LaneVectors<Real>* sums, LaneVectors<Real>* work);

/// The upper triangle of a block of 3, row after row.
template <class Real>
struct LaneBlock {
  alignas(kLaneAlignment) Real of[6][kLanes<Real>];
};

/// sums, #columns: the diagonal blocks of the same.
template <class Real>
void diagonal_of_patches(const CrossKind& kind, const RowLaw<Real>* laws,
                         const LaneVectors<Real>* reference, LaneBlock<Real>* sums,
                         LaneVectors<Real>* work);

/// The same laws for derivatives divided by the kind's scales, as parts of the gradient.
[[nodiscard]] std::vector<RowLaw<double>> scaled_laws(const CrossKind& kind,
                                                      const std::vector<RowLaw<double>>& laws);

}  // namespace surpass

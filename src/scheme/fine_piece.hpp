// A piece of a control mesh after some refinements, as weights of the piece's own points.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include <Eigen/Core>

#include "scheme/sharpness.hpp"
#include "scheme/subdivision_scheme.hpp"

namespace surpass {

struct FinePiece {
  Mesh mesh;
  Topology topology;
  Sharpness sharpness;
  /// #points of the mesh by #points of the piece.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> weights;

  /// Vertices with faces that the piece does not have. On refined pieces what these decide is not
  /// a number (NaN), and so is everything that depends on it. They must keep their numbers.
  std::vector<Index> cut = {};

  static Result<FinePiece> as_given(const Mesh& piece, const Rules& rules,
                                    std::span<const Index> cut = {});

  [[nodiscard]] Result<FinePiece> refined(const SubdivisionScheme& scheme, const Rules& rules,
                                          int levels) const;

  [[nodiscard]] bool is_cut(Index v) const {
    return std::find(cut.begin(), cut.end(), v) != cut.end();
  }

  /// Points that are not known.
  void forget(Index v) { weights.row(v).setConstant(std::numeric_limits<double>::quiet_NaN()); }

  /// As over_piece, if that is known.
  template <class Columns>
  [[nodiscard]] std::optional<Eigen::RowVectorXd> known_over_piece(
      const Columns& columns, const std::vector<double>& mask) const {
    Eigen::RowVectorXd row = over_piece(columns, mask);
    if (row.hasNaN()) return {};
    return row;
  }

  /// The sum of mask[i] times point columns[i], as weights of the piece's points.
  template <class Columns>
  [[nodiscard]] Eigen::RowVectorXd over_piece(const Columns& columns,
                                              const std::vector<double>& mask) const {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(weights.cols());
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (mask[i] != 0) row += mask[i] * weights.row(columns[i]);
    }
    return row;
  }
};

}  // namespace surpass

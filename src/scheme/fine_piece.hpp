// A piece of a control mesh after some refinements, as weights of the piece's own points.
#pragma once

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

  static Result<FinePiece> as_given(const Mesh& piece, const Rules& rules);

  [[nodiscard]] Result<FinePiece> refined(const SubdivisionScheme& scheme, const Rules& rules,
                                          int levels) const;

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

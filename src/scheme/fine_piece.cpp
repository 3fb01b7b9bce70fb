#include "scheme/fine_piece.hpp"

#include "scheme/kept_rows.hpp"

namespace surpass {

namespace {

// A vertex without some of its faces, and the points on the edges where these would begin.
void forget_around(Index v, FinePiece& piece) {
  piece.forget(v);
  piece.topology.for_each_spoke(v, [&](Index w, Index e) {
    if (piece.topology.is_boundary_edge(e)) piece.forget(w);
  });
}

}  // namespace

Result<FinePiece> FinePiece::as_given(const Mesh& piece, const Rules& rules,
                                      std::span<const Index> cut) {
  auto topology = Topology::build(piece);
  if (!topology) return tl::make_unexpected(topology.error());
  auto sharpness = Sharpness::build(piece, *topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  const auto n = static_cast<Eigen::Index>(piece.points.size());
  return FinePiece{piece,
                   std::move(*topology),
                   std::move(*sharpness),
                   decltype(weights)::Identity(n, n),
                   {cut.begin(), cut.end()}};
}

Result<FinePiece> FinePiece::refined(const SubdivisionScheme& scheme, const Rules& rules,
                                     int levels) const {
  if (levels == 0) return *this;
  const Context one_thread{.threads = 1};
  KeptRows stencil;
  auto next = scheme.refinement(mesh, topology, rules, one_thread, stencil);
  if (!next) return tl::make_unexpected(next.error());
  next->points.resize(stencil.row_count());
  auto fine = as_given(*next, rules, cut);
  if (!fine) return fine;
  fine->weights = decltype(weights)::Zero(stencil.row_count(), weights.cols());
  for (Index i = 0; i < stencil.row_count(); ++i) {
    const RowView row = stencil.row(i);
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
      fine->weights.row(i) += row.weights[k] * weights.row(row.columns[k]);
    }
  }
  for (const Index v : cut) forget_around(v, *fine);
  return fine->refined(scheme, rules, levels - 1);
}

}  // namespace surpass

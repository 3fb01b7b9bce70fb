#include "scheme/catmull_clark_rows.hpp"

#include <algorithm>

#include "scheme/face_rows.hpp"

namespace surpass::catmull_clark {

Index VertexRows::length(Index v) const {
  if (topology_.is_isolated(v)) return 1;
  if (sharpness_.is_plain(v)) return face_row_length(topology_, v);
  const Mask mask = special_(FaceRing::around(topology_, sharpness_, v));
  return static_cast<Index>(
      std::count_if(mask.begin(), mask.end(), [](double w) { return w != 0; }));
}

void VertexRows::fill(Index v, std::span<Index> columns, std::span<double> weights) const {
  if (topology_.is_isolated(v)) {
    columns[0] = v;
    weights[0] = 1;
    return;
  }
  if (sharpness_.is_plain(v)) {
    const PlainRow row = plain_(topology_.valence(v));
    fill_face_row(topology_, v, columns, weights, [&](Index m, Index j) {
      return row.face / static_cast<double>(m) + (j == 1 ? row.spoke : 0);
    });
    weights[0] += row.center;
    for (double& w : weights) w /= row.sum;
    return;
  }
  fill_special(FaceRing::around(topology_, sharpness_, v), columns, weights);
}

void VertexRows::add(Index v, RowTile& tile) const {
  if (topology_.is_isolated(v) || sharpness_.is_plain(v)) {
    const auto [columns, weights] = tile.add_row(length(v));
    fill(v, columns, weights);
    return;
  }
  const FaceRing ring = FaceRing::around(topology_, sharpness_, v);
  const auto [columns, weights] = tile.add_row(ring.columns.size());
  tile.shorten_row(fill_special(ring, columns, weights));
}

std::size_t VertexRows::fill_special(const FaceRing& ring, std::span<Index> columns,
                                     std::span<double> weights) const {
  const Mask mask = special_(ring);
  std::size_t k = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    columns[k] = ring.columns[i];
    weights[k++] = mask[i];
  }
  return k;
}

}  // namespace surpass::catmull_clark

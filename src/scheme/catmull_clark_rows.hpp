// Rows of weights over the rings of vertices: refined positions and limit positions alike.
#pragma once

#include <span>

#include "scheme/catmull_clark_masks.hpp"
#include "scheme/row_sink.hpp"

namespace surpass::catmull_clark {

class VertexRows {
 public:
  using Plain = PlainRow (*)(std::size_t valence);
  using Special = Mask (*)(const FaceRing& ring);

  /// `plain` is used where no crease, corner or boundary is near, `special` elsewhere.
  VertexRows(const Topology& topology, const Sharpness& sharpness, Plain plain, Special special)
      : topology_(topology), sharpness_(sharpness), plain_(plain), special_(special) {}

  [[nodiscard]] Index length(Index v) const;
  void fill(Index v, std::span<Index> columns, std::span<double> weights) const;
  /// The same as one more row of a tile.
  void add(Index v, RowTile& tile) const;

 private:
  // Without the zeros; how many entries.
  std::size_t fill_special(const FaceRing& ring, std::span<Index> columns,
                           std::span<double> weights) const;

  const Topology& topology_;
  const Sharpness& sharpness_;
  Plain plain_;
  Special special_;
};

}  // namespace surpass::catmull_clark

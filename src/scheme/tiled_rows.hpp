// Rows of weights made ready for being applied many times: the fast kernel, bit for bit the plain
// RowView.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

#include "scheme/row_sink.hpp"

namespace surpass {

/// In every tile the rows lie in the order of their lengths and weights; rows with the same weights
/// share them. So the loop over the entries of a row has a constant length, which the processor
/// need not guess, its weights stay in registers, and 4 bytes an entry and 2 a row are all that is
/// read besides the values.
class TiledRows final : public RowSink {
 public:
  void expect(Index rows) override;
  void take(Index first, const RowTile& rows) override;

  [[nodiscard]] Index row_count() const { return row_count_; }

  /// y = rows * x for row-major values of `width` numbers each. x: #columns by width, y: #rows by
  /// width.
  void apply(const Context& context, std::size_t width, std::span<const double> x,
             std::span<double> y) const;

  /// Consecutive rows with the same weights, which start at `weights`.
  struct Run {
    Index rows = 0;
    Index length = 0;
    Index weights = 0;
  };
  struct Tile {
    std::vector<Run> runs;
    std::vector<std::uint16_t> order;  // row in the tile, run after run
    std::vector<Index> columns;        // row after row in this order
    std::vector<double> weights;
  };

 private:
  Index row_count_ = 0;
  std::vector<Tile> tiles_;
};

}  // namespace surpass

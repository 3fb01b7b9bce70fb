// Rows that are kept as they come, to be read one by one: for small meshes.
#pragma once

#include <vector>

#include "scheme/row_sink.hpp"

namespace surpass {

class KeptRows final : public RowSink {
 public:
  void expect(Index rows) override {
    row_count_ = rows;
    tiles_.resize((rows + kTile - 1) / kTile);
  }
  void take(Index first, const RowTile& rows) override { tiles_[first / kTile] = rows; }

  [[nodiscard]] Index row_count() const { return row_count_; }
  [[nodiscard]] RowView row(Index i) const { return tiles_[i / kTile].row(i % kTile); }

 private:
  Index row_count_ = 0;
  std::vector<RowTile> tiles_;
};

}  // namespace surpass

// What becomes of the rows that refinement makes.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>

#include <utility>
#include <vector>

#include "scheme/sparse_rows.hpp"
#include "scheme/tiled_rows.hpp"

namespace surpass {

/// Carries positions and vertex channels from mesh to mesh. The rows of every step are applied as
/// they come and forgotten; or they are kept, for other values on the same topology.
class Steps {
 public:
  explicit Steps(bool keep = false) : keep_(keep) {}

  /// make(sink) gives a mesh without positions and vertex channels, or an error, and hands rows to
  /// `sink`: one for each of the mesh's vertices, over those of `from`.
  template <class Make>
  Result<Mesh> take(const Mesh& from, const Context& context, Make&& make);

  /// Replaces the values of a mesh by the rows times them.
  void move(Mesh& mesh, const SparseRows& rows, const Context& context);

  /// Of the values only those of these vertices go on, in this order. What they are carried by
  /// does that by itself.
  void pick(const std::vector<Index>& vertices, const Context& context);

  /// In the order in which they were taken.
  [[nodiscard]] std::vector<TiledRows> kept() && { return std::move(kept_); }

 private:
  bool keep_;
  std::vector<TiledRows> kept_;
};

/// Rows that are applied to a mesh's positions and vertex channels as they come.
class AppliedRows final : public RowSink {
 public:
  explicit AppliedRows(const Mesh& from) : from_(from) {}
  void expect(Index rows) override;
  void take(Index first, const RowTile& rows) override;
  /// Gives the products to a mesh that has none yet.
  void put_into(Mesh& mesh) &&;

 private:
  const Mesh& from_;
  std::vector<Point> points_;
  std::vector<Channel> channels_;
};

/// The same with rows that are ready.
void apply(const TiledRows& rows, const Mesh& from, Mesh& to, const Context& context);

template <class Make>
Result<Mesh> Steps::take(const Mesh& from, const Context& context, Make&& make) {
  if (!keep_) {
    AppliedRows rows(from);
    Result<Mesh> made = make(rows);
    if (made) std::move(rows).put_into(*made);
    return made;
  }
  TiledRows rows;
  Result<Mesh> made = make(rows);
  if (!made) return made;
  apply(rows, from, *made, context);
  kept_.push_back(std::move(rows));
  return made;
}

}  // namespace surpass

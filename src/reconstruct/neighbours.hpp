// Nearest neighbours among points.
#pragma once

#include <surpass/mesh.hpp>

#include <memory>
#include <span>
#include <vector>

namespace surpass::reconstruction {

/// A k-d tree over points, which must be finite and outlive it. Threads may share it.
class Neighbours {
 public:
  explicit Neighbours(std::span<const Point> points);
  ~Neighbours();
  Neighbours(const Neighbours&) = delete;
  Neighbours& operator=(const Neighbours&) = delete;

  /// The k points nearest to point i, itself left out, nearest first, into `found` (fewer where
  /// there are not as many).
  void nearest(Index i, std::size_t k, std::vector<Index>& found) const;

  /// Every point once, near ones near each other: who asks in this order stays in the cache.
  [[nodiscard]] std::span<const Index> in_space() const;

 private:
  struct Tree;
  std::span<const Point> points_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace surpass::reconstruction

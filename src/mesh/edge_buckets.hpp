// Half-edges sorted by their smaller end vertex: the common start of everything that looks for the
// faces at an edge.
#pragma once

#include <surpass/result.hpp>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace surpass {

/// A half-edge in the bucket of its smaller end vertex.
struct BucketEntry {
  Index larger;                  ///< the other end vertex
  Index halfedge_and_direction;  ///< number * 2 + (1 if it runs from the larger vertex)
  [[nodiscard]] Index halfedge() const { return halfedge_and_direction >> 1; }
  [[nodiscard]] bool reversed() const { return (halfedge_and_direction & 1) != 0; }
};

/// Most vertices and face corners that a mesh may have: half-edge numbers keep a bit for the
/// direction.
inline constexpr Index kMostCorners = kNone / 2;

/// Above this many entries a bucket is sorted rather than searched: a vertex can have any valence.
inline constexpr std::size_t kSearchedBucket = 32;

/// One counting sort over all faces. Inside a bucket half-edges are in the order of faces, and the
/// last half-edge of a face comes first.
class EdgeBuckets {
 public:
  /// Faces f with skip[f] != 0 are left out; `skip` may be empty. O(#corners + vertex_count).
  EdgeBuckets(Index vertex_count, std::span<const Index> face_offsets,
              std::span<const Index> face_vertices, std::span<const unsigned char> skip = {});

  [[nodiscard]] std::span<BucketEntry> operator[](Index v) {
    return {entries_.get() + start_[v], start_[v + 1] - start_[v]};
  }

  /// Sorts a bucket by edge, and by half-edge within an edge.
  static void sort(std::span<BucketEntry> bucket) {
    std::sort(bucket.begin(), bucket.end(), [](const BucketEntry& a, const BucketEntry& b) {
      return a.larger != b.larger ? a.larger < b.larger
                                  : a.halfedge_and_direction < b.halfedge_and_direction;
    });
  }

 private:
  std::vector<Index> start_;
  std::unique_ptr<BucketEntry[]> entries_;  // not a vector: writing 8 bytes a corner twice costs
};

}  // namespace surpass

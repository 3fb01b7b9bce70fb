#include "mesh/edge_conflict.hpp"

#include <algorithm>

#include "mesh/edge_buckets.hpp"
#include "mesh/refusals.hpp"

namespace surpass {
namespace {

// The next entry with this larger vertex, or the bucket's size. Large buckets are sorted, so there
// only one place is possible.
std::size_t find_same_edge(std::span<const BucketEntry> bucket, std::size_t from, Index larger) {
  const std::size_t end =
      bucket.size() > kSearchedBucket ? std::min(from + 1, bucket.size()) : bucket.size();
  for (std::size_t i = from; i < end; ++i) {
    if (bucket[i].larger == larger) return i;
  }
  return bucket.size();
}

// The larger vertex of the first edge in the bucket that conflicts, or kNone.
Index conflict_in(std::span<const BucketEntry> bucket) {
  for (std::size_t i = 0; i < bucket.size(); ++i) {
    const BucketEntry& entry = bucket[i];
    const std::size_t partner = find_same_edge(bucket, i + 1, entry.larger);
    if (partner == bucket.size()) continue;
    if (entry.reversed() == bucket[partner].reversed() ||
        find_same_edge(bucket, partner + 1, entry.larger) != bucket.size()) {
      return entry.larger;
    }
  }
  return kNone;
}

// The exact account of an edge that failed: how many faces, and one of them.
Error account_of(const Mesh& mesh, Index a, Index b) {
  Index faces = 0;
  Index first = kNone;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Index p = face[k];
      const Index q = face[k + 1 == face.size() ? 0 : k + 1];
      if ((p == a && q == b) || (p == b && q == a)) {
        ++faces;
        if (first == kNone) first = f;
      }
    }
  }
  return faces > 2 ? refusal::non_manifold_edge(first, {a, b}, faces)
                   : refusal::inconsistent_orientation(first, {a, b});
}

}  // namespace

Error edge_conflict(const Mesh& mesh) {
  EdgeBuckets buckets(mesh.vertex_count(), mesh.face_offsets, mesh.face_vertices);
  for (Index v = 0; v + 1 < mesh.vertex_count(); ++v) {
    const auto bucket = buckets[v];
    if (bucket.size() > kSearchedBucket) EdgeBuckets::sort(bucket);
    if (const Index larger = conflict_in(bucket); larger != kNone) {
      return account_of(mesh, v, larger);
    }
  }
  return {};
}

}  // namespace surpass

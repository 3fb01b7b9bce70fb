#include "mesh/edge_buckets.hpp"

#include <numeric>

namespace surpass {

EdgeBuckets::EdgeBuckets(Index vertex_count, std::span<const Index> face_offsets,
                         std::span<const Index> face_vertices, std::span<const unsigned char> skip)
    : start_(static_cast<std::size_t>(vertex_count) + 2, 0),
      entries_(new BucketEntry[face_vertices.size()]) {
  const auto for_each_halfedge = [&](auto&& visit) {
    for (std::size_t f = 0; f + 1 < face_offsets.size(); ++f) {
      if (!skip.empty() && skip[f] != 0) continue;
      const Index end = face_offsets[f + 1];
      if (end == face_offsets[f]) continue;
      Index h = end - 1;
      Index a = face_vertices[h];
      for (Index k = face_offsets[f]; k < end; ++k) {
        const Index b = face_vertices[k];
        visit(h, a, b);
        a = b;
        h = k;
      }
    }
  };
  // Bucket v starts at start_[v + 1] while filling, and at start_[v] once every entry is in place.
  for_each_halfedge([&](Index, Index a, Index b) { ++start_[std::min(a, b) + 2]; });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  for_each_halfedge([&](Index h, Index a, Index b) {
    entries_[start_[std::min(a, b) + 1]++] = {std::max(a, b), h * 2 + (a > b ? 1U : 0U)};
  });
}

}  // namespace surpass

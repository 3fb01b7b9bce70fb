#include "mesh/edge_table.hpp"

#include "mesh/edge_buckets.hpp"

namespace surpass {

EdgeTable::EdgeTable(const Mesh& mesh, std::span<const unsigned char> skip)
    : edge_(mesh.face_vertices.size(), kNone), ascends_(mesh.face_vertices.size(), 0) {
  EdgeBuckets buckets(mesh.vertex_count(), mesh.face_offsets, mesh.face_vertices, skip);
  halfedges_.reserve(mesh.face_vertices.size());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto bucket = buckets[v];
    EdgeBuckets::sort(bucket);
    Index larger = v;
    for (const BucketEntry& entry : bucket) {
      if (entry.larger == v) continue;
      if (entry.larger != larger) {
        larger = entry.larger;
        vertices_.push_back({v, larger});
        begin_.push_back(begin_.back());
      }
      ++begin_.back();
      halfedges_.push_back(entry.halfedge());
      edge_[entry.halfedge()] = edge_count() - 1;
      ascends_[entry.halfedge()] = entry.reversed() ? 0 : 1;
    }
  }
}

}  // namespace surpass

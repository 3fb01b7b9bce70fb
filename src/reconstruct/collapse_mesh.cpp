#include "reconstruct/collapse_mesh.hpp"

#include <algorithm>

namespace surpass::reconstruction {

CollapseMesh::CollapseMesh(const Mesh& mesh)
    : vertices_(mesh.face_vertices),
      first_(mesh.points.size(), kNone),
      next_(mesh.face_vertices.size(), kNone),
      gone_(mesh.face_count(), 0),
      round_of_(mesh.points.size(), 0) {
  for (Index c = 0; c < vertices_.size(); ++c) {
    next_[c] = first_[vertices_[c]];
    first_[vertices_[c]] = c;
  }
}

void CollapseMesh::neighbours(Index v, std::vector<Index>& found) {
  found.clear();
  if (++round_ == 0) {  // after four thousand million calls
    std::fill(round_of_.begin(), round_of_.end(), 0);
    round_ = 1;
  }
  for_each_corner(v, [&](Index c) {
    for (const Index u : {vertices_[next(c)], vertices_[next(next(c))]}) {
      if (round_of_[u] == round_) continue;
      round_of_[u] = round_;
      found.push_back(u);
    }
  });
}

void CollapseMesh::unlink(Index corner) {
  Index* link = &first_[vertices_[corner]];
  while (*link != corner) link = &next_[*link];
  *link = next_[corner];
}

void CollapseMesh::collapse(Index v, Index w) {
  for (Index c = first_[v]; c != kNone;) {
    const Index after = next_[c];
    const Index b = next(c);
    const Index d = next(b);
    if (vertices_[b] == w || vertices_[d] == w) {
      gone_[c / 3] = 1;
      unlink(b);
      unlink(d);
    } else {
      vertices_[c] = w;
      next_[c] = first_[w];
      first_[w] = c;
    }
    c = after;
  }
  first_[v] = kNone;
}

}  // namespace surpass::reconstruction

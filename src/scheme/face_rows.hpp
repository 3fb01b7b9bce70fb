// Rows over a plain vertex and the faces around it, as the schemes for polygons have them.
#pragma once

#include <surpass/topology.hpp>

#include <span>

namespace surpass {

/// Columns of such a row: v, then for each face from an outgoing half-edge on its next vertex (the
/// spoke) and its further vertices up to the next spoke. v must have one closed fan.
[[nodiscard]] inline Index face_row_length(const Topology& topology, Index v) {
  if (topology.common_degree() != 0) {
    return 1 + topology.faces_at(v) * (topology.common_degree() - 2);
  }
  Index length = 1;
  topology.for_each_outgoing(
      v, [&](Index h) { length += topology.face_degree(topology.face(h)) - 2; });
  return length;
}

/// weight(m, j) is the part that corner j of an m-gon, counted from v, has of that face. Each
/// spoke receives from its two faces.
template <class Weight>
void fill_face_row(const Topology& topology, Index v, std::span<Index> columns,
                   std::span<double> weights, Weight&& weight) {
  columns[0] = v;
  weights[0] = 0;
  std::size_t k = 1;
  double carried = 0;  // from the face before, on the spoke to come
  topology.for_each_outgoing(v, [&](Index h) {
    const Index m = topology.face_degree(topology.face(h));
    weights[0] += weight(m, Index{0});
    Index at = topology.next(h);
    for (Index j = 1; j + 1 < m; ++j, at = topology.next(at), ++k) {
      columns[k] = topology.tail(at);
      weights[k] = weight(m, j) + (j == 1 ? carried : 0);
    }
    carried = weight(m, m - 1);
  });
  weights[1] += carried;
}

}  // namespace surpass

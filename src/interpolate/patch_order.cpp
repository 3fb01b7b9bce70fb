#include "interpolate/patch_order.hpp"

namespace surpass {
namespace {

// `patch`: of each face or vertex, kNone where it has none. of_patch(p, x, use) calls use(y) for
// those that may have the patch p of x, and beside(x, use) for the neighbours of x.
template <class OfPatch, class Beside>
std::vector<Index> grown(const PatchRows& rows, std::vector<Index> patch, std::size_t columns,
                         OfPatch&& of_patch, Beside&& beside) {
  std::vector<Index> order;
  order.reserve(rows.patch_count());
  std::vector<Index> group;  // those that have grown come first
  for (Index seed = 0; seed < patch.size(); ++seed) {
    if (patch[seed] == kNone) continue;
    group.clear();
    std::size_t size = 0;
    const auto take = [&](Index x) {
      const Index p = patch[x];
      order.push_back(p);
      size += rows.kind(p).columns;
      of_patch(p, x, [&](Index y) {
        if (patch[y] != p) return;
        group.push_back(y);
        patch[y] = kNone;
      });
    };
    take(seed);
    for (std::size_t k = 0; k < group.size() && size < columns; ++k) {
      beside(group[k], [&](Index neighbour) {
        if (patch[neighbour] != kNone && size < columns) take(neighbour);
      });
    }
  }
  return order;
}

}  // namespace

std::vector<Index> patches_by_neighbourhood(const Topology& topology, const PatchRows& rows,
                                            std::size_t columns) {
  const std::size_t patches = rows.patch_count();
  if (!rows.vertices().empty()) {
    std::vector<Index> patch(topology.vertex_count(), kNone);
    for (Index p = 0; p < patches; ++p) patch[rows.vertices()[p]] = p;
    return grown(
        rows, std::move(patch), columns, [](Index, Index v, auto&& use) { use(v); },
        [&](Index v, auto&& use) { topology.for_each_spoke(v, [&](Index w, Index) { use(w); }); });
  }
  const auto of_faces = rows.patches_of_faces();
  return grown(
      rows, {of_faces.begin(), of_faces.end()}, columns,
      [&](Index p, Index, auto&& use) {
        // Faces of one patch meet at its first vertex.
        topology.for_each_outgoing(rows.columns(p)[0], [&](Index h) { use(topology.face(h)); });
      },
      [&](Index f, auto&& use) {
        for (Index h = topology.face_begin(f); h < topology.face_end(f); ++h) {
          const Index o = topology.opposite(h);
          if (o != kNone) use(topology.face(o));
        }
      });
}

}  // namespace surpass

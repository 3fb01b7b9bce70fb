#include "interpolate/patch_order.hpp"

namespace surpass {
namespace {

// `patch`: of each face or vertex, kNone where it has none. visit(x, use) calls use(neighbour).
template <class Visit>
std::vector<Index> grown(std::vector<Index> patch, std::size_t patches, std::size_t size,
                         Visit&& visit) {
  std::vector<Index> order;
  order.reserve(patches);
  std::vector<Index> group;  // those that have grown come first
  for (Index seed = 0; seed < patch.size(); ++seed) {
    if (patch[seed] == kNone) continue;
    group.clear();
    const auto take = [&](Index x) {
      group.push_back(x);
      order.push_back(patch[x]);
      patch[x] = kNone;
    };
    take(seed);
    for (std::size_t k = 0; k < group.size() && group.size() < size; ++k) {
      visit(group[k], [&](Index neighbour) {
        if (patch[neighbour] != kNone && group.size() < size) take(neighbour);
      });
    }
  }
  return order;
}

}  // namespace

std::vector<Index> patches_by_neighbourhood(const Topology& topology, const PatchRows& rows,
                                            std::span<const unsigned char> sampled,
                                            std::size_t size) {
  const std::size_t patches = rows.patch_count();
  if (!rows.vertices().empty()) {
    std::vector<Index> patch(topology.vertex_count(), kNone);
    for (Index p = 0; p < patches; ++p) patch[rows.vertices()[p]] = p;
    return grown(std::move(patch), patches, size, [&](Index v, auto&& use) {
      topology.for_each_spoke(v, [&](Index w, Index) { use(w); });
    });
  }
  std::vector<Index> patch(topology.face_count(), kNone);
  Index count = 0;
  for (Index f = 0; f < topology.face_count(); ++f) {
    if (patches > 0 && (sampled.empty() || sampled[f] != 0)) patch[f] = count++;
  }
  return grown(std::move(patch), patches, size, [&](Index f, auto&& use) {
    for (Index h = topology.face_begin(f); h < topology.face_end(f); ++h) {
      const Index o = topology.opposite(h);
      if (o != kNone) use(topology.face(o));
    }
  });
}

}  // namespace surpass

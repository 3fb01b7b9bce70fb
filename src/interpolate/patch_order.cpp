#include "interpolate/patch_order.hpp"

namespace surpass {

std::vector<Index> patches_by_neighbourhood(const Topology& topology,
                                            std::span<const unsigned char> sampled,
                                            std::size_t size) {
  const Index faces = topology.face_count();
  std::vector<Index> patch(faces, kNone);  // of faces that are still free
  Index count = 0;
  for (Index f = 0; f < faces; ++f) {
    if (sampled.empty() || sampled[f] != 0) patch[f] = count++;
  }
  std::vector<Index> order;
  order.reserve(count);
  std::vector<Index> group;  // its faces; those that have grown come first
  for (Index seed = 0; seed < faces; ++seed) {
    if (patch[seed] == kNone) continue;
    group.clear();
    const auto take = [&](Index f) {
      group.push_back(f);
      order.push_back(patch[f]);
      patch[f] = kNone;
    };
    take(seed);
    for (std::size_t k = 0; k < group.size() && group.size() < size; ++k) {
      const Index f = group[k];
      for (Index h = topology.face_begin(f); h < topology.face_end(f); ++h) {
        const Index o = topology.opposite(h);
        if (o == kNone || patch[topology.face(o)] == kNone || group.size() == size) continue;
        take(topology.face(o));
      }
    }
  }
  return order;
}

}  // namespace surpass

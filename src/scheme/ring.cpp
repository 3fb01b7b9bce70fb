#include "scheme/ring.hpp"

#include <algorithm>

namespace surpass {

Ring Ring::around(const Topology& topology, const Sharpness& sharpness, Index v) {
  Ring ring;
  ring.center = v;
  ring.sharpness = sharpness.vertex(v);
  ring.open = topology.is_boundary(v);
  const std::size_t most = std::size_t{topology.faces_at(v)} + 1;
  ring.spokes.reserve(most);
  ring.spoke_sharpness.reserve(most);
  topology.for_each_spoke(v, [&](Index w, Index e) {
    ring.spokes.push_back(w);
    ring.spoke_sharpness.push_back(sharpness.edge(topology, e));
  });
  return ring;
}

std::vector<std::size_t> Ring::sharp_spokes() const {
  std::vector<std::size_t> sharp;
  for (std::size_t j = 0; j < size(); ++j) {
    if (spoke_sharpness[j] > 0) sharp.push_back(j);
  }
  return sharp;
}

VertexRule Ring::rule() const {
  if (sharpness > 0) return VertexRule::corner;
  const auto sharp =
      std::count_if(spoke_sharpness.begin(), spoke_sharpness.end(), [](float s) { return s > 0; });
  switch (sharp) {
    case 0: return VertexRule::smooth;
    case 1: return VertexRule::dart;
    case 2: return VertexRule::crease;
    default: return VertexRule::corner;
  }
}

bool Ring::is_semi_sharp() const {
  return surpass::is_semi_sharp(sharpness) ||
         std::any_of(spoke_sharpness.begin(), spoke_sharpness.end(),
                     [](float s) { return surpass::is_semi_sharp(s); });
}

Ring Ring::child() const {
  Ring ring = *this;
  ring.sharpness = child_sharpness(sharpness);
  for (float& s : ring.spoke_sharpness) s = child_sharpness(s);
  return ring;
}

std::vector<Sector> sectors(const Ring& ring) {
  const std::vector<std::size_t> sharp = ring.sharp_spokes();
  const std::size_t n = ring.size();
  std::vector<Sector> found;
  if (sharp.size() < 2) {
    for (std::size_t j = 0; j < n; ++j) found.push_back({j, 1});
    return found;
  }
  for (std::size_t i = 0; i < sharp.size(); ++i) {
    const bool last = i + 1 == sharp.size();
    if (ring.open && last) break;  // nothing is behind the last spoke
    const std::size_t next = sharp[last ? 0 : i + 1];
    found.push_back({sharp[i], (next + n - sharp[i] - 1) % n + 1});
  }
  return found;
}

float transitional_weight(const Ring& parent, const Ring& child) {
  float sum = 0;
  int count = 0;
  const auto add = [&](float before, float after) {
    if (before > 0 && after <= 0) {
      sum += before;
      ++count;
    }
  };
  add(parent.sharpness, child.sharpness);
  for (std::size_t j = 0; j < parent.size(); ++j) {
    add(parent.spoke_sharpness[j], child.spoke_sharpness[j]);
  }
  return count == 0 ? 0.0F : std::min(1.0F, sum / static_cast<float>(count));
}

}  // namespace surpass

#include "scheme/patch_star.hpp"

#include <algorithm>
#include <utility>

namespace surpass {

bool Stars::find(Index v) {
  const Index n = topology_.faces_at(v);
  if (n < kFewestFaces || n > kMostFaces || !sharpness_.is_plain(v)) return false;
  vertices_.assign(1, v);
  bool found = true;
  topology_.for_each_outgoing(v, [&](Index h) { found = found && add_face(h); });
  return found && all_different();
}

// The face of h, half-edge 0 of it, and what lies beyond its sides 1 and 2 and its corner 2. Where
// corners are plain there is something everywhere.
bool Stars::add_face(Index h) {
  if (h % 4 != 0 || (!sampled_.empty() && sampled_[topology_.face(h)] == 0)) return false;
  if (!is_regular(topology_.tail(h + 1)) || !is_regular(topology_.tail(h + 2))) return false;
  const Index right = topology_.opposite(h + 1);
  const Index above = topology_.opposite(h + 2);
  if (!is_beside(right, 2) || !is_beside(above, 1)) return false;
  const Index beyond = topology_.opposite(topology_.previous(right));
  const Index corner = topology_.next(beyond);
  vertices_.insert(vertices_.end(),
                   {topology_.tail(h + 1), topology_.tail(h + 2),
                    topology_.tail(topology_.next(topology_.next(right))), topology_.tail(corner),
                    topology_.head(corner), topology_.head(topology_.next(above))});
  return true;
}

bool Stars::all_different() {
  const Index centre = vertices_.front();
  return std::all_of(vertices_.begin(), vertices_.end(),
                     [&](Index v) { return std::exchange(seen_[v], centre) != centre; });
}

}  // namespace surpass

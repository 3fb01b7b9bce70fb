#include "reconstruct/lines.hpp"

#include <algorithm>

namespace surpass::reconstruction {

Lines::Lines(const Topology& topology, const Features& features)
    : freedom_(topology.vertex_count(), Freedom::anywhere),
      line_(topology.vertex_count(), {kNone, kNone}),
      is_crease_(topology.vertex_count(), 0),
      gone_(topology.vertex_count(), 0) {
  std::vector<Index> count(topology.vertex_count(), 0);
  std::vector<Index> crease_count(topology.vertex_count(), 0);
  const auto note = [&](Index v, Index w) {
    if (count[v] < 2) line_[v][count[v]] = w;
    ++count[v];
  };
  for (Index h = 0; h < topology.corner_count(); ++h) {
    if (topology.opposite(h) != kNone) continue;
    note(topology.tail(h), topology.head(h));
    note(topology.head(h), topology.tail(h));
  }
  for (const auto& [a, b] : features.creases) {
    note(a, b);
    note(b, a);
    ++crease_count[a];
    ++crease_count[b];
  }
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (count[v] == 2 && crease_count[v] != 1) {
      freedom_[v] = Freedom::along_line;
      is_crease_[v] = crease_count[v] == 2 ? 1 : 0;
    } else if (count[v] != 0) {
      freedom_[v] = Freedom::nowhere;
    }
    if (topology.is_bowtie(v)) freedom_[v] = Freedom::nowhere;
  }
  for (const Index v : features.corners) freedom_[v] = Freedom::nowhere;
  for (const auto& [a, b] : features.creases) {
    if (freedom_[a] == Freedom::nowhere && freedom_[b] == Freedom::nowhere) {
      between_.push_back({a, b});
    }
  }
}

// A curve of three vertices must not become one edge, there and back.
bool Lines::would_close_up(Index v, Index w) const {
  const Index end = other_end(v, w);
  if (end == w) return true;
  const auto follows = [&](Index a, Index b) {
    return freedom_[a] == Freedom::along_line && (line_[a][0] == b || line_[a][1] == b);
  };
  if (follows(w, end) || follows(end, w)) return true;
  return std::find_if(between_.begin(), between_.end(), [&](const auto& e) {
           return (e[0] == w && e[1] == end) || (e[0] == end && e[1] == w);
         }) != between_.end();
}

void Lines::relink(Index v, Index from, Index to) {
  if (freedom_[v] != Freedom::along_line) return;
  for (Index& end : line_[v]) {
    if (end == from) {
      end = to;
      return;
    }
  }
}

void Lines::collapse(Index v, Index w) {
  gone_[v] = 1;
  if (freedom_[v] != Freedom::along_line) return;
  const Index end = other_end(v, w);
  relink(w, v, end);
  relink(end, v, w);
  if (is_crease_[v] != 0 && freedom_[w] == Freedom::nowhere && freedom_[end] == Freedom::nowhere) {
    between_.push_back({w, end});
  }
}

std::vector<std::array<Index, 2>> Lines::creases() const {
  std::vector<std::array<Index, 2>> edges = between_;
  for (Index v = 0; v < freedom_.size(); ++v) {
    if (gone_[v] != 0 || is_crease_[v] == 0 || freedom_[v] != Freedom::along_line) continue;
    for (const Index w : line_[v]) {
      if (freedom_[w] != Freedom::along_line || v < w) edges.push_back({v, w});
    }
  }
  return edges;
}

}  // namespace surpass::reconstruction

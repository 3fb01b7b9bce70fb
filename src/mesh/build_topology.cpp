// Corners are sorted by their vertex. At a vertex, each half-edge that enters meets the one that
// leaves to where it came from: that is its opposite, and from corner to corner it is the way
// around. So opposites, fans and bow-ties are all found from the few corners of one vertex.
#include <surpass/topology.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>

#include "mesh/corner_faces.hpp"
#include "mesh/edge_buckets.hpp"
#include "mesh/edge_conflict.hpp"
#include "mesh/refusals.hpp"

namespace surpass {
namespace {

// So many corners ahead, memory is asked for.
constexpr std::size_t kAhead = 32;

struct Neighbours {
  Index before;
  Index after;
};

// All faces have this many corners.
template <Index kDegree>
struct UniformFaces {
  [[nodiscard]] Index begin(Index f) const { return f * kDegree; }
  // The half-edges of the same face around h.
  [[nodiscard]] Neighbours around(Index h) const {
    constexpr Index kLast = kDegree - 1;
    const Index k = h % kDegree;
    return {k == 0 ? h + kLast : h - 1, k == kLast ? h - kLast : h + 1};
  }
};

struct MixedFaces {
  const Index* offsets;
  const Index* face_of;
  [[nodiscard]] Index begin(Index f) const { return offsets[f]; }
  [[nodiscard]] Neighbours around(Index h) const {
    const Index begin = offsets[face_of[h]];
    const Index last = offsets[face_of[h] + 1] - 1;
    return {h == begin ? last : h - 1, h == last ? begin : h + 1};
  }
};

bool all_have_degree(const Mesh& mesh, Index degree) {
  const std::vector<Index>& offsets = mesh.face_offsets;
  if (mesh.face_vertices.size() != std::size_t{degree} * (offsets.size() - 1)) return false;
  constexpr std::size_t kAtOnce = 1024;  // without a look in between
  for (std::size_t f = 0; f < offsets.size();) {
    const std::size_t end = std::min(f + kAtOnce, offsets.size());
    Index others = 0;
    for (; f < end; ++f) others |= offsets[f] ^ static_cast<Index>(f * degree);
    if (others != 0) return false;
  }
  return true;
}

// 3 or 4 if all faces have that many corners, else 0.
Index degree_of_all_faces(const Mesh& mesh) {
  return all_have_degree(mesh, 3) ? 3 : all_have_degree(mesh, 4) ? 4 : 0;
}

// The quick answer for nearly all faces of nearly all meshes.
bool is_sound(std::span<const Index> face, std::size_t vertex_count) {
  if (face.size() == 3) {
    const Index a = face[0];
    const Index b = face[1];
    const Index c = face[2];
    return a != b && b != c && c != a && std::max({a, b, c}) < vertex_count;
  }
  if (face.size() == 4) {
    const Index a = face[0];
    const Index b = face[1];
    const Index c = face[2];
    const Index d = face[3];
    return a != b && b != c && c != d && d != a && a != c && b != d &&
           std::max({a, b, c, d}) < vertex_count;
  }
  return false;
}

// Checks the faces, copies them and counts corners in one pass. `rank` is filled with how many
// corners came before each at its vertex.
template <class Faces>
std::optional<Error> take_faces(const Mesh& mesh, const Faces& faces, Index* face_vertices,
                                Index* corners_at, Index* rank) {
  refusal::FaceCheck check(mesh);
  const std::size_t vertex_count = mesh.points.size();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index begin = faces.begin(f);
    const std::span<const Index> face(mesh.face_vertices.data() + begin,
                                      faces.begin(f + 1) - begin);
    if (!is_sound(face, vertex_count)) {
      if (auto error = check(f)) return error;
    }
    for (std::size_t k = 0; k < face.size(); ++k) {
      face_vertices[begin + k] = face[k];
      rank[begin + k] = corners_at[face[k]]++;
    }
  }
  return std::nullopt;
}

// Sorts corners by their vertex, ascending at each. Thanks to the ranks no place depends on what
// was just written, so that several are found at a time.
void sort_corners(std::span<const Index> face_vertices, const Index* start, const Index* rank,
                  Index* corners) {
  for (std::size_t h = 0; h < face_vertices.size(); ++h) {
    corners[start[face_vertices[h]] + rank[h]] = static_cast<Index>(h);
  }
  std::fill_n(corners + face_vertices.size(), kAhead, 0);
}

}  // namespace

// Finds the opposites of the half-edges that enter a vertex, and its fans.
template <class Faces>
class Topology::FanMatching {
 public:
  FanMatching(const Faces& faces, Topology& topology)
      : faces_(faces), topology_(topology), places_(topology.vertex_count_, 0) {}

  // The corners of v are ascending before and in the order of going around after. False if an edge
  // has more than one half-edge in the same direction.
  bool match(Index v, std::span<Index> corners) {
    return corners.empty() || close_fan(corners) || match_any(v, corners);
  }

 private:
  struct Spoke {
    Index vertex;  // at its other end
    Index corner;  // its place among the corners
    bool operator<(const Spoke& other) const { return vertex < other.vertex; }
  };
  enum class Corner : unsigned char { reached, start_of_fan, visited };

  // One number of corners, one loop without branches.
  bool close_fan(std::span<Index> corners) {
    switch (corners.size()) {
      case 3: return close_fan_of<3>(corners.data());
      case 4: return close_fan_of<4>(corners.data());
      case 5: return close_fan_of<5>(corners.data());
      case 6: return close_fan_of<6>(corners.data());
      case 7: return close_fan_of<7>(corners.data());
      case 8: return close_fan_of<8>(corners.data());
      case 9: return close_fan_of<9>(corners.data());
      case 10: return close_fan_of<10>(corners.data());
      default: return false;
    }
  }

  // For a single closed fan, which nearly every vertex has: false where it is anything else, and
  // then what was written does not matter. Each spoke's end is noted with the spoke's place, and
  // whoever comes from there finds it. The way around comes back to its start after all corners and
  // not before, so every place is found, and no end is there twice.
  template <std::size_t kCount>
  bool close_fan_of(Index* corners) {
    Index entering[kCount];
    Index from[kCount];
    Index to[kCount];
    for (std::size_t c = 0; c < kCount; ++c) {
      // Every place is one that the list of corners names, so nothing would be foreseen.
      __builtin_prefetch(vertices_ + corners[c + kAhead]);
      __builtin_prefetch(opposite_ + corners[c + kAhead], 1);
      const auto [before, after] = faces_.around(corners[c]);
      entering[c] = before;
      from[c] = vertices_[before];
      to[c] = vertices_[after];
      places_[to[c]] = static_cast<std::uint16_t>(c);
    }
    Index turn[kCount];
    bool closed = true;
    for (std::size_t c = 0; c < kCount; ++c) {
      // Another vertex's place, where nobody has noted one here.
      turn[c] = std::min<Index>(places_[from[c]], kCount - 1);
      closed &= to[turn[c]] == from[c];
      opposite_[entering[c]] = corners[turn[c]];
    }
    Index around[kCount];
    Index at = 0;
    for (std::size_t c = 0; c < kCount; ++c) {
      closed &= (at == 0) == (c == 0);
      around[c] = corners[at];
      at = turn[at];
    }
    if (!closed || at != 0) return false;
    std::copy_n(around, kCount, corners);
    return true;
  }

  // Open fans, several fans, many corners.
  bool match_any(Index v, std::span<Index> corners) {
    leaving_.clear();
    entering_.clear();
    for (Index c = 0; c < corners.size(); ++c) {
      const auto [before, after] = faces_.around(corners[c]);
      leaving_.push_back({vertices_[after], c});
      entering_.push_back({vertices_[before], c});
    }
    if (!sort_unless_repeated(leaving_) || !sort_unless_repeated(entering_)) return false;
    turn_.assign(corners.size(), kNone);
    corner_.assign(corners.size(), Corner::start_of_fan);
    auto to = leaving_.begin();
    for (const Spoke& from : entering_) {
      while (to != leaving_.end() && *to < from) ++to;
      if (to == leaving_.end() || from < *to) continue;
      turn_[from.corner] = to->corner;
      corner_[to->corner] = Corner::reached;
    }
    for (Index c = 0; c < corners.size(); ++c) {
      const bool last = turn_[c] == kNone;
      opposite_[faces_.around(corners[c]).before] = last ? kNone : corners[turn_[c]];
      if (last) ++topology_.boundary_edges_;
    }
    note_fans(v, corners);
    return true;
  }

  static bool sort_unless_repeated(std::vector<Spoke>& spokes) {
    std::sort(spokes.begin(), spokes.end());
    const auto same_end = [](const Spoke& a, const Spoke& b) { return a.vertex == b.vertex; };
    return std::adjacent_find(spokes.begin(), spokes.end(), same_end) == spokes.end();
  }

  // Open fans come first, so that no fan is entered in its middle.
  void note_fans(Index v, std::span<Index> corners) {
    ascending_.assign(corners.begin(), corners.end());
    auto around = corners.begin();
    const auto note_fan = [&](Index start) {
      if (around != corners.begin()) {
        topology_.kinds_[v] |= kBowtie;
        topology_.further_fans_.push_back({v, ascending_[start]});
      }
      for (Index c = start; c != kNone && corner_[c] != Corner::visited; c = turn_[c]) {
        corner_[c] = Corner::visited;
        *around++ = ascending_[c];
      }
    };
    for (Index c = 0; c < corners.size(); ++c) {
      if (corner_[c] != Corner::start_of_fan) continue;
      topology_.kinds_[v] |= kBoundary;
      note_fan(c);
    }
    for (Index c = 0; c < corners.size(); ++c) {
      if (corner_[c] != Corner::visited) note_fan(c);
    }
  }

  Faces faces_;
  Topology& topology_;
  const Index* vertices_ = topology_.face_vertices_.get();
  Index* opposite_ = topology_.opposite_.get();
  std::vector<std::uint16_t> places_;  // #V: where a neighbour is among the corners' spokes
  // Of the corners at one vertex:
  std::vector<Spoke> leaving_;
  std::vector<Spoke> entering_;
  std::vector<Index> ascending_;
  std::vector<Index> turn_;  // the next corner around, or kNone
  std::vector<Corner> corner_;
};

template <class Faces>
Result<void> Topology::match(const Mesh& mesh, const Faces& faces) {
  Index* const rank = opposite_.get();  // while nothing else is known that belongs there
  if (auto error = take_faces(mesh, faces, face_vertices_.get(), start_.get() + 1, rank)) {
    return tl::make_unexpected(*std::move(error));
  }
  std::partial_sum(start_.get(), start_.get() + vertex_count_ + 1, start_.get());
  sort_corners({face_vertices_.get(), corner_count_}, start_.get(), rank, around_.get());
  FanMatching matching(faces, *this);
  for (Index v = 0; v < vertex_count_; ++v) {
    const std::span<Index> corners(around_.get() + start_[v], start_[v + 1] - start_[v]);
    if (!matching.match(v, corners)) return tl::make_unexpected(edge_conflict(mesh));
  }
  return {};
}

Result<Topology> Topology::build(const Mesh& mesh) {
  if (mesh.face_vertices.size() > kMostCorners || mesh.points.size() > kMostCorners) {
    return tl::make_unexpected(refusal::too_large());
  }
  Topology t;
  t.vertex_count_ = mesh.vertex_count();
  t.face_count_ = mesh.face_count();
  t.corner_count_ = mesh.corner_count();
  t.face_vertices_.reset(new Index[t.corner_count_]);
  t.opposite_.reset(new Index[t.corner_count_]);
  t.start_.reset(new Index[std::size_t{t.vertex_count_} + 1]());
  t.around_.reset(new Index[t.corner_count_ + kAhead]);
  t.kinds_.reset(new unsigned char[t.vertex_count_]());
  t.common_degree_ = degree_of_all_faces(mesh);
  Result<void> matched;
  if (t.common_degree_ == 3) {
    matched = t.match(mesh, UniformFaces<3>());
  } else if (t.common_degree_ == 4) {
    matched = t.match(mesh, UniformFaces<4>());
  } else {
    t.face_offsets_ = mesh.face_offsets;
    t.face_of_ = corner_faces(mesh);
    matched = t.match(mesh, MixedFaces{t.face_offsets_.data(), t.face_of_.data()});
  }
  if (!matched) return tl::make_unexpected(matched.error());
  return t;
}

}  // namespace surpass

#include "scheme/patch_rows.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

#include "scheme/numbered_faces.hpp"
#include "scheme/sharpness.hpp"

namespace surpass {
namespace {

// A face with all that touch it, cut out of the mesh. Faces and vertices are numbered as a walk
// meets them that begins at the face and knows nothing of the mesh's own numbers, so that pieces
// joined alike are equal.
class Piece {
 public:
  /// Its faces and vertices alone: the rest is known of a regular piece.
  void gather(const Topology& topology, Index f);
  void cut(const Topology& topology, const Sharpness& sharpness, Index f,
           std::span<const unsigned char> sides);

  [[nodiscard]] const std::vector<Index>& vertices() const { return numbered_.vertices(); }
  /// Those at which it has only the faces next to its first one.
  [[nodiscard]] const std::vector<Index>& cut_vertices() const { return cut_; }
  /// Everything that the derivatives depend on.
  [[nodiscard]] const std::string& key() const { return key_; }
  /// As a mesh, without positions.
  [[nodiscard]] Mesh mesh() const;

 private:
  void walk_around(const Topology& topology, Index h);
  void walk_beside(const Topology& topology, Index h);
  void add_face(const Topology& topology, Index h);
  [[nodiscard]] bool has_edge(Index v, Index w) const;
  void note_sharpness(const Topology& topology, const Sharpness& sharpness);
  template <class Value>
  void append(Value value) {
    key_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  NumberedFaces numbered_;
  std::vector<Index> faces_;  // of the mesh
  std::vector<Crease> creases_;
  std::vector<Corner> sharp_;
  std::vector<Index> cut_;  // numbers of vertices
  std::string key_;
};

// Of a face of the piece.
bool Piece::has_edge(Index v, Index w) const {
  bool found = false;
  numbered_.for_each([&](std::span<const Index> face) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = vertices()[face[i]];
      const Index b = vertices()[face[(i + 1) % face.size()]];
      found = found || (a == v && b == w) || (a == w && b == v);
    }
  });
  return found;
}

// The face of h, from the tail of h on.
void Piece::add_face(const Topology& topology, Index h) {
  const Index f = topology.face(h);
  if (std::find(faces_.begin(), faces_.end(), f) != faces_.end()) return;
  faces_.push_back(f);
  numbered_.add(topology, h);
}

// The faces at the tail of h: counterclockwise from h as far as there are any, then clockwise, then
// those of further fans.
void Piece::walk_around(const Topology& topology, Index h) {
  Index k = h;
  do {
    add_face(topology, k);
    k = topology.rotate(k);
  } while (k != kNone && k != h);
  if (k == kNone) {
    for (k = topology.opposite(h); k != kNone; k = topology.opposite(k)) {
      k = topology.next(k);
      add_face(topology, k);
    }
  }
  const Index v = topology.tail(h);
  if (!topology.is_bowtie(v)) return;
  topology.for_each_outgoing(v, [&](Index spoke) { add_face(topology, spoke); });
}

// Two faces on either side of that of h. With them the edges next to the face are complete.
void Piece::walk_beside(const Topology& topology, Index h) {
  constexpr int kBeside = 2;
  cut_.push_back(numbered_.number(topology.tail(h)));
  add_face(topology, h);
  Index k = h;
  for (int i = 0; i < kBeside && k != kNone; ++i) {
    k = topology.rotate(k);
    if (k != kNone) add_face(topology, k);
  }
  k = h;
  for (int i = 0; i < kBeside && k != kNone; ++i) {
    k = topology.opposite(k);
    if (k == kNone) break;
    k = topology.next(k);
    add_face(topology, k);
  }
}

void Piece::note_sharpness(const Topology& topology, const Sharpness& sharpness) {
  const Index begin = topology.face_begin(faces_[0]);
  for (Index h = begin; h < topology.face_end(faces_[0]); ++h) {
    const Index v = topology.tail(h);
    if (sharpness.is_plain(v)) continue;
    if (sharpness.vertex(v) > 0) sharp_.push_back({numbered_.number(v), sharpness.vertex(v)});
    const bool cut = std::find(cut_.begin(), cut_.end(), numbered_.number(v)) != cut_.end();
    topology.for_each_spoke(v, [&](Index w, Index e) {
      if (cut && !has_edge(v, w)) return;
      const float s = sharpness.edge(topology, e);
      if (s > 0 && !topology.is_boundary_edge(e))
        creases_.push_back({{numbered_.number(v), numbered_.number(w)}, s});
    });
  }
}

void Piece::gather(const Topology& topology, Index f) {
  numbered_.clear();
  faces_.clear();
  cut_.clear();
  const Index begin = topology.face_begin(f);
  add_face(topology, begin);
  for (Index h = begin; h < topology.face_end(f); ++h) {
    if (topology.faces_at(topology.tail(h)) > PatchRows::kMostAround) {
      walk_beside(topology, h);
    } else {
      walk_around(topology, h);
    }
  }
}

void Piece::cut(const Topology& topology, const Sharpness& sharpness, Index f,
                std::span<const unsigned char> sides) {
  creases_.clear();
  sharp_.clear();
  key_.clear();
  gather(topology, f);
  note_sharpness(topology, sharpness);
  key_.append(numbered_.key());
  key_.append(reinterpret_cast<const char*>(sides.data()), sides.size());
  append(kNone);
  for (const Crease& crease : creases_) append(crease);
  append(kNone);
  for (const Corner& corner : sharp_) append(corner);
  append(kNone);
  for (const Index v : cut_) append(v);
}

Mesh Piece::mesh() const {
  Mesh mesh = numbered_.mesh();
  mesh.creases = creases_;
  mesh.corners = sharp_;
  return mesh;
}

// The vertices of a quad whose corners all are plain and of valence 4, with faces around that are
// quads too, in the order in which a Piece has them: what nearly all patches are, fast.
bool regular_quad(const Topology& topology, const Sharpness& sharpness, Index f,
                  std::array<Index, 16>& vertices) {
  const Index h = topology.face_begin(f);
  for (Index k = 0; k < 4; ++k) {
    const Index v = topology.tail(h + k);
    if (topology.faces_at(v) != 4 || !sharpness.is_plain(v)) return false;
    vertices[k] = v;
  }
  const auto head = [&](Index e) { return topology.head(e); };
  const auto across = [&](Index e) { return topology.head(topology.next(e)); };
  std::size_t at = 4;
  for (Index k = 0; k < 4; ++k) {
    const Index beside = topology.rotate(h + k);     // in the face across the side before
    const Index diagonal = topology.rotate(beside);  // in the face that only touches the corner
    const Index after = topology.rotate(diagonal);   // in the face across the side after
    if (k == 0) {
      vertices[at++] = across(beside);
      vertices[at++] = head(diagonal);
    }
    vertices[at++] = across(diagonal);
    if (k == 3) break;
    vertices[at++] = head(after);
    vertices[at++] = across(after);
  }
  return true;
}

// Sixteen different vertices: in small meshes a regular quad may meet one of its neighbours twice.
bool all_different(std::array<Index, 16> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end();
}

// The same of a triangle whose corners are plain and of valence 6: twelve vertices.
bool regular_triangle(const Topology& topology, const Sharpness& sharpness, Index f, Piece& piece) {
  for (Index h = topology.face_begin(f); h < topology.face_end(f); ++h) {
    const Index v = topology.tail(h);
    if (topology.faces_at(v) != 6 || !sharpness.is_plain(v)) return false;
  }
  piece.gather(topology, f);
  return piece.vertices().size() == 12;
}

constexpr std::size_t kMostColumnsTogether = kNone / 2;

// How many times the samples on each side of a face count for its patch.
class SideCounts {
 public:
  SideCounts(const Topology& topology, const Sharpness& sharpness,
             std::span<const unsigned char> sampled, Sides sides)
      : topology_(topology), sharpness_(sharpness), sampled_(sampled), sides_(sides) {}

  std::span<const unsigned char> of(Index f) {
    counts_.clear();
    const Index begin = topology_.face_begin(f);
    for (Index h = begin; h < topology_.face_end(f); ++h) counts_.push_back(count(h, h - begin));
    return counts_;
  }

 private:
  // Of two numbers that a side has, the patch with the smaller one has its samples.
  [[nodiscard]] unsigned char count(Index h, Index side) const {
    const Index o = topology_.opposite(h);
    if (sides_ == Sides::each || o == kNone) return 1;
    const Index g = topology_.face(o);
    const Index other = o - topology_.face_begin(g);
    const bool together = (sampled_.empty() || sampled_[g] != 0) && other != side &&
                          sharpness_.is_plain(topology_.tail(h)) &&
                          sharpness_.is_plain(topology_.tail(o));
    if (!together) return 1;
    return side < other ? 2 : 0;
  }

  const Topology& topology_;
  const Sharpness& sharpness_;
  std::span<const unsigned char> sampled_;
  Sides sides_;
  std::vector<unsigned char> counts_;
};

class KindTable {
 public:
  std::unordered_map<std::string, Index> numbers;
  /// Of the regular quads, by the counts of their sides.
  Index& regular(std::span<const unsigned char> sides) {
    std::size_t at = 0;
    for (const unsigned char count : sides) at = 3 * at + count;
    return regular_[at];
  }

 private:
  std::vector<Index> regular_ = std::vector<Index>(3 * 3 * 3 * 3, kNone);
};

}  // namespace

Result<PatchRows> PatchRows::build(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                   int level, std::span<const unsigned char> sampled,
                                   const Context& context, Sides sides) {
  return scheme_of(rules.scheme).patch_rows(mesh, topology, rules, level, sampled, context, sides);
}

Result<PatchRows> SubdivisionScheme::patch_rows(const Mesh& mesh, const Topology& topology,
                                                const Rules& rules, int level,
                                                std::span<const unsigned char> sampled,
                                                const Context& context, Sides sides) const {
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  PatchRows rows;
  KindTable table;
  SideCounts counts(topology, *sharpness, sampled, sides);
  Piece piece;
  std::array<Index, 16> regular{};
  const std::size_t usual = topology.common_degree() == 3 ? 12 : 16;
  rows.reserve(topology.face_count(),
               std::min(usual * topology.face_count(), kMostColumnsTogether));
  for (Index f = 0; f < topology.face_count(); ++f) {
    if (f % parallel::kChunk == 0 && context.cancelled()) {
      return fail(ErrorCode::cancelled, "cancelled while setting up");
    }
    if (!sampled.empty() && sampled[f] == 0) continue;
    const auto count = counts.of(f);
    const bool is_regular =
        topology.common_degree() == 4
            ? regular_quad(topology, *sharpness, f, regular) && all_different(regular)
            : topology.common_degree() == 3 && regular_triangle(topology, *sharpness, f, piece);
    if (is_regular && table.regular(count) != kNone) {
      rows.add_patch(
          topology.common_degree() == 4 ? std::span<const Index>(regular) : piece.vertices(),
          table.regular(count));
    } else {
      piece.cut(topology, *sharpness, f, count);
      if (rows.column_count() > kMostColumnsTogether) {
        return fail(ErrorCode::too_large,
                    "the patches of the refined mesh depend on too many vertices");
      }
      const auto [at, added] =
          table.numbers.try_emplace(piece.key(), static_cast<Index>(rows.kinds().size()));
      if (added) {
        auto kind = patch_kind(piece.mesh(), rules, level, count, piece.cut_vertices());
        if (!kind) return tl::make_unexpected(kind.error());
        rows.add_kind(std::move(*kind));
      }
      if (is_regular) table.regular(count) = at->second;
      rows.add_patch(piece.vertices(), at->second);
    }
  }
  return rows;
}

}  // namespace surpass

#include "scheme/patch_rows.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <unordered_map>

#include "scheme/numbered_faces.hpp"
#include "scheme/patch_star.hpp"
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

namespace {

// The patches of faces, one after the other.
class FacePatches {
 public:
  FacePatches(const SubdivisionScheme& scheme, const Rules& rules, int level,
              const Topology& topology, const Sharpness& sharpness,
              std::span<const unsigned char> sampled, Sides sides)
      : scheme_(scheme),
        rules_(rules),
        level_(level),
        topology_(topology),
        sharpness_(sharpness),
        sampled_(sampled),
        counts_(topology, sharpness, sampled, sides) {}

  Result<void> add_stars(const Context& context);
  /// Of the faces that have none yet.
  Result<void> add_rest(const Context& context);
  [[nodiscard]] PatchRows take() && { return std::move(rows_); }

 private:
  Result<void> add_star(Index v, std::span<const Index> vertices);
  Result<void> add_face(Index f);
  Result<void> add_piece(Index f, std::span<const unsigned char> count, bool is_regular);
  [[nodiscard]] Result<PatchKind> star_kind(Index v, std::span<const Index> vertices);
  [[nodiscard]] bool is_left(Index f) const {
    return (sampled_.empty() || sampled_[f] != 0) &&
           (rows_.patches_of_faces().empty() || rows_.patches_of_faces()[f] == kNone);
  }

  const SubdivisionScheme& scheme_;
  const Rules& rules_;
  int level_;
  const Topology& topology_;
  const Sharpness& sharpness_;
  std::span<const unsigned char> sampled_;
  SideCounts counts_;
  KindTable table_;
  std::vector<Index> star_kinds_ = std::vector<Index>(Stars::kMostFaces + 1, kNone);
  Piece piece_;
  std::array<Index, 16> regular_{};
  PatchRows rows_;
};

// The pieces around its faces are all joined alike, so they are of one kind.
Result<PatchKind> FacePatches::star_kind(Index v, std::span<const Index> vertices) {
  constexpr std::array<unsigned char, 4> kCounts = {2, 2, 0, 0};
  std::optional<PatchKind> part;
  PatchKind kind;
  kind.columns = vertices.size();
  std::vector<Index> faces;
  topology_.for_each_outgoing(v, [&](Index h) { faces.push_back(topology_.face(h)); });
  for (const Index f : faces) {
    piece_.cut(topology_, sharpness_, f, kCounts);
    if (!part) {
      auto found = scheme_.patch_kind(piece_.mesh(), rules_, level_, kCounts, {});
      if (!found) return found;
      part = std::move(*found);
    }
    std::vector<std::size_t> column;
    for (const Index w : piece_.vertices()) {
      column.push_back(static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), w) -
                                                vertices.begin()));
    }
    for (std::size_t r = 0; r < part->row_count(); ++r) {
      std::vector<double> row(kind.columns, 0.0);
      for (std::size_t c = 0; c < column.size(); ++c) row[column[c]] = part->row(r)[c];
      kind.add(row, part->derivative[r], part->count[r], part->area[r]);
    }
  }
  return kind;
}

Result<void> FacePatches::add_star(Index v, std::span<const Index> vertices) {
  Index& number = star_kinds_[topology_.faces_at(v)];
  if (number == kNone) {
    auto kind = star_kind(v, vertices);
    if (!kind) return tl::make_unexpected(kind.error());
    number = rows_.add_kind(std::move(*kind));
  }
  rows_.add_patch(vertices, number);
  topology_.for_each_outgoing(
      v, [&](Index h) { rows_.own_face(topology_.face(h), topology_.face_count()); });
  return {};
}

Result<void> FacePatches::add_stars(const Context& context) {
  if (topology_.common_degree() != 4) return {};
  Stars stars(topology_, sharpness_, sampled_);
  const std::size_t faces = topology_.face_count();
  rows_.reserve(faces / 4, std::min(faces / 4 + Stars::kPerFace * faces, kMostColumnsTogether));
  for (Index v = 0; v < topology_.vertex_count(); ++v) {
    if (v % parallel::kChunk == 0 && context.cancelled()) {
      return fail(ErrorCode::cancelled, "cancelled while setting up");
    }
    if (rows_.column_count() > kMostColumnsTogether) break;
    if (!stars.find(v)) continue;
    if (auto ok = add_star(v, stars.vertices()); !ok) return ok;
  }
  return {};
}

Result<void> FacePatches::add_piece(Index f, std::span<const unsigned char> count,
                                    bool is_regular) {
  piece_.cut(topology_, sharpness_, f, count);
  if (rows_.column_count() > kMostColumnsTogether) {
    return fail(ErrorCode::too_large,
                "the patches of the refined mesh depend on too many vertices");
  }
  const auto [at, added] =
      table_.numbers.try_emplace(piece_.key(), static_cast<Index>(rows_.kinds().size()));
  if (added) {
    auto kind = scheme_.patch_kind(piece_.mesh(), rules_, level_, count, piece_.cut_vertices());
    if (!kind) return tl::make_unexpected(kind.error());
    rows_.add_kind(std::move(*kind));
  }
  if (is_regular) table_.regular(count) = at->second;
  rows_.add_patch(piece_.vertices(), at->second);
  return {};
}

Result<void> FacePatches::add_face(Index f) {
  const auto count = counts_.of(f);
  const bool quads = topology_.common_degree() == 4;
  const bool is_regular =
      quads ? regular_quad(topology_, sharpness_, f, regular_) && all_different(regular_)
            : topology_.common_degree() == 3 && regular_triangle(topology_, sharpness_, f, piece_);
  if (is_regular && table_.regular(count) != kNone) {
    rows_.add_patch(quads ? std::span<const Index>(regular_) : piece_.vertices(),
                    table_.regular(count));
  } else if (auto ok = add_piece(f, count, is_regular); !ok) {
    return ok;
  }
  rows_.own_face(f, topology_.face_count());
  return {};
}

Result<void> FacePatches::add_rest(const Context& context) {
  const std::size_t usual = topology_.common_degree() == 3 ? 12 : 16;
  std::size_t left = 0;
  for (Index f = 0; f < topology_.face_count(); ++f) left += is_left(f) ? 1U : 0U;
  rows_.reserve(rows_.patch_count() + left,
                std::min(rows_.column_count() + usual * left, kMostColumnsTogether));
  for (Index f = 0; f < topology_.face_count(); ++f) {
    if (f % parallel::kChunk == 0 && context.cancelled()) {
      return fail(ErrorCode::cancelled, "cancelled while setting up");
    }
    if (!is_left(f)) continue;
    if (auto ok = add_face(f); !ok) return ok;
  }
  return {};
}

}  // namespace

Result<PatchRows> SubdivisionScheme::patch_rows(const Mesh& mesh, const Topology& topology,
                                                const Rules& rules, int level,
                                                std::span<const unsigned char> sampled,
                                                const Context& context, Sides sides) const {
  const auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  FacePatches patches(*this, rules, level, topology, *sharpness, sampled, sides);
  if (sides == Sides::joined) {
    if (auto ok = patches.add_stars(context); !ok) return tl::make_unexpected(ok.error());
  }
  if (auto ok = patches.add_rest(context); !ok) return tl::make_unexpected(ok.error());
  return std::move(patches).take();
}

}  // namespace surpass

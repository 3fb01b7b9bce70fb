// Which vertices of a Doo-Sabin control mesh have patches whose derivatives are known, and the
// limits of the vertices that the mesh was refined from.
#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

#include "scheme/doo_sabin.hpp"
#include "scheme/doo_sabin_sites.hpp"
#include "scheme/numbered_faces.hpp"
#include "scheme/patch_rows.hpp"

namespace surpass::doo_sabin {
namespace {

constexpr Index kSpokes = 4;
constexpr std::size_t kRegularColumns = 9;

class PatchFinder {
 public:
  PatchFinder(const DooSabin& scheme, const Layout& layout, const Rules& rules, int level,
              Sides sides)
      : scheme_(scheme),
        layout_(layout),
        topology_(layout.topology()),
        rules_(rules),
        level_(level),
        sides_(sides),
        regular_(3 * 3 * 3 * 3, kNone) {}

  Result<void> add(Index v, PatchRows& rows);

 private:
  using Counts = std::array<unsigned char, kSpokes>;

  // A smooth vertex of four faces, and no lens beside it: the faces that it turns into are quads.
  [[nodiscard]] bool is_square(Index v) const;
  [[nodiscard]] Counts counts_at(Index v) const;
  [[nodiscard]] unsigned char count(Index h, Index side) const;
  void gather(Index v);
  [[nodiscard]] bool all_quads(Index v) const;
  Result<Index> kind_of(Index v, const Counts& counts, PatchRows& rows);
  void add_curve(Index v, PatchRows& rows);

  const DooSabin& scheme_;
  const Layout& layout_;
  const Topology& topology_;
  Rules rules_;
  int level_;
  Sides sides_;
  std::vector<Index> regular_;  // kinds among quads, by the counts of their sides
  std::unordered_map<std::string, Index> numbers_;
  std::array<Index, 3> curves_ = {kNone, kNone, kNone};  // kinds by the faces beside a curve
  NumberedFaces piece_;                                  // at hand
  std::vector<Index> cut_;  // its faces of which it has not all corners
};

bool PatchFinder::is_square(Index v) const {
  if (layout_.kind(v) != VertexKind::smooth || topology_.is_boundary(v) ||
      topology_.faces_at(v) != kSpokes) {
    return false;
  }
  bool lens = false;
  topology_.for_each_spoke(v, [&](Index w, Index) {
    lens = lens || (layout_.kind(w) == VertexKind::kept && !topology_.is_boundary(w) &&
                    topology_.faces_at(w) == 2);
  });
  return !lens;
}

// Side k of a patch lies across spoke k. Of two numbers that a side has, the patch with the smaller
// one has its samples.
unsigned char PatchFinder::count(Index h, Index side) const {
  if (sides_ == Sides::each) return 1;
  const Index w = topology_.head(h);
  if (!is_square(w)) return 1;
  Index other = 0;
  for (Index k = topology_.outgoing(w); topology_.head(k) != topology_.tail(h); ++other) {
    k = topology_.rotate(k);
  }
  if (other == side) return 1;
  return side < other ? 2 : 0;
}

PatchFinder::Counts PatchFinder::counts_at(Index v) const {
  Counts counts{};
  Index h = topology_.outgoing(v);
  for (Index k = 0; k < kSpokes; ++k, h = topology_.rotate(h)) counts[k] = count(h, k);
  return counts;
}

// The faces around v, each from v on; of a large one v and its neighbours.
void PatchFinder::gather(Index v) {
  piece_.clear();
  cut_.clear();
  Index face = 0;
  topology_.for_each_outgoing(v, [&](Index h) {
    if (topology_.face_degree(topology_.face(h)) > PatchRows::kMostAround) {
      cut_.push_back(face);
      piece_.add({v, topology_.head(h), topology_.tail(topology_.previous(h))});
    } else {
      piece_.add(topology_, h);
    }
    ++face;
  });
}

bool PatchFinder::all_quads(Index v) const {
  bool quads = true;
  topology_.for_each_outgoing(
      v, [&](Index h) { quads = quads && topology_.face_degree(topology_.face(h)) == kSpokes; });
  return quads;
}

Result<Index> PatchFinder::kind_of(Index v, const Counts& counts, PatchRows& rows) {
  // In small meshes the nine vertices of four quads need not be different.
  Index* number = nullptr;
  if (all_quads(v) && piece_.vertices().size() == kRegularColumns) {
    std::size_t at = 0;
    for (const unsigned char times : counts) at = 3 * at + times;
    number = &regular_[at];
  } else {
    std::string key(piece_.key());
    key.append(counts.begin(), counts.end());
    key.append(reinterpret_cast<const char*>(cut_.data()), cut_.size() * sizeof(Index));
    number = &numbers_.try_emplace(std::move(key), kNone).first->second;
  }
  if (*number == kNone) {
    // What lies around the piece has no influence; so much the less its boundary rule.
    auto kind = scheme_.patch_kind(piece_.mesh(), rules_, level_, counts, cut_);
    if (!kind) return tl::make_unexpected(kind.error());
    *number = rows.add_kind(std::move(*kind));
  }
  return *number;
}

// Along a curve, a quadratic B-spline of its vertices; each side of it has a patch.
void PatchFinder::add_curve(Index v, PatchRows& rows) {
  std::array<Index, 3> columns = {kNone, v, kNone};
  Index faces = 0;
  topology_.for_each_spoke(v, [&](Index w, Index e) {
    if (!layout_.is_curve(e)) return;
    columns[columns[0] == kNone ? 0 : 2] = w;
    faces = topology_.is_boundary_edge(e) ? 1 : 2;
  });
  Index& number = curves_[faces];
  if (number == kNone) {
    PatchKind kind;
    kind.columns = columns.size();
    const int n = 1 << level_;
    const double part = faces / (4.0 * n * n);
    for (int i = 0; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      kind.add(std::array{t - 1, 1 - 2 * t, t}, Derivative::first, faces,
               i % n == 0 ? part : 2 * part);
    }
    kind.add(std::array{1.0, -2.0, 1.0}, Derivative::second, faces * (n + 1.0), 2 * n * part);
    number = rows.add_kind(std::move(kind));
  }
  rows.add_vertex_patch(v, columns, number);
}

Result<void> PatchFinder::add(Index v, PatchRows& rows) {
  if (layout_.kind(v) == VertexKind::curve) {
    add_curve(v, rows);
    return {};
  }
  if (!is_square(v)) return {};
  gather(v);
  const auto kind = kind_of(v, counts_at(v), rows);
  if (!kind) return tl::make_unexpected(kind.error());
  rows.add_vertex_patch(v, piece_.vertices(), *kind);
  return {};
}

}  // namespace

Result<PatchRows> DooSabin::patch_rows(const Mesh& mesh, const Topology& topology,
                                       const Rules& rules, int level,
                                       std::span<const unsigned char> /*sampled*/,
                                       const Context& context, Sides sides) const {
  const auto layout = Layout::build(mesh, topology, rules.boundary, context);
  if (!layout) return tl::make_unexpected(layout.error());
  PatchRows rows;
  rows.reserve(topology.vertex_count(), kRegularColumns * topology.vertex_count());
  PatchFinder finder(*this, *layout, rules, level, sides);
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (v % parallel::kChunk == 0 && context.cancelled()) {
      return fail(ErrorCode::cancelled, "cancelled while setting up");
    }
    if (auto ok = finder.add(v, rows); !ok) return tl::make_unexpected(ok.error());
  }
  return rows;
}

namespace {

tl::unexpected<Error> not_refined_from() {
  return fail(ErrorCode::mismatch,
              "the control mesh is not the given mesh refined once: its faces are others");
}

// A vertex twice in a row is there once, with both weights.
std::vector<std::pair<Index, double>> site_row(const Layout& layout, Weights family,
                                               const Site& site) {
  std::vector<std::pair<Index, double>> row;
  add_site_limit(layout, family, site, [&](Index v, double w) {
    const bool often = site.kind == Site::Kind::edge;
    const auto at =
        !often ? row.end()
               : std::find_if(row.begin(), row.end(), [&](const auto& t) { return t.first == v; });
    if (at != row.end()) {
      at->second += w;
    } else {
      row.emplace_back(v, w);
    }
  });
  return row;
}

}  // namespace

Result<SparseRows> DooSabin::given_limits(const Mesh& refined, const Topology& topology,
                                          const Rules& rules, const Mesh& given,
                                          const Context& context) const {
  const auto coarse = Topology::build(given);
  if (!coarse) return tl::make_unexpected(coarse.error());
  const auto before = Layout::build(given, *coarse, rules.boundary, context);
  if (!before) return tl::make_unexpected(before.error());
  const NewMesh fresh = new_mesh(*before);
  const auto same_corner = [](Index v, const NewCorner& c) { return v == c.point; };
  if (refined.vertex_count() != before->point_count() ||
      refined.face_offsets != fresh.faces.offsets ||
      !std::equal(refined.face_vertices.begin(), refined.face_vertices.end(),
                  fresh.faces.corners.begin(), fresh.faces.corners.end(), same_corner)) {
    return not_refined_from();
  }
  const auto layout = Layout::build(refined, topology, rules.boundary, context);
  if (!layout) return tl::make_unexpected(layout.error());
  const std::vector<Site> sites = sites_of_vertices(*before, fresh);
  return SparseRows::build(
      context, given.vertex_count(),
      [&](Index v) {
        return static_cast<Index>(site_row(*layout, rules.weights, sites[v]).size());
      },
      [&](Index v, std::span<Index> columns, std::span<double> weights) {
        const auto row = site_row(*layout, rules.weights, sites[v]);
        for (std::size_t k = 0; k < row.size(); ++k) std::tie(columns[k], weights[k]) = row[k];
      });
}

}  // namespace surpass::doo_sabin

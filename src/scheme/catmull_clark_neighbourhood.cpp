#include "scheme/catmull_clark_neighbourhood.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "scheme/catmull_clark.hpp"

namespace surpass::catmull_clark {
namespace {

// What sharpness needs to know is written down; boundaries are the mesh's own.
constexpr Rules kRules{Scheme::catmull_clark, Boundary::edge_only};

// Numbers faces and vertices in an order that depends on nothing but who is next to whom, so that
// equal neighbourhoods are equal meshes.
class Cut {
 public:
  Cut(const Topology& topology, const Sharpness& sharpness)
      : topology_(topology), sharpness_(sharpness) {}

  void add(Index face) {
    const Index begin = topology_.face_begin(face);
    add_face(begin);
    for (Index h = begin; h < topology_.face_end(face); ++h) {
      for (const Index g : fan_from(h)) {
        add_face(g);
        note_crease(g);
        note_crease(topology_.previous(g));
      }
      // Only sharpness at the face's own vertices matters.
      const Index v = topology_.tail(h);
      if (const float s = sharpness_.vertex(v); s > 0) mesh.corners.push_back({number(v), s});
    }
    for (const auto& [ends, sharpness] : creases_) mesh.creases.push_back({ends, sharpness});
    mesh.points.resize(vertices.size());
  }

  Mesh mesh;
  std::vector<Index> vertices;

 private:
  Index number(Index vertex) {
    const auto known = std::find(vertices.begin(), vertices.end(), vertex);
    const auto number = static_cast<Index>(known - vertices.begin());
    if (known == vertices.end()) vertices.push_back(vertex);
    return number;
  }

  // Starting at a corner of it.
  void add_face(Index start) {
    const Index face = topology_.face(start);
    if (std::find(faces_.begin(), faces_.end(), face) != faces_.end()) return;
    faces_.push_back(face);
    std::vector<Index> corners;
    Index h = start;
    do {
      corners.push_back(number(topology_.tail(h)));
      h = topology_.next(h);
    } while (h != start);
    mesh.add_face(corners);
  }

  // The half-edges that leave tail(start), on from it and, in an open fan, then those before.
  // Another fan there would be a bow-tie's: it is sharp, and across it nothing depends on anything.
  [[nodiscard]] std::vector<Index> fan_from(Index start) const {
    std::vector<Index> fan;
    for (Index h = start; h != kNone; h = topology_.rotate(h)) {
      fan.push_back(h);
      if (topology_.rotate(h) == start) return fan;
    }
    for (Index h = start; topology_.opposite(h) != kNone;) {
      h = topology_.next(topology_.opposite(h));
      fan.push_back(h);
    }
    return fan;
  }

  void note_crease(Index h) {
    const Index e = topology_.edge(h);
    const float s = sharpness_.edge(topology_, e);
    if (s <= 0 || topology_.is_boundary_edge(e)) return;
    const Index a = number(topology_.tail(h));
    const Index b = number(topology_.head(h));
    creases_[{std::min(a, b), std::max(a, b)}] = s;
  }

  const Topology& topology_;
  const Sharpness& sharpness_;
  std::vector<Index> faces_;
  std::map<std::array<Index, 2>, float> creases_;
};

bool same_structure(const Mesh& a, const Mesh& b) {
  return a.face_vertices == b.face_vertices && a.face_offsets == b.face_offsets &&
         a.creases == b.creases && a.corners == b.corners;
}

// Weights of a place add up to a known sum. What rounding adds to it would not fade through
// refinements as the rest does, and in derivatives be blown up by the powers of two.
void restore_sum(Mask& mask, double sum) {
  mask.front() += sum - std::accumulate(mask.begin(), mask.end(), 0.0);
}

}  // namespace

bool RingPlace::is_regular() const {
  if (ring.is_semi_sharp()) return false;
  const VertexRule rule = ring.rule();
  if (rule == VertexRule::smooth) return ring.size() == 4 && ring.all_quads();
  if (rule == VertexRule::dart) return false;
  const std::size_t n = ring.size();
  for (const Sector& sector : sectors(ring)) {
    if ((face + n - sector.begin) % n >= sector.faces) continue;
    if (rule == VertexRule::corner) {
      return sector.faces == 1 && ring.spoke_sharpness[face] > 0 &&
             ring.spoke_sharpness[next_spoke()] > 0 && ring.faces[face].size() == 4;
    }
    return sector.faces == 2 && ring.faces[sector.begin].size() == 4 &&
           ring.faces[(sector.begin + 1) % n].size() == 4;
  }
  return false;
}

Result<std::unique_ptr<Neighbourhood>> Neighbourhood::create(Mesh mesh) {
  auto made = std::make_unique<Neighbourhood>();
  auto topology = Topology::build(mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  auto sharpness = Sharpness::build(mesh, *topology, kRules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  made->mesh_ = std::move(mesh);
  made->topology_ = std::move(*topology);
  made->sharpness_ = std::move(*sharpness);
  made->regular_ = made->has_regular_corners();
  return made;
}

bool Neighbourhood::has_regular_corners() const {
  if (topology_.face_degree(0) != 4) return false;
  for (Index k = 0; k < 4; ++k) {
    if (!corner(k).is_regular()) return false;
  }
  return true;
}

Result<std::unique_ptr<Neighbourhood>> Neighbourhood::around(const Topology& topology,
                                                             const Sharpness& sharpness, Index face,
                                                             std::vector<Index>& vertices) {
  Cut cut(topology, sharpness);
  cut.add(face);
  vertices = std::move(cut.vertices);
  return create(std::move(cut.mesh));
}

RingPlace Neighbourhood::corner(Index k) const {
  const Index v = topology_.tail(k);
  RingPlace place{FaceRing::around(topology_, sharpness_, v)};
  std::size_t j = 0;
  topology_.for_each_outgoing(v, [&](Index h) {
    if (h == k) place.face = j;
    ++j;
  });
  return place;
}

Result<void> Neighbourhood::refine() {
  KeptRows stencil;
  auto mesh =
      scheme_of(kRules.scheme).refinement(mesh_, topology_, kRules, {.threads = 1}, stencil);
  if (!mesh) return tl::make_unexpected(mesh.error());
  mesh->points.resize(stencil.row_count());
  auto topology = Topology::build(*mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  auto sharpness = Sharpness::build(*mesh, *topology, kRules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  refined_ = {std::move(stencil), std::move(*topology), std::move(*sharpness)};
  quarters_.resize(topology_.face_degree(0));
  return {};
}

Result<const Neighbourhood::Quarter*> Neighbourhood::quarter(Index k) {
  if (!refined_) {
    if (auto ok = refine(); !ok) return tl::make_unexpected(ok.error());
  }
  Quarter& quarter = quarters_[k];
  if (quarter.patch != nullptr) return &quarter;
  auto patch = around(refined_->topology, refined_->sharpness, k, quarter.vertices);
  if (!patch) return tl::make_unexpected(patch.error());
  quarter.parent = this;
  const bool repeats = same_structure((*patch)->mesh_, mesh_);
  if (!repeats) quarter.owned = std::move(*patch);
  quarter.patch = repeats ? this : quarter.owned.get();
  return &quarter;
}

void Neighbourhood::Quarter::lift(PlaceRows& rows) const {
  const KeptRows& stencil = parent->refined_->stencil;
  for (Mask* mask : rows.all()) {
    if (mask->empty()) continue;
    Mask lifted(parent->point_count(), 0.0);
    for (std::size_t i = 0; i < mask->size(); ++i) {
      const double w = (*mask)[i];
      if (w == 0) continue;
      const RowView row = stencil.row(vertices[i]);
      for (std::size_t c = 0; c < row.columns.size(); ++c) {
        lifted[row.columns[c]] += w * row.weights[c];
      }
    }
    restore_sum(lifted, mask == &rows.position ? 1 : 0);
    *mask = std::move(lifted);
  }
}

}  // namespace surpass::catmull_clark

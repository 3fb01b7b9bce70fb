// Limit normals at every level. The two modes of frequency 1 of a plain ring are only scaled by the
// rules of all levels, by 1/2 - d_k + 2 d_k cos(2 pi / n), so the tangents are those of Loop's
// surface and depend on no parameter, but where an edge to a curve is bent.
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "scheme/nonstationary_state.hpp"

namespace surpass::nonstationary {
namespace {

using Vector = Eigen::Vector3d;

Vector place(const Mesh& mesh, Index v) { return Eigen::Map<const Vector>(mesh.points[v].data()); }

struct Turn {
  double cosine;
  double sine;
};

/// cos and sin of 2 pi j / n for each valence that occurs.
std::vector<std::vector<Turn>> turns_by_valence(const Topology& topology) {
  std::vector<std::vector<Turn>> turns;
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    const Index n = topology.valence(v);
    if (turns.size() <= n) turns.resize(std::size_t{n} + 1);
    if (!turns[n].empty()) continue;
    for (Index j = 0; j < n; ++j) {
      const double angle = 2 * std::numbers::pi * j / n;
      turns[n].push_back({std::cos(angle), std::sin(angle)});
    }
  }
  return turns;
}

class LimitNormals {
 public:
  LimitNormals(const State& state, const Mesh& mesh, const Topology& topology,
               const Sharpness& sharpness)
      : state_(state),
        mesh_(mesh),
        topology_(topology),
        sharpness_(sharpness),
        turns_(turns_by_valence(topology)) {
    // Sum of (beta - 1) / 2^j over the levels from this one on.
    double half = 1;
    for (int j = 0; j < kHalvings; ++j, half /= 2) {
      const double later = iterated(state.beta(), j, state.options);
      later_bend_ += half * (in_mask(later, state.options) - 1);
    }
  }

  [[nodiscard]] Point at(Index v) const {
    if (topology_.is_isolated(v)) return {};
    // Each fan of a bow-tie is a corner of its own.
    if (topology_.is_bowtie(v)) return mean_face_normal(mesh_, topology_, v);
    const Vector normal = !sharpness_.is_plain(v) ? on_curve(v)
                          : state_.own.empty()    ? plain(v)
                                                  : of_own_ring(v);
    return {normal[0], normal[1], normal[2]};
  }

 private:
  static constexpr int kHalvings = 60;

  [[nodiscard]] Vector plain(Index v) const {
    const Vector center = place(mesh_, v);
    const std::vector<Turn>& turns = turns_[topology_.valence(v)];
    Vector first = Vector::Zero();
    Vector second = Vector::Zero();
    bool near_curve = false;
    std::size_t j = 0;
    topology_.for_each_outgoing(v, [&](Index h) {
      const Index w = topology_.head(h);
      const Vector spoke = place(mesh_, w) - center;
      first += turns[j].cosine * spoke;
      second += turns[j++].sine * spoke;
      near_curve = near_curve || (w < state_.given() && !sharpness_.is_plain(w));
    });
    if (near_curve && state_.level > 0) bend(v, center, first, second);
    return unit_cross(first, second);
  }

  /// The same of the next ring, where some points are elsewhere.
  void bend(Index v, const Vector& center, Vector& first, Vector& second) const {
    const std::vector<Turn>& turns = turns_[topology_.valence(v)];
    const double d = state_.edge_mask() / 8;
    const double shrunk = 0.5 - d + 2 * d * turns[1].cosine;
    first *= shrunk;
    second *= shrunk;
    std::size_t j = 0;
    topology_.for_each_outgoing(v, [&](Index h) {
      const Index w = topology_.head(h);
      const Turn& turn = turns[j++];
      const auto bent = bent_edge(state_, topology_, sharpness_, v, w);
      if (!bent) return;
      const Vector more = (bent->weight - (0.5 - d)) * (center - place(mesh_, w));
      first += turn.cosine * more;
      second += turn.sine * more;
    });
  }

  [[nodiscard]] Vector of_own_ring(Index v) const {
    std::vector<double> spokes;
    topology_.for_each_outgoing(v,
                                [&](Index h) { spokes.push_back(state_.own[topology_.head(h)]); });
    const Tangents tangents = ring_limit(state_.own[v], spokes, state_.options).tangents;
    const Vector center = place(mesh_, v);
    Vector first = Vector::Zero();
    Vector second = Vector::Zero();
    std::size_t j = 1;
    topology_.for_each_outgoing(v, [&](Index h) {
      const Vector spoke = place(mesh_, topology_.head(h)) - center;
      first += tangents.first[j] * spoke;
      second += tangents.second[j++] * spoke;
    });
    return unit_cross(first, second);
  }

  [[nodiscard]] Vector on_curve(Index v) const {
    struct CurveRing : Ring {
      [[nodiscard]] std::size_t point_count() const { return size() + 1; }
    };
    CurveRing ring;
    static_cast<Ring&>(ring) = Ring::around(topology_, sharpness_, v);
    const auto curve = [this](const CurveRing& r, const Sector& sector) {
      return curve_tangents(r.size(), sector);
    };
    std::vector<Index> columns = {v};
    columns.insert(columns.end(), ring.spokes.begin(), ring.spokes.end());
    const Point normal =
        normal_of(mesh_, {columns, {}, sector_tangents(ring, curve, corner_tangents<CurveRing>)});
    return {normal[0], normal[1], normal[2]};
  }

  /// Along the curve, and across it into the sector: there the sines of the spokes inside, with
  /// weights of the curve's points that add up what all later levels bring from them.
  [[nodiscard]] Tangents curve_tangents(std::size_t n, const Sector& sector) const {
    const auto at = [&](std::size_t j) { return 1 + (sector.begin + j) % n; };
    Tangents t{Mask(n + 1, 0.0), Mask(n + 1, 0.0)};
    t.first[at(0)] = 1;
    t.first[at(sector.faces)] = -1;
    if (sector.faces == 1) {
      t.second[at(0)] = t.second[at(1)] = 1;
      t.second[0] = -2;
      return t;
    }
    const double step = std::numbers::pi / static_cast<double>(sector.faces);
    for (std::size_t j = 1; j < sector.faces; ++j) {
      t.second[at(j)] = std::sin(step * static_cast<double>(j));
    }
    const double inside = 1 / std::tan(step / 2);  // the sum of these sines
    const double spoke = (std::sin(step) - inside) / 2 + std::sin(step) / 4 * later_bend_;
    t.second[at(0)] = t.second[at(sector.faces)] = spoke;
    t.second[0] = -(inside + 2 * spoke);
    return t;
  }

  const State& state_;
  const Mesh& mesh_;
  const Topology& topology_;
  const Sharpness& sharpness_;
  std::vector<std::vector<Turn>> turns_;
  double later_bend_ = 0;
};

}  // namespace

std::vector<Point> normals(const State& state, const Mesh& mesh, const Topology& topology,
                           const Sharpness& sharpness, const Context& context) {
  const LimitNormals all(state, mesh, topology, sharpness);
  std::vector<Point> found(topology.vertex_count());
  parallel::for_ranges(context, found.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) found[v] = all.at(static_cast<Index>(v));
  });
  return found;
}

}  // namespace surpass::nonstationary

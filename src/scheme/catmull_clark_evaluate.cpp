// The limit surface at any parameters: refinement of a face's neighbourhood towards the place,
// until a bicubic patch or a vertex's masks give it; then the weights are carried back.
//
// Stam, Exact evaluation of Catmull-Clark subdivision surfaces at arbitrary parameter values, 1998,
// has the idea that refinement near an irregular vertex repeats itself. He diagonalises it; here it
// is repeated, which a step a halving makes cheap, and which takes every boundary and crease.
#include <utility>

#include "scheme/catmull_clark.hpp"
#include "scheme/catmull_clark_neighbourhood.hpp"
#include "scheme/catmull_clark_spline_patch.hpp"
#include "scheme/catmull_clark_vertex_rows.hpp"
#include "scheme/quarter.hpp"
#include "scheme/surface_evaluator.hpp"

namespace surpass::catmull_clark {
namespace {

void scale(Mask& mask, double factor) {
  for (double& w : mask) w *= factor;
}

// The corner of the unit square at (u, v), or kNone.
Index corner_at(double u, double v) {
  if ((u != 0 && u != 1) || (v != 0 && v != 1)) return kNone;
  return u == 0 ? (v == 0 ? 0 : 3) : (v == 0 ? 1 : 2);
}

// Derivatives by parameters that start at corner k of the square become those by the square's: they
// are turned by k right angles.
void turn(Index k, PlaceRows& rows) {
  if (k % 2 == 1) {
    std::swap(rows.du, rows.dv);
    std::swap(rows.duu, rows.dvv);
    scale(rows.duv, -1);
  }
  if (k == 1 || k == 2) scale(rows.du, -1);
  if (k == 2 || k == 3) scale(rows.dv, -1);
}

// Those of a quarter are half as long. The tangents' length has no meaning, but must not fade away.
void halve(PlaceRows& rows) {
  for (Mask* mask : {&rows.du, &rows.dv, &rows.tangent_u, &rows.tangent_v}) scale(*mask, 2);
  for (Mask* mask : {&rows.duu, &rows.duv, &rows.dvv}) scale(*mask, 4);
}

class CatmullClarkFace final : public FaceEvaluator {
 public:
  CatmullClarkFace(std::unique_ptr<Neighbourhood> patch, std::vector<Index> vertices)
      : patch_(std::move(patch)), vertices_(std::move(vertices)) {}

  Result<SurfaceStencil> stencil(const SurfacePlace& place) override {
    double u = place.u;
    double v = place.v;
    Neighbourhood* patch = patch_.get();
    std::vector<Step> steps;
    // The place's own quarter, if it names one, has these parameters already.
    const auto enter = [&](Index quarter, bool halves) -> Result<void> {
      const auto entered = patch->quarter(quarter);
      if (!entered) return tl::make_unexpected(entered.error());
      steps.push_back({*entered, quarter, halves});
      patch = (*entered)->patch;
      return {};
    };
    if (place.corner != kNone) {
      if (auto ok = enter(place.corner, false); !ok) return tl::make_unexpected(ok.error());
    }
    std::optional<PlaceRows> rows;
    while (!(rows = rows_without_refinement(*patch, u, v))) {
      const Index quarter = enter_quarter(u, v);
      if (auto ok = enter(quarter, true); !ok) return tl::make_unexpected(ok.error());
    }
    for (std::size_t i = steps.size(); i > 0; --i) {
      const Step& step = steps[i - 1];
      step.quarter->lift(*rows);
      if (!step.halves) continue;
      turn(step.number, *rows);
      halve(*rows);
    }
    return over_control_points(*rows);
  }

 private:
  struct Step {
    const Neighbourhood::Quarter* quarter;
    Index number;
    bool halves;
  };

  // In a B-spline patch, and at vertices that stay irregular.
  static std::optional<PlaceRows> rows_without_refinement(const Neighbourhood& patch, double u,
                                                          double v) {
    if (patch.is_regular()) return spline_patch_rows(patch, u, v);
    const Index k = corner_at(u, v);
    if (k == kNone) return std::nullopt;
    const RingPlace corner = patch.corner(k);
    if (!corner.stays_irregular()) return std::nullopt;
    PlaceRows rows = vertex_rows(corner, patch.point_count());
    turn(k, rows);
    return rows;
  }

  [[nodiscard]] SurfaceStencil over_control_points(PlaceRows& rows) const {
    SurfaceStencil stencil;
    std::vector<std::size_t> used;
    const auto all = rows.all();
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const bool is_used = std::any_of(all.begin(), all.end(), [&](const Mask* mask) {
        return !mask->empty() && (*mask)[i] != 0;
      });
      if (!is_used) continue;
      used.push_back(i);
      stencil.columns.push_back(vertices_[i]);
    }
    const auto pick = [&](const Mask& mask) {
      std::vector<double> weights;
      if (mask.empty()) return weights;
      weights.reserve(used.size());
      for (const std::size_t i : used) weights.push_back(mask[i]);
      return weights;
    };
    stencil.position = pick(rows.position);
    stencil.du = pick(rows.du);
    stencil.dv = pick(rows.dv);
    stencil.duu = pick(rows.duu);
    stencil.duv = pick(rows.duv);
    stencil.dvv = pick(rows.dvv);
    stencil.tangent_u = pick(rows.tangent_u);
    stencil.tangent_v = pick(rows.tangent_v);
    stencil.has_plane = rows.has_plane;
    return stencil;
  }

  std::unique_ptr<Neighbourhood> patch_;
  std::vector<Index> vertices_;
};

class CatmullClarkEvaluator final : public SurfaceEvaluator {
 public:
  CatmullClarkEvaluator(const Topology& topology, Sharpness sharpness)
      : topology_(topology), sharpness_(std::move(sharpness)) {}

  [[nodiscard]] Result<std::unique_ptr<FaceEvaluator>> on_face(Index face) const override {
    std::vector<Index> vertices;
    auto patch = Neighbourhood::around(topology_, sharpness_, face, vertices);
    if (!patch) return tl::make_unexpected(patch.error());
    return std::make_unique<CatmullClarkFace>(std::move(*patch), std::move(vertices));
  }

 private:
  const Topology& topology_;
  Sharpness sharpness_;
};

}  // namespace

Result<std::unique_ptr<const SurfaceEvaluator>> CatmullClark::evaluator(
    const Mesh& mesh, const Topology& topology, const Rules& rules,
    const Context& /*context*/) const {
  auto sharpness = Sharpness::build(mesh, topology, rules.boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  return std::make_unique<const CatmullClarkEvaluator>(topology, std::move(*sharpness));
}

}  // namespace surpass::catmull_clark

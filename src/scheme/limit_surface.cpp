#include <surpass/evaluate.hpp>

#include <optional>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "parallel/parallel.hpp"
#include "scheme/subdivision_scheme.hpp"
#include "scheme/surface_evaluator.hpp"
#include "scheme/tangents.hpp"

namespace surpass {
namespace {

// Few enough to share out, enough for a face's refinements to be used again.
constexpr std::size_t kPlacesPerChunk = 256;

Result<void> check_place(const Topology& topology, const SurfacePlace& place) {
  if (place.face >= topology.face_count()) {
    return fail(ErrorCode::invalid_argument, fmt::format("a place names face {}; there are {}",
                                                         place.face, topology.face_count()));
  }
  const Place where{.face = place.face};
  const Index m = topology.face_degree(place.face);
  if (place.corner == kNone && m != 4) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("a place on a face of {} vertices has to name a corner", m), where);
  }
  if (place.corner != kNone && place.corner >= m) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("a place names corner {} of a face of {} vertices; they count from 0",
                            place.corner, m),
                where);
  }
  const auto in_range = [](double t) { return t >= 0 && t <= 1; };  // false for NaN, too
  if (!in_range(place.u) || !in_range(place.v)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("a place has the parameters ({}, {}); they lie between 0 and 1",
                            place.u, place.v),
                where);
  }
  return {};
}

// The sum of weights * (point - origin).
Point combine(const SurfaceStencil& stencil, const std::vector<double>& weights,
              std::span<const Point> control) {
  Point sum = {};
  if (weights.empty()) return sum;
  const Point& origin = control[stencil.columns.front()];
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Point& p = control[stencil.columns[i]];
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weights[i] * (p[c] - origin[c]);
  }
  return sum;
}

Point unit_normal(const Point& a, const Point& b) {
  using Vector = Eigen::Map<const Eigen::Vector3d>;
  // Far from 1 near irregular vertices, where the product could leave the range of doubles.
  const Eigen::Vector3d n = unit(unit(Vector(a.data())).cross(unit(Vector(b.data()))));
  return {n[0], n[1], n[2]};
}

}  // namespace

SurfaceSample sample(const SurfaceStencil& stencil, std::span<const Point> control) {
  const auto of = [&](const std::vector<double>& weights) {
    return combine(stencil, weights, control);
  };
  SurfaceSample s;
  s.position = of(stencil.position);
  const Point& origin = control[stencil.columns.front()];
  for (std::size_t c = 0; c < 3; ++c) s.position[c] += origin[c];
  s.du = of(stencil.du);
  s.dv = of(stencil.dv);
  s.normal = unit_normal(of(stencil.tangent_u), of(stencil.tangent_v));
  if (!stencil.duu.empty()) s.second = {of(stencil.duu), of(stencil.duv), of(stencil.dvv)};
  return s;
}

struct LimitSurface::Contents {
  Mesh control;
  Topology topology;
  std::unique_ptr<const SurfaceEvaluator> evaluator;

  [[nodiscard]] Result<SurfaceStencil> stencil(const SurfacePlace& place) const {
    std::unique_ptr<FaceEvaluator> face;
    Index number = kNone;
    return stencil(place, face, number);
  }

  // `face` is that of `number`, or will be that of the place.
  [[nodiscard]] Result<SurfaceStencil> stencil(const SurfacePlace& place,
                                               std::unique_ptr<FaceEvaluator>& face,
                                               Index& number) const {
    if (auto ok = check_place(topology, place); !ok) return tl::make_unexpected(ok.error());
    if (number != place.face) {
      auto made = evaluator->on_face(place.face);
      if (!made) return tl::make_unexpected(made.error());
      face = std::move(*made);
      number = place.face;
    }
    return face->stencil(place);
  }

  // use(i, stencil of places[i]).
  template <class Use>
  [[nodiscard]] Result<void> for_each(std::span<const SurfacePlace> places, const Context& context,
                                      Use&& use) const {
    std::vector<std::optional<Error>> errors((places.size() + kPlacesPerChunk - 1) /
                                             kPlacesPerChunk);
    parallel::for_ranges(
        context, places.size(),
        [&](std::size_t begin, std::size_t end) {
          auto& error = errors[begin / kPlacesPerChunk];
          if (context.cancelled()) error = {ErrorCode::cancelled, "cancelled while evaluating"};
          std::unique_ptr<FaceEvaluator> face;
          Index number = kNone;
          for (std::size_t i = begin; i < end && !error; ++i) {
            auto found = stencil(places[i], face, number);
            if (found) {
              use(i, std::move(*found));
            } else {
              error = found.error();
            }
          }
        },
        kPlacesPerChunk);
    for (auto& error : errors) {
      if (error) return tl::make_unexpected(std::move(*error));
    }
    return {};
  }
};

Result<LimitSurface> LimitSurface::create(const Mesh& control, const Rules& rules,
                                          const Context& context) {
  auto topology = Topology::build(control);
  if (!topology) return tl::make_unexpected(topology.error());
  const SubdivisionScheme& scheme = scheme_of(rules.scheme);
  if (auto ok = require_suitable(scheme, *topology, rules); !ok) {
    return tl::make_unexpected(ok.error());
  }
  auto contents = std::make_shared<Contents>(Contents{control, std::move(*topology), nullptr});
  auto evaluator = scheme.evaluator(contents->control, contents->topology, rules, context);
  if (!evaluator) return tl::make_unexpected(evaluator.error());
  contents->evaluator = std::move(*evaluator);
  return LimitSurface(std::move(contents));
}

Result<SurfaceStencil> LimitSurface::stencil(const SurfacePlace& place) const {
  return contents_->stencil(place);
}

Result<SurfaceSample> LimitSurface::evaluate(const SurfacePlace& place) const {
  return contents_->stencil(place).map(
      [&](const SurfaceStencil& s) { return sample(s, contents_->control.points); });
}

Result<std::vector<SurfaceSample>> LimitSurface::evaluate(std::span<const SurfacePlace> places,
                                                          const Context& context) const {
  std::vector<SurfaceSample> samples(places.size());
  auto done = contents_->for_each(places, context, [&](std::size_t i, const SurfaceStencil& s) {
    samples[i] = sample(s, contents_->control.points);
  });
  if (!done) return tl::make_unexpected(done.error());
  return samples;
}

Result<std::vector<SurfaceStencil>> LimitSurface::stencils(std::span<const SurfacePlace> places,
                                                           const Context& context) const {
  std::vector<SurfaceStencil> stencils(places.size());
  auto done = contents_->for_each(
      places, context, [&](std::size_t i, SurfaceStencil&& s) { stencils[i] = std::move(s); });
  if (!done) return tl::make_unexpected(done.error());
  return stencils;
}

const Mesh& LimitSurface::control() const { return contents_->control; }

}  // namespace surpass

#include "interpolate/requirement_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "interpolate/requirement_places.hpp"
#include "interpolate/tangent_place.hpp"
#include "interpolate/tangent_wishes.hpp"

namespace surpass {
namespace {

using Kind = Requirement::Kind;

std::vector<double> combined(const std::array<double, 2>& along, const SurfaceStencil& s) {
  std::vector<double> weights(s.columns.size(), 0.0);
  if ((along[0] != 0 && s.du.empty()) || (along[1] != 0 && s.dv.empty())) return {};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (along[0] != 0) weights[i] += along[0] * s.du[i];
    if (along[1] != 0) weights[i] += along[1] * s.dv[i];
  }
  return weights;
}

Point point_of(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

constexpr std::array<Point, 3> kAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

class Equations {
 public:
  Equations(RequirementRows& out, std::size_t requirements) : out_(out) {
    out_.first_row.resize(requirements);
  }

  Result<void> add(const Requirement& r, std::size_t number, const LocatedRequirement& at,
                   SurfaceStencil stencil) {
    out_.first_row[number] = out_.rows.size();
    if (out_.repeated[number] != 0) return {};
    switch (r.kind) {
      case Kind::remove: return {};
      case Kind::position: return position(r, number, std::move(stencil));
      case Kind::normal: {
        if (!stencil.has_plane) {
          return refuse_requirement(
              r, number,
              "the surface has no tangent plane there: it is a corner between more than two faces, "
              "or an inner vertex of two",
              ErrorCode::contradictory);
        }
        const Point n = point_of(unit_vector(r.value));
        for (auto* weights : {&stencil.tangent_u, &stencil.tangent_v}) {
          out_.rows.push_back({number, n, put(stencil.columns, std::move(*weights)), 0});
        }
        return {};
      }
      default: break;
    }
    std::vector<double> weights = combined(at.along, stencil);
    if (weights.empty()) {
      return refuse_requirement(r, number,
                                "the surface has no derivative there: it stays irregular",
                                ErrorCode::contradictory);
    }
    const std::size_t place = put(stencil.columns, std::move(weights));
    if (r.kind == Kind::direction) {
      for (const auto& n : across(r.value)) {
        out_.rows.push_back({number, point_of(n), place, 0});
      }
    } else {
      for (std::size_t c = 0; c < 3; ++c)
        out_.rows.push_back({number, kAxes[c], place, r.value[c]});
    }
    return {};
  }

 private:
  std::size_t put(const std::vector<Index>& columns, std::vector<double> values) {
    out_.weights.push_back({columns, std::move(values)});
    return out_.weights.size() - 1;
  }

  Result<void> position(const Requirement& r, std::size_t number, SurfaceStencil stencil) {
    if (r.vertex != kNone) {
      out_.targets[r.vertex] = r.value;
      return {};
    }
    const std::size_t place = put(stencil.columns, std::move(stencil.position));
    for (std::size_t c = 0; c < 3; ++c) out_.rows.push_back({number, kAxes[c], place, r.value[c]});
    return {};
  }

  RequirementRows& out_;
};

// Positions and removals at the same vertex cannot both be meant, unless they say the same; nor can
// positions that nothing is left of the mesh beside.
Result<void> check_vertices(std::span<const Requirement> requirements, const Mesh& given) {
  const double side = bounding_box(given.points).side();
  const auto is_too_far = [&](double x) {
    return !(std::abs(x) <= kFarthest * (side > 0 ? side : 1));
  };
  std::vector<std::size_t> first(given.vertex_count(), requirements.size());
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    const Requirement& r = requirements[i];
    if (!is_of_vertex(r)) continue;
    if (std::any_of(r.value.begin(), r.value.end(), is_too_far)) {
      return refuse_requirement(r, i, kTooLarge, ErrorCode::not_finite);
    }
    std::size_t& other = first[r.vertex];
    if (other == requirements.size()) {
      other = i;
    } else if (requirements[other] != r) {
      return fail(
          ErrorCode::contradictory,
          "requirements contradict each other: " + names_of(std::array{other, i}, requirements),
          place_of(r));
    }
  }
  return {};
}

// Those that are the same as an earlier one. Equations would show it, too, at the cost of
// expressing each by the others.
std::vector<unsigned char> repeats(std::span<const Requirement> requirements) {
  const auto all_of = [&](std::size_t i) {
    const Requirement& r = requirements[i];
    return std::tie(r.kind, r.vertex, r.towards, r.place.face, r.place.corner, r.place.u, r.place.v,
                    r.along, r.value);
  };
  std::vector<std::size_t> order(requirements.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return all_of(a) < all_of(b); });
  std::vector<unsigned char> repeated(requirements.size(), 0);
  for (std::size_t k = 1; k < order.size(); ++k) {
    repeated[order[k]] = requirements[order[k]] == requirements[order[k - 1]] ? 1 : 0;
  }
  return repeated;
}

// Those that say all three coordinates before those that say less: of what depends on each other
// the first is kept, and a direction follows from a derivative.
std::vector<std::size_t> strongest_first(std::span<const Requirement> requirements) {
  std::vector<std::size_t> order(requirements.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) {
    return requirements[i].kind != Kind::normal && requirements[i].kind != Kind::direction;
  });
  return order;
}

// Of every requirement; empty ones if all are of vertices.
Result<std::vector<SurfaceStencil>> stencils_of(const Mesh& refined, const Rules& rules,
                                                std::span<const Requirement> requirements,
                                                const std::vector<SurfacePlace>& places,
                                                const Context& context) {
  const auto first = std::find_if_not(requirements.begin(), requirements.end(), is_of_vertex);
  if (first == requirements.end()) return std::vector<SurfaceStencil>(requirements.size());
  if (rules.scheme != Scheme::catmull_clark) {
    return refuse_requirement(
        *first, static_cast<std::size_t>(first - requirements.begin()),
        "under this scheme vertices can be moved and removed; normals, derivatives and "
        "points elsewhere need the scheme catmull-clark, which takes triangles, too");
  }
  const auto surface = LimitSurface::create(refined, rules, context);
  if (!surface) return tl::make_unexpected(surface.error());
  return surface->stencils(places, context);
}

}  // namespace

Result<RequirementRows> requirement_rows(const Mesh& refined, const Rules& rules, const Mesh& given,
                                         std::span<const Requirement> requirements,
                                         const Context& context) {
  RequirementRows out;
  out.targets = given.points;
  const auto located = located_requirements(given, requirements);
  if (!located) return tl::make_unexpected(located.error());
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    if (requirements[i].kind == Kind::remove) {
      out.released.resize(given.vertex_count(), 0);
      out.released[requirements[i].vertex] = 1;
    }
    out.places.push_back((*located)[i].place);
    out.along.push_back((*located)[i].along);
  }
  if (auto ok = check_vertices(requirements, given); !ok) return tl::make_unexpected(ok.error());
  out.repeated = repeats(requirements);
  auto stencils = stencils_of(refined, rules, requirements, out.places, context);
  if (!stencils) return tl::make_unexpected(stencils.error());
  if (auto ok = check_tangents(requirements, *stencils, out); !ok) {
    return tl::make_unexpected(ok.error());
  }
  out.first_there = first_there(requirements, *stencils);
  Equations equations(out, requirements.size());
  for (const std::size_t i : strongest_first(requirements)) {
    if (auto ok = equations.add(requirements[i], i, (*located)[i], std::move((*stencils)[i]));
        !ok) {
      return tl::make_unexpected(ok.error());
    }
  }
  if (auto ok = check_places(requirements, out); !ok) return tl::make_unexpected(ok.error());
  return out;
}

}  // namespace surpass

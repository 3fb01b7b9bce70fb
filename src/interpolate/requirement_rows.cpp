#include "interpolate/requirement_rows.hpp"

#include <cmath>
#include <map>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "interpolate/tangent_place.hpp"
#include "interpolate/tangent_wishes.hpp"
#include "scheme/quarter.hpp"

namespace surpass {
namespace {

using Kind = Requirement::Kind;

tl::unexpected<Error> refuse(const Requirement& r, std::size_t number, std::string_view why) {
  return fail(ErrorCode::invalid_argument,
              fmt::format("requirement {} ({}): {}", number, describe(r), why), place_of(r));
}

bool is_finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// A corner of each vertex, the first in the order of faces; kNone for isolated ones.
std::vector<Index> first_corners(const Mesh& given) {
  std::vector<Index> first(given.vertex_count(), kNone);
  for (Index c = given.corner_count(); c > 0; --c) first[given.face_vertices[c - 1]] = c - 1;
  return first;
}

struct Located {
  SurfacePlace place;  // on the refined mesh
  std::array<double, 2> along;
};

class Locator {
 public:
  Locator(const Mesh& given, std::span<const Requirement> requirements)
      : given_(given), corners_(first_corners(given)) {
    for (const Requirement& r : requirements) edges_needed_ = edges_needed_ || r.towards != kNone;
    for (Index f = 0; edges_needed_ && f < given.face_count(); ++f) {
      const auto face = given.face(f);
      for (std::size_t k = 0; k < face.size(); ++k) {
        const Index corner = given.face_offsets[f] + static_cast<Index>(k);
        leaving_[{face[k], face[(k + 1) % face.size()]}] = corner;
        before_[{face[(k + 1) % face.size()], face[k]}] =
            given.face_offsets[f] + static_cast<Index>((k + 1) % face.size());
      }
    }
  }

  [[nodiscard]] Result<Located> locate(const Requirement& r, std::size_t number) const {
    if (r.vertex == kNone) return on_face(r, number);
    if (r.vertex >= given_.vertex_count()) {
      return refuse(r, number, fmt::format("there are {} vertices", given_.vertex_count()));
    }
    const Index corner = corners_[r.vertex];
    if (corner == kNone) return refuse(r, number, "the vertex has no face");
    if (r.towards == kNone) {
      if (r.kind == Kind::direction || r.kind == Kind::derivative) {
        return refuse(r, number, "at a vertex, a derivative has to name the neighbour it goes to");
      }
      return Located{{corner, 0, 0}, r.along};
    }
    if (const auto at = leaving_.find({r.vertex, r.towards}); at != leaving_.end()) {
      return Located{{at->second, 0, 0}, {1, 0}};
    }
    if (const auto at = before_.find({r.vertex, r.towards}); at != before_.end()) {
      return Located{{at->second, 0, 0}, {0, 1}};
    }
    return refuse(r, number, fmt::format("no edge leads to vertex {}", r.towards));
  }

 private:
  [[nodiscard]] Result<Located> on_face(const Requirement& r, std::size_t number) const {
    const SurfacePlace& p = r.place;
    if (r.kind == Kind::remove) return refuse(r, number, "only vertices can be removed");
    if (p.face >= given_.face_count()) {
      return refuse(r, number, fmt::format("there are {} faces", given_.face_count()));
    }
    const auto m = static_cast<Index>(given_.face(p.face).size());
    if (p.corner == kNone ? m != 4 : p.corner >= m) {
      return refuse(
          r, number,
          fmt::format("the face has {} vertices; {}", m,
                      p.corner == kNone ? "name one of its corners" : "corners count from 0"));
    }
    if (!(p.u >= 0 && p.u <= 1 && p.v >= 0 && p.v <= 1)) {
      return refuse(r, number, "parameters lie between 0 and 1");
    }
    Located located{{}, r.along};
    located.place = refined_place(given_, p, located.along);
    return located;
  }

  const Mesh& given_;
  std::vector<Index> corners_;
  bool edges_needed_ = false;
  std::map<std::array<Index, 2>, Index> leaving_;  // a corner whose next vertex is the second
  std::map<std::array<Index, 2>, Index> before_;   // a corner whose previous vertex is the second
};

Result<void> check_numbers(const Requirement& r, std::size_t number) {
  if (r.kind == Kind::remove) return {};
  if (!is_finite(r.value)) return refuse(r, number, "its numbers are not finite");
  const bool has_direction = r.kind == Kind::normal || r.kind == Kind::direction;
  if (has_direction && r.value == Point{}) return refuse(r, number, "it has the length 0");
  const bool has_along = r.kind == Kind::direction || r.kind == Kind::derivative;
  if (!has_along) return {};
  const auto [a, b] = r.along;
  if (!std::isfinite(a) || !std::isfinite(b) || (a == 0 && b == 0)) {
    return refuse(r, number, "it has no direction of derivative");
  }
  return {};
}

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
  explicit Equations(RequirementRows& out) : out_(out) {}

  Result<void> add(const Requirement& r, std::size_t number, const Located& at,
                   SurfaceStencil stencil) {
    out_.first_row.push_back(out_.rows.size());
    switch (r.kind) {
      case Kind::remove: return {};
      case Kind::position: return position(r, number, std::move(stencil));
      case Kind::normal: {
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
      return refuse(r, number, "the surface has no derivative there: it stays irregular");
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

// Positions and removals at the same vertex cannot both be meant, unless they say the same. Marks
// those that do.
Result<std::vector<unsigned char>> repeats(std::span<const Requirement> requirements,
                                           const Mesh& given) {
  std::vector<unsigned char> repeated(requirements.size(), 0);
  std::vector<std::size_t> first(given.vertex_count(), requirements.size());
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    const Requirement& r = requirements[i];
    if (!is_of_vertex(r)) continue;
    std::size_t& other = first[r.vertex];
    if (other == requirements.size()) {
      other = i;
    } else if (requirements[other] == r) {
      repeated[i] = 1;
    } else {
      return fail(ErrorCode::contradictory,
                  fmt::format("requirements contradict each other: {} ({}), {} ({})", other,
                              describe(requirements[other]), i, describe(r)),
                  place_of(r));
    }
  }
  return repeated;
}

// Of every requirement; empty ones if all are of vertices.
Result<std::vector<SurfaceStencil>> stencils_of(const Mesh& refined, const Rules& rules,
                                                std::span<const Requirement> requirements,
                                                const std::vector<SurfacePlace>& places,
                                                const Context& context) {
  const auto first = std::find_if_not(requirements.begin(), requirements.end(), is_of_vertex);
  if (first == requirements.end()) return std::vector<SurfaceStencil>(requirements.size());
  if (rules.scheme != Scheme::catmull_clark) {
    return refuse(*first, static_cast<std::size_t>(first - requirements.begin()),
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
  const Locator locator(given, requirements);
  std::vector<Located> located;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    const Requirement& r = requirements[i];
    if (auto ok = check_numbers(r, i); !ok) return tl::make_unexpected(ok.error());
    auto at = locator.locate(r, i);
    if (!at) return tl::make_unexpected(at.error());
    if (r.kind == Kind::remove) {
      out.released.resize(given.vertex_count(), 0);
      out.released[r.vertex] = 1;
    }
    out.places.push_back(at->place);
    out.along.push_back(at->along);
    located.push_back(*at);
  }
  auto repeated = repeats(requirements, given);
  if (!repeated) return tl::make_unexpected(repeated.error());
  out.repeated = std::move(*repeated);
  auto stencils = stencils_of(refined, rules, requirements, out.places, context);
  if (!stencils) return tl::make_unexpected(stencils.error());
  if (auto ok = check_tangents(requirements, *stencils, out.along); !ok) {
    return tl::make_unexpected(ok.error());
  }
  out.first_there = first_there(requirements, *stencils);
  Equations equations(out);
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    if (auto ok = equations.add(requirements[i], i, located[i], std::move((*stencils)[i])); !ok) {
      return tl::make_unexpected(ok.error());
    }
  }
  if (auto ok = check_places(requirements, out); !ok) return tl::make_unexpected(ok.error());
  return out;
}

}  // namespace surpass

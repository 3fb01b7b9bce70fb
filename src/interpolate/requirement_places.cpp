#include "interpolate/requirement_places.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "interpolate/requirement_rows.hpp"
#include "mesh/wording.hpp"
#include "scheme/quarter.hpp"

namespace surpass {
namespace {

using Kind = Requirement::Kind;

bool is_finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// A corner of each vertex, the first in the order of faces; kNone for isolated ones.
std::vector<Index> first_corners(const Mesh& given) {
  std::vector<Index> first(given.vertex_count(), kNone);
  for (Index c = given.corner_count(); c > 0; --c) first[given.face_vertices[c - 1]] = c - 1;
  return first;
}

class Locator {
 public:
  Locator(const Mesh& given, std::span<const Requirement> requirements)
      : given_(given), corners_(first_corners(given)) {
    std::vector<unsigned char> asked(given.vertex_count(), 0);  // for edges there
    bool any = false;
    for (const Requirement& r : requirements) {
      if (r.towards == kNone || r.vertex >= given.vertex_count()) continue;
      asked[r.vertex] = 1;
      any = true;
    }
    for (Index f = 0; any && f < given.face_count(); ++f) {
      const auto face = given.face(f);
      for (std::size_t k = 0; k < face.size(); ++k) {
        if (asked[face[k]] == 0) continue;
        const Index corner = given.face_offsets[f] + static_cast<Index>(k);
        leaving_[{face[k], face[(k + 1) % face.size()]}] = corner;
        before_[{face[k], face[(k + face.size() - 1) % face.size()]}] = corner;
      }
    }
  }

  [[nodiscard]] Result<LocatedRequirement> locate(const Requirement& r, std::size_t number) const {
    if (r.vertex == kNone) return on_face(r, number);
    if (r.vertex >= given_.vertex_count()) {
      return refuse_requirement(r, number,
                                fmt::format("there are {} vertices", given_.vertex_count()));
    }
    const Index corner = corners_[r.vertex];
    if (corner == kNone) return refuse_requirement(r, number, "the vertex has no face");
    if (r.towards == kNone) {
      if (r.kind == Kind::direction || r.kind == Kind::derivative) {
        return refuse_requirement(r, number,
                                  "at a vertex, a derivative has to name the neighbour it goes to");
      }
      return LocatedRequirement{{corner, 0, 0}, r.along};
    }
    if (const auto at = leaving_.find({r.vertex, r.towards}); at != leaving_.end()) {
      return LocatedRequirement{{at->second, 0, 0}, {1, 0}};
    }
    if (const auto at = before_.find({r.vertex, r.towards}); at != before_.end()) {
      return LocatedRequirement{{at->second, 0, 0}, {0, 1}};
    }
    return refuse_requirement(r, number, fmt::format("no edge leads to vertex {}", r.towards));
  }

 private:
  [[nodiscard]] Result<LocatedRequirement> on_face(const Requirement& r, std::size_t number) const {
    const SurfacePlace& p = r.place;
    if (r.kind == Kind::remove)
      return refuse_requirement(r, number, "only vertices can be removed");
    if (p.face >= given_.face_count()) {
      return refuse_requirement(r, number, fmt::format("there are {} faces", given_.face_count()));
    }
    const auto m = static_cast<Index>(given_.face(p.face).size());
    if (p.corner == kNone ? m != 4 : p.corner >= m) {
      return refuse_requirement(
          r, number,
          fmt::format("the face has {} vertices; {}", m,
                      p.corner == kNone ? "name one of its corners" : "corners count from 0"));
    }
    if (!(p.u >= 0 && p.u <= 1 && p.v >= 0 && p.v <= 1)) {
      return refuse_requirement(r, number, "parameters lie between 0 and 1");
    }
    LocatedRequirement located{{}, r.along};
    located.place = refined_place(given_, p, located.along);
    return located;
  }

  const Mesh& given_;
  std::vector<Index> corners_;
  std::map<std::array<Index, 2>, Index> leaving_;  // a corner whose next vertex is the second
  std::map<std::array<Index, 2>, Index> before_;   // a corner whose previous vertex is the second
};

// At a vertex the edge is the direction.
bool has_along(const Requirement& r) {
  return r.vertex == kNone && (r.kind == Kind::direction || r.kind == Kind::derivative);
}

// The numbers by their length; as they are where they have none.
template <class Numbers>
void make_unit(Numbers& numbers, double& length) {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::abs(x));
  if (!(largest > 0) || !std::isfinite(largest)) return;
  double square = 0;
  for (const double x : numbers) square += x / largest * (x / largest);
  for (double& x : numbers) x = x / largest / std::sqrt(square);
  length = largest * std::sqrt(square);
}

// "7, 9-40": ascending numbers, those that follow each other in one.
std::string in_runs(std::span<const std::size_t> numbers) {
  std::vector<std::string> runs;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    runs.push_back(last == i ? fmt::format("{}", numbers[i])
                             : fmt::format("{}-{}", numbers[i], numbers[last]));
    i = last + 1;
  }
  return joined(runs, ", ");
}

Requirement canonical(Requirement r) {
  if (r.vertex != kNone) r.place = {};
  if (r.kind == Kind::remove) r.value = {};
  double length = 1;
  if (!has_along(r)) {
    r.along = {1, 0};
  } else {
    make_unit(r.along, length);
  }
  if (r.kind == Kind::normal || r.kind == Kind::direction) {
    make_unit(r.value, length);
  } else if (r.kind == Kind::derivative) {
    for (double& x : r.value) x /= length;
  }
  return r;
}

Result<void> check_numbers(const Requirement& r, std::size_t number) {
  if (r.kind == Kind::remove) return {};
  if (!is_finite(r.value)) return refuse_requirement(r, number, "its numbers are not finite");
  const bool has_direction = r.kind == Kind::normal || r.kind == Kind::direction;
  if (has_direction && r.value == Point{})
    return refuse_requirement(r, number, "it has the length 0");
  if (!has_along(r)) return {};
  const auto [a, b] = r.along;
  if (!std::isfinite(a) || !std::isfinite(b) || (a == 0 && b == 0)) {
    return refuse_requirement(r, number, "it has no direction of derivative");
  }
  return {};
}

}  // namespace

tl::unexpected<Error> refuse_requirement(const Requirement& r, std::size_t number,
                                         std::string_view why, ErrorCode code) {
  return fail(code, fmt::format("requirement {} ({}): {}", number, describe(r), why), place_of(r));
}

std::string names_of(std::span<const std::size_t> numbers,
                     std::span<const Requirement> requirements) {
  constexpr std::size_t kDescribed = 6;
  const auto described = numbers.first(std::min(kDescribed, numbers.size()));
  std::vector<std::string> names;
  for (const std::size_t i : described) {
    names.push_back(fmt::format("{} ({})", i, describe(requirements[i])));
  }
  const auto others = numbers.subspan(described.size());
  const std::string more =
      others.empty() ? "" : fmt::format(" and {} more: {}", others.size(), in_runs(others));
  return joined(names, ", ") + more;
}

std::vector<Requirement> canonical(std::span<const Requirement> requirements) {
  std::vector<Requirement> all;
  all.reserve(requirements.size());
  for (const Requirement& r : requirements) all.push_back(canonical(r));
  return all;
}

Result<std::vector<LocatedRequirement>> located_requirements(
    const Mesh& given, std::span<const Requirement> requirements) {
  const Locator locator(given, requirements);
  std::vector<LocatedRequirement> located;
  located.reserve(requirements.size());
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    if (auto ok = check_numbers(requirements[i], i); !ok) return tl::make_unexpected(ok.error());
    const auto at = locator.locate(requirements[i], i);
    if (!at) return tl::make_unexpected(at.error());
    located.push_back(*at);
  }
  return located;
}

Result<void> check_requirements(const Mesh& given, std::span<const Requirement> requirements) {
  const auto located = located_requirements(given, canonical(requirements));
  if (!located) return tl::make_unexpected(located.error());
  return {};
}

}  // namespace surpass

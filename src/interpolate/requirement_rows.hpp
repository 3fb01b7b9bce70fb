// Requirements as linear equations of the control points, which are those of the given mesh refined
// once: Lai and Cheng 2006, section 3. A normal or a direction is two equations: all that is across
// it vanishes.
#pragma once

#include <surpass/requirements.hpp>
#include <surpass/scheme.hpp>
#include <surpass/topology.hpp>

#include <vector>

namespace surpass {

/// In box sides: squares of larger numbers may overflow.
constexpr double kFarthest = 1e100;
constexpr char kTooLarge[] =
    "its numbers are so large beside the given mesh that nothing can be computed with both";

/// Vertices are moved and removed on surfaces of every scheme; the rest needs one that is evaluated
/// anywhere.
[[nodiscard]] inline bool is_of_vertex(const Requirement& r) {
  const bool moves = r.kind == Requirement::Kind::position || r.kind == Requirement::Kind::remove;
  return r.vertex != kNone && moves;
}

[[nodiscard]] inline Place place_of(const Requirement& r) {
  if (r.vertex != kNone) return {.vertex = r.vertex};
  return {.face = r.place.face};
}

/// The sum over columns of weights[c] * (normal . control point) = value.
struct RequirementRow {
  std::size_t requirement;
  Point normal;
  std::size_t stencil;  ///< RequirementRows::weights
  double value;
  /// Not asked for, but chosen: left out where it depends on others, whatever they say.
  bool chosen = false;
};

struct RequirementRows {
  struct Weights {
    std::vector<Index> columns;
    std::vector<double> values;
  };
  std::vector<Weights> weights;
  std::vector<RequirementRow> rows;
  std::vector<std::size_t> first_row;   ///< of each requirement; the next one's where it has none
  std::vector<unsigned char> repeated;  ///< of each: it is the same as an earlier one, and has none
  std::vector<unsigned char> released;  ///< #given: removed vertices; empty without any
  std::vector<Point> targets;           ///< #given points, positions at vertices replaced
  std::vector<SurfacePlace> places;     ///< of each requirement, on the refined mesh
  std::vector<std::array<double, 2>> along;  ///< the same, by those parameters
  /// Of each: the first one that is of tangents at the same place; itself if it is of none.
  std::vector<std::size_t> first_there;
};

/// Of canonical requirements. Fails where check_requirements() does; with `contradictory`, naming
/// the requirement, where the surface has no such tangent or no tangent plane, and, naming all, if
/// two say different things of one vertex or of its tangents.
[[nodiscard]] Result<RequirementRows> requirement_rows(const Mesh& refined, const Rules& rules,
                                                       const Mesh& given,
                                                       std::span<const Requirement> requirements,
                                                       const Context& context);

}  // namespace surpass

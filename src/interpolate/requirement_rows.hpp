// Requirements as linear equations of the control points, which are those of the given mesh refined
// once: Lai and Cheng 2006, section 3. A normal or a direction is two equations: all that is across
// it vanishes.
#pragma once

#include <surpass/requirements.hpp>
#include <surpass/scheme.hpp>
#include <surpass/topology.hpp>

#include <vector>

namespace surpass {

/// The sum over columns of weights[c] * (normal . control point) = value.
struct RequirementRow {
  std::size_t requirement;
  Point normal;
  std::size_t stencil;  ///< RequirementRows::weights
  double value;
};

struct RequirementRows {
  struct Weights {
    std::vector<Index> columns;
    std::vector<double> values;
  };
  std::vector<Weights> weights;
  std::vector<RequirementRow> rows;
  std::vector<unsigned char> released;       ///< #given: removed vertices; empty without any
  std::vector<Point> targets;                ///< #given points, positions at vertices replaced
  std::vector<SurfacePlace> places;          ///< of each requirement, on the refined mesh
  std::vector<std::array<double, 2>> along;  ///< the same, by those parameters
};

/// Fails, naming the requirement, on vertices, places or neighbours that do not exist, numbers that
/// are not finite, normals and directions of length 0, two for the position of one vertex, and
/// where the surface has no such tangent.
[[nodiscard]] Result<RequirementRows> requirement_rows(const Mesh& refined, const Rules& rules,
                                                       const Mesh& given,
                                                       std::span<const Requirement> requirements,
                                                       const Context& context);

}  // namespace surpass

// What an interpolating surface shall do besides passing through the given vertices: normals,
// derivatives and points anywhere, given vertices moved or let go.
#pragma once

#include <surpass/evaluate.hpp>
#include <surpass/mesh.hpp>
#include <surpass/topology.hpp>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace surpass {

/// One requirement, at a vertex of the given mesh or, where `vertex` is kNone, at a place on it. A
/// position at a vertex takes the place of the given one.
struct Requirement {
  enum class Kind {
    position,    ///< the surface passes through `value`
    normal,      ///< the surface has the normal `value`, of any length but 0
    direction,   ///< the derivative along `along` points in the direction `value`
    derivative,  ///< the derivative along `along` is `value`
    remove,      ///< the surface need not pass through `vertex`
  };
  Kind kind = Kind::position;
  Index vertex = kNone;
  SurfacePlace place = {};
  Point value = {};
  /// a du + b dv, by the parameters of the place; see SurfaceSample for what du and dv are where
  /// the surface is irregular. At a vertex it has no meaning: `towards` says it.
  std::array<double, 2> along = {1, 0};
  /// At a vertex, for directions and derivatives: the neighbour along whose edge they go. The
  /// derivative is by the parameter that has 1 in the middle of the edge.
  Index towards = kNone;
  bool operator==(const Requirement&) const = default;
};

/// "position", "normal", "direction", "derivative", "remove".
[[nodiscard]] const char* name_of(Requirement::Kind kind);
[[nodiscard]] Result<Requirement::Kind> requirement_kind_named(std::string_view name);

/// In words, such as "normal at vertex 7".
[[nodiscard]] std::string describe(const Requirement& requirement);

/// Fails with `invalid_argument`, naming the requirement, on vertices, places and neighbours that
/// the given mesh has not, numbers that are not finite, and normals and directions of length 0.
/// Whether a surface can do what is asked is not looked at.
[[nodiscard]] Result<void> check_requirements(const Mesh& given,
                                              std::span<const Requirement> requirements);

/// A normal at every vertex where the surface has one: not at isolated vertices, bow-ties, corners,
/// where creases of infinite sharpness meet or pass, under edge_only at vertices of one face, and
/// on Catmull-Clark surfaces inside at vertices of two.
/// Where `normals` (#V) has no direction, none is required. Fails where Topology::build does, and
/// with `mismatch` if the sizes differ or if most of them point to the back of the faces at their
/// vertices: the surface would have to turn over at each.
[[nodiscard]] Result<std::vector<Requirement>> normals_everywhere(const Mesh& mesh,
                                                                  const Rules& rules,
                                                                  std::span<const Point> normals);

/// Whether normals, directions or derivatives are required on the boundary of the given mesh, where
/// OpenMeshes::dummy_ring meets them better. False where Topology::build fails.
[[nodiscard]] bool prescribes_at_boundary(const Mesh& given,
                                          std::span<const Requirement> requirements);

/// Of what a surface that was found for requirements is asked: none is missed by more, relative to
/// the box side, whatever the tolerance of the given vertices.
inline constexpr double kRequirementTolerance = 1e-10;

/// What became of a requirement.
struct RequirementOutcome {
  bool redundant = false;  ///< it follows from the others, or from the given vertices
  /// What is left of its equations on the final surface, relative to the side of the given points'
  /// box, with those that requirements move at their new places: the distance of positions, the
  /// difference of derivatives, the part of du and dv along the normal (by the parameters of the
  /// mesh refined once), the part of the derivative across the direction; derivatives along `along`
  /// at length 1. Where the surface has the opposite normal or direction, its tangents' distance
  /// from the nearest that have not.
  double error = 0;
  /// The angle to the normal or direction in radians, 0 to pi; 0 for other kinds.
  double angle = 0;
  /// The surface has the opposite normal or direction, or none at all.
  bool flipped = false;
  /// Its tangents would have vanished, or gone the other way, and were given lengths.
  bool length_chosen = false;
  /// The derivatives that are required there are parallel, so that the surface has no tangent
  /// plane.
  bool without_plane = false;
};

/// A sentence each, with a count and the first of them, on those of #requirements that were
/// dropped, that point the other way, or are missed by more than `tolerance`.
[[nodiscard]] std::vector<std::string> notes_on(std::span<const Requirement> requirements,
                                                std::span<const RequirementOutcome> outcomes,
                                                double tolerance);

/// Whether every error is within the tolerance.
[[nodiscard]] bool all_met(std::span<const RequirementOutcome> outcomes, double tolerance);

}  // namespace surpass

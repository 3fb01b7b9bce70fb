// What the rest of the library knows of a subdivision scheme. One object a scheme; nothing outside
// this folder asks which one it is.
#pragma once

#include <memory>

#include "scheme/limit_operator.hpp"
#include "scheme/limit_samples.hpp"
#include "scheme/patch_kind.hpp"
#include "scheme/steps.hpp"
#include "scheme/surface_evaluator.hpp"

namespace surpass {

class PatchRows;

class SubdivisionScheme {
 public:
  SubdivisionScheme() = default;
  SubdivisionScheme(const SubdivisionScheme&) = delete;
  SubdivisionScheme& operator=(const SubdivisionScheme&) = delete;
  virtual ~SubdivisionScheme() = default;

  [[nodiscard]] virtual const char* name() const = 0;   ///< as on the command line
  [[nodiscard]] virtual const char* title() const = 0;  ///< as in a sentence

  /// Vertices that each face must have; 0 for any number.
  [[nodiscard]] virtual Index face_size() const { return 0; }
  [[nodiscard]] virtual bool has_boundary_rule(Boundary boundary) const {
    return boundary == Boundary::edge_only || boundary == Boundary::edge_and_corner;
  }

  // The rules and the faces have been checked when these are called; what else a scheme refuses
  // (a kind of crease, say) it finds by itself.
  [[nodiscard]] virtual Result<LimitOperator> limit_operator(const Mesh& mesh,
                                                             const Topology& topology,
                                                             const Rules& rules,
                                                             const Context& context) const = 0;
  /// One refinement step: the refined mesh without positions and vertex channels. The rows that
  /// make these go to `sink`: one for each refined vertex, over the given ones.
  [[nodiscard]] virtual Result<Mesh> refinement(const Mesh& mesh, const Topology& topology,
                                                const Rules& rules, const Context& context,
                                                RowSink& sink) const = 0;
  [[nodiscard]] virtual Result<std::vector<Point>> limit_normals(const Mesh& mesh,
                                                                 const Topology& topology,
                                                                 const Rules& rules,
                                                                 const Context& context) const = 0;

  /// What evaluates the surface between its vertices; it may refer to the topology, which stays.
  /// Here: there is none, an error.
  [[nodiscard]] virtual Result<std::unique_ptr<const SurfaceEvaluator>> evaluator(
      const Mesh& mesh, const Topology& topology, const Rules& rules, const Context& context) const;

  /// Refinement turns corner c into face c, a quad, and the vertices keep their numbers.
  [[nodiscard]] virtual bool makes_corners_faces() const { return false; }

  /// The limit points of the given vertices as rows over the vertices of `refined`, the mesh that
  /// one step made of `given` (faces, creases and corners; no points are needed), perhaps with
  /// vertices added behind. `topology` is that of `refined`. Fails if `refined` cannot be that.
  [[nodiscard]] virtual Result<SparseRows> given_limits(const Mesh& refined,
                                                        const Topology& topology,
                                                        const Rules& rules, const Mesh& given,
                                                        const Context& context) const = 0;
  /// Whether given_limits() looks at the faces of the given mesh, and not only counts its vertices.
  [[nodiscard]] virtual bool finds_given_by_faces() const { return false; }

  /// The derivatives of face 0 of a piece of a control mesh: that face and all that touch it, with
  /// the creases and corners that touch it; or, where patches belong to vertices, of vertex 0, with
  /// the faces at it. `level` refinements lead to its samples. Columns are the vertices of the
  /// piece. `sides`: how many times the samples on each side of the patch count; 1, or 0 and 2
  /// where one of two patches has them for both. `cut`: vertices of the piece at which it has only
  /// the faces next to face 0, two on either side (or, where patches belong to vertices, faces of
  /// which it has three corners only). Derivatives that cannot be told are left out.
  [[nodiscard]] virtual Result<PatchKind> patch_kind(const Mesh& piece, const Rules& rules,
                                                     int level,
                                                     std::span<const unsigned char> sides,
                                                     std::span<const Index> cut) const = 0;

  /// See PatchRows::build. Here: a patch a face.
  [[nodiscard]] virtual Result<PatchRows> patch_rows(const Mesh& mesh, const Topology& topology,
                                                     const Rules& rules, int level,
                                                     std::span<const unsigned char> sampled,
                                                     const Context& context, Sides sides) const;

  /// See surpass::limit_mesh, but with its hole faces. Here: the refined vertices, moved to their
  /// limits.
  [[nodiscard]] virtual Result<Mesh> limit_mesh(const Mesh& control, const Rules& rules, int levels,
                                                const Context& context, Steps& steps) const;

  /// What the surface is like at a vertex of a refined mesh.
  [[nodiscard]] virtual Spot spot(const Topology& topology, const Sharpness& sharpness,
                                  Index v) const = 0;
  /// Position and derivatives at a regular spot.
  [[nodiscard]] virtual LimitJet jet(const Mesh& mesh, const Topology& topology, Index v) const = 0;
  /// Area of a regular patch in the parameters of the jets.
  [[nodiscard]] virtual double patch_measure() const { return 1; }

  /// The surface after `levels` (1 or more) refinements, as patches with samples. Here: a patch a
  /// face, its samples at its vertices.
  [[nodiscard]] virtual Result<LimitSamples> limit_samples(const Mesh& control, const Rules& rules,
                                                           int levels,
                                                           const Context& context) const;

 protected:
  /// Spots and jets of samples.mesh.
  void fill_jets(LimitSamples& samples, const Topology& topology, const Sharpness& sharpness,
                 const Context& context) const;
};

[[nodiscard]] const SubdivisionScheme& scheme_of(Scheme scheme);

/// Fails if the scheme lacks the boundary rule or does not take a face.
Result<void> require_suitable(const SubdivisionScheme& scheme, const Topology& topology,
                              const Rules& rules);

/// Limit points of the given vertices on `refined`, a mesh that one step made of `given`, as
/// SubdivisionScheme::given_limits has it. Fails where Topology::build does, or if the scheme does
/// not take such faces.
[[nodiscard]] Result<std::vector<Point>> given_limit_points(const Mesh& refined, const Mesh& given,
                                                            const Rules& rules,
                                                            const Context& context);

/// See surpass::refine and surpass::limit_mesh.
[[nodiscard]] Result<Mesh> refine(const Mesh& control, const Rules& rules, int levels,
                                  const Context& context, Steps& steps);
[[nodiscard]] Result<Mesh> limit_mesh(const Mesh& control, const Rules& rules, int levels,
                                      const Context& context, Steps& steps);

/// Moves the vertices of a refined mesh: positions and vertex channels are replaced by their limits
/// under `rows`, the normals put into channel "normal", and what says that the mesh is a control
/// mesh is taken away.
void move_to_limit(Mesh& mesh, const SparseRows& rows, const std::vector<Point>& normals,
                   const Context& context, Steps& steps);

/// The second half of it: puts the normals in, takes away what says that it is a control mesh.
void add_limit_normals(Mesh& mesh, const std::vector<Point>& normals);

}  // namespace surpass

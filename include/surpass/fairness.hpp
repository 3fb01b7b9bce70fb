// Is it fair? Energies and curvatures of a control mesh's limit surface, to compare methods by.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/nonstationary.hpp>
#include <surpass/scheme.hpp>

#include <cstddef>
#include <vector>

namespace surpass {

struct FairnessOptions {
  int levels = 0;  ///< refinements before the surface is sampled, 1 or more; 0: fairness_levels()
  int rings = 2;   ///< rings of samples left out around an extraordinary one, besides itself
};

/// How much of the surface the measures saw. Left out are: patches at boundaries, creases and
/// corners, those at extraordinary samples and at `rings` rings of samples around these (curvature
/// need not be bounded there), and those at samples without a tangent plane. Hole faces do not
/// count at all. An extraordinary sample is, on a refined mesh, an interior vertex whose faces are
/// not four quads (six triangles for Loop), or one on a curve that has no such regular faces beside
/// it, as at darts.
struct FairnessCoverage {
  std::size_t patches = 0;             ///< in all
  std::size_t measured_patches = 0;    ///< that the measures are taken over
  std::size_t samples = 0;             ///< at their corners or centres
  std::size_t degenerate_samples = 0;  ///< regular ones without a tangent plane
  double area = 0;                     ///< of the whole surface
  double measured_area = 0;            ///< A below
  double left_out = 0;                 ///< share of the area, 0 to 1
};

/// Fairness measures over the measured part of the surface, of area A. k1 and k2 are the principal
/// curvatures, H their mean, K their product. A measure that is said to be free of scale is the
/// same for a mesh of twice the size; all but the thin plate's do not depend on parameters.
struct Fairness {
  int levels = 0;
  FairnessCoverage coverage;

  /// Integral of k1^2 + k2^2 over the surface; free of scale. It is also the thin plate's energy
  /// in the surface's own form: the integral of |second derivatives|^2 along geodesics.
  double bending = 0;
  /// The same apart from the sharpest hundredth of the area. Where a surface nearly folds, a few
  /// samples make nearly all of the other integrals.
  double trimmed_bending = 0;

  /// Integral of |Suu|^2 + 2 |Suv|^2 + |Svv|^2 du dv in units of length^2, over the control mesh's
  /// own parameters, in which its regular faces are unit squares (equilateral triangles with edges
  /// of length 1): what thin-plate fairing minimises. Halstead, Kass, DeRose 1993.
  double thin_plate = 0;
  /// The same times (area of the parameters / A): free of scale, and the same for a control mesh
  /// and its refined meshes.
  double thin_plate_relative = 0;

  /// Integral of |grad H|^2 over the surface, in 1 / length^2; with H linear between samples. On
  /// Doo-Sabin surfaces curvature jumps between patches, so there it grows with the levels; compare
  /// at equal levels.
  double curvature_variation = 0;
  double curvature_variation_relative = 0;  ///< times A: free of scale
  /// Integral of |grad H| over the surface: free of scale, finite at jumps, too.
  double total_variation = 0;

  /// Largest |k1| or |k2| at a sample, in 1 / length, and where.
  double largest_curvature = 0;
  Point largest_at = {};
  /// The same apart from the sharpest hundredth of the area.
  double high_curvature = 0;
  double largest_curvature_relative = 0;  ///< times the root of A: free of scale
  double high_curvature_relative = 0;     ///< times the root of A: free of scale

  /// Integral of K over the surface. For a closed surface that nothing is left out of it is
  /// 2 pi (V - E + F), by Gauss and Bonnet.
  double total_gauss = 0;
};

/// Angles between the normals of two surfaces at corresponding samples, weighted by the area of the
/// first, over that part of both where `fairness` measures.
struct NormalDeviation {
  FairnessCoverage coverage;  ///< of the first surface, less what the second leaves out
  double mean = 0;            ///< degrees
  double rms = 0;             ///< degrees
  double max = 0;             ///< degrees
};

/// The fewest refinements, 3 or more, that give 200 000 patches; fewer where there would be more
/// than 8 million, hole faces counted.
[[nodiscard]] int fairness_levels(const Mesh& control);

/// Refinements by which `second` needs more than `first` for as many patches: 1 where first is as
/// second refined once. Hole faces do not count.
[[nodiscard]] int level_difference(const Mesh& first, const Mesh& second);

/// Refines the control mesh, takes exact limit positions, first and second derivatives at every
/// regular vertex, and integrates with the area elements there: the mean of a patch's corners, or
/// its centre on Doo-Sabin surfaces. The error of smooth integrals falls by 4 with each level. The
/// same bits for any number of threads. About 0.5 kB and 1 microsecond a patch. Errors: as refine;
/// levels or rings out of range; a mesh without faces (empty_mesh); nothing left to measure
/// (unsuitable_for_scheme); cancelled.
[[nodiscard]] Result<Fairness> fairness(const Mesh& control, const Rules& rules,
                                        const FairnessOptions& options = {},
                                        const Context& context = {});

/// The same of a non-stationary Loop surface. NonstationaryRule::mean, of whose surfaces second
/// derivatives are not known: an error (invalid_argument).
[[nodiscard]] Result<Fairness> fairness(const Mesh& control, const NonstationaryOptions& scheme,
                                        const FairnessOptions& options = {},
                                        const Context& context = {});

/// The shape parameter, for the other options as they are, of the limit surface with the least
/// trimmed_bending: the integral of k1^2 + k2^2 apart from the sharpest hundredth of the area (all
/// of it has narrow spikes, as single spots nearly fold). Parameters are those of the limit,
/// whatever scheme.steps says.
struct FairestShape {
  double shape = 0;
  double trimmed_bending = 0;  ///< as `fairness` finds it with these:
  FairnessOptions measure;     ///< levels as taken; fewer rings than asked if nothing were left
};

/// 25 shapes over the allowed range are measured after few levels; scheme.shape and the lowest
/// places of the 25 after options.levels; from the best of these it goes downhill, and narrows the
/// place in by golden sections, to about 0.06: some 40 measurements, a dozen of which cost what
/// `fairness` does. Minima narrower than the grid, 0.33, may be missed. Where no shape is better by
/// more than rounding, as on flat meshes, it is that of `scheme`. If options.rings leave nothing to
/// measure, fewer are left out. The same bits for any number of threads. Rules without a shape
/// parameter: an error (invalid_argument). Else errors as `fairness`.
[[nodiscard]] Result<FairestShape> fairest_shape(const Mesh& control,
                                                 const NonstationaryOptions& scheme,
                                                 const FairnessOptions& options = {},
                                                 const Context& context = {});

/// Compares with the limit surface of `reference`, whose faces must be those of `control`, or
/// become those when one of them is refined more often than the other; hole faces, and vertices
/// that only they use, do not count. `options.levels` are those of `control`. Errors: as fairness;
/// `mismatch` for other faces.
[[nodiscard]] Result<NormalDeviation> normal_deviation(const Mesh& control, const Mesh& reference,
                                                       const Rules& rules,
                                                       const FairnessOptions& options = {},
                                                       const Context& context = {});

/// Curvatures of a surface at a vertex, in 1 / length and 1 / length^2; both positive on a ball
/// that is seen from outside.
struct VertexCurvature {
  double mean = 0;   ///< (k1 + k2) / 2
  double gauss = 0;  ///< k1 k2
};

/// Of a mesh as it is, #V; to look at a limit surface, hand over limit_mesh(), whose vertices and
/// normals are exact. Fitted to how the normals turn along the edges of a vertex: channel "normal"
/// where there is one, else the mean of the faces' normals. Exact on spheres with exact normals, of
/// second order in the edges' length on regular meshes; at creases and where a limit's curvature is
/// not bounded it grows as edges shorten. 0 where there is no normal, as at isolated vertices, or
/// all edges go one way. The same bits for any number of threads. O(#corners). Errors: those of
/// Topology::build, no faces, positions that are not finite, cancelled.
[[nodiscard]] Result<std::vector<VertexCurvature>> vertex_curvatures(const Mesh& surface,
                                                                     const Context& context = {});

}  // namespace surpass

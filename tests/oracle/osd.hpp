// OpenSubdiv as a second opinion: refined points and tangents of the given vertices.
#pragma once

#include <surpass/evaluate.hpp>

#include <memory>
#include <optional>
#include <vector>

#include "support/meshes.hpp"

namespace surpass::test {

/// Positions of all vertices after `levels` refinements, in OpenSubdiv's own order, and which of
/// them descends from which given vertex.
struct OsdRefined {
  std::vector<Point> points;
  std::vector<Index> descendant;  ///< #V of the given mesh
};
OsdRefined osd_refine(const Mesh& mesh, const Rules& rules, int levels);

/// Unit limit normals at the given vertices, from OpenSubdiv's limit tangents after one refinement.
std::vector<Point> osd_normals(const Mesh& mesh, const Rules& rules);

/// Position and derivatives at the first corner of a face, in the face's own parameters: u runs
/// along its first edge, v along its last, both with length 1.
struct OsdJet {
  Index face = 0;
  bool is_regular = false;  ///< one polynomial
  Point position, du, dv, duu, duv, dvv;
};
/// By Bfr, a jet for each face of the mesh that is part of the limit surface.
std::vector<OsdJet> osd_jets(const Mesh& mesh, const Rules& rules);

/// The limit surface anywhere by OpenSubdiv's own evaluator (Bfr), with its finest approximation
/// that is sound: exact at distances of more than about 1/1024 from irregular vertices.
class OsdSurface {
 public:
  OsdSurface(const Mesh& mesh, const Rules& rules);
  ~OsdSurface();
  OsdSurface(const OsdSurface&) = delete;
  OsdSurface& operator=(const OsdSurface&) = delete;

  /// Derivatives by the parameters of the place. Nothing where it refuses the face.
  [[nodiscard]] std::optional<SurfaceSample> evaluate(const SurfacePlace& place) const;

 private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

}  // namespace surpass::test

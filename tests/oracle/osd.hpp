// OpenSubdiv as a second opinion: refined points and tangents of the given vertices.
#pragma once

#include <memory>
#include <vector>

#include <opensubdiv/far/topologyRefiner.h>

#include "support/meshes.hpp"

namespace surpass::test {

/// Positions of all vertices after `levels` refinements, in OpenSubdiv's own order, and which of
/// them descends from which given vertex.
struct OsdRefined {
  std::vector<Point> points;
  std::vector<Index> descendant;  ///< #V of the given mesh
};
OsdRefined osd_refine(const Mesh& mesh, const Rules& rules, int levels);

/// OpenSubdiv's own view of the mesh, not refined yet.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> osd_refiner(const Mesh& mesh, const Rules& rules);

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

}  // namespace surpass::test

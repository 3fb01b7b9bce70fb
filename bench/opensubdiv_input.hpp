// A mesh in the arrays that OpenSubdiv takes, and its topology refiner.
#pragma once

#include <surpass/scheme.hpp>

#include <memory>
#include <vector>

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

namespace surpass::bench::osd {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

struct Vertex {
  Point position;
  void Clear() { position = {}; }
  void AddWithWeight(const Vertex& other, double weight) {
    for (std::size_t k = 0; k < 3; ++k) position[k] += weight * other.position[k];
  }
};
using Vertices = std::vector<Vertex>;

struct Input {
  std::vector<int> sizes;
  std::vector<int> corners;
  Vertices vertices;
};

inline Input input_of(const Mesh& mesh) {
  Input input{{}, std::vector<int>(mesh.face_vertices.begin(), mesh.face_vertices.end()), {}};
  for (Index f = 0; f < mesh.face_count(); ++f) {
    input.sizes.push_back(static_cast<int>(mesh.face(f).size()));
  }
  for (const Point& p : mesh.points) input.vertices.push_back({p});
  return input;
}

inline std::shared_ptr<Far::TopologyRefiner> refiner_of(const Input& input,
                                                        Scheme scheme = Scheme::loop) {
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(input.vertices.size());
  descriptor.numFaces = static_cast<int>(input.sizes.size());
  descriptor.numVertsPerFace = input.sizes.data();
  descriptor.vertIndicesPerFace = input.corners.data();
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  const auto type = scheme == Scheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
  return std::shared_ptr<Far::TopologyRefiner>(Factory::Create(descriptor, {type, options}));
}

}  // namespace surpass::bench::osd

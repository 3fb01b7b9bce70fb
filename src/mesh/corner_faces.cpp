#include "mesh/corner_faces.hpp"

namespace surpass {

std::vector<Index> corner_faces(const Mesh& mesh) {
  std::vector<Index> faces;
  faces.reserve(mesh.face_vertices.size());
  for (Index f = 0; f < mesh.face_count(); ++f) faces.insert(faces.end(), mesh.face(f).size(), f);
  return faces;
}

}  // namespace surpass

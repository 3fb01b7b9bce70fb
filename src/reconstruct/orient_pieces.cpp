#include <surpass/topology.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "mesh/disjoint_sets.hpp"
#include "reconstruct/clean_up.hpp"
#include "reconstruct/vectors.hpp"

namespace surpass::reconstruction {
namespace {

using Eigen::Vector3d;

struct Piece {
  bool open = false;
  double area = 0;                     // twice, as the cross products are
  Vector3d centre = Vector3d::Zero();  // of the faces, times area
  Vector3d normal = Vector3d::Zero();  // sum of cross products
  double along_normals = 0;            // of the points
  double volume = 0;                   // six times, about the centre
};

// Positive for a piece that may stay as it is.
double verdict(const Piece& piece) {
  constexpr double kFlat = 1e-3;
  if (piece.open && piece.along_normals != 0) return piece.along_normals;
  if (piece.open && std::abs(piece.volume) < kFlat * std::pow(piece.area, 1.5)) {
    Eigen::Index axis = 0;
    piece.normal.cwiseAbs().maxCoeff(&axis);
    return piece.normal[axis];
  }
  return piece.volume;
}

}  // namespace

void orient_pieces(Mesh& mesh, std::span<const Point> normals) {
  const auto topology = Topology::build(mesh);
  if (!topology) return;
  DisjointSets sets(mesh.face_count());
  std::vector<Piece> pieces(mesh.face_count());
  for (Index h = 0; h < topology->corner_count(); ++h) {
    const Index other = topology->opposite(h);
    if (other != kNone) sets.unite(topology->face(h), topology->face(other));
  }
  for (Index h = 0; h < topology->corner_count(); ++h) {
    if (topology->opposite(h) == kNone) pieces[sets.find(topology->face(h))].open = true;
  }
  const auto corner = [&](Index f, std::size_t k) {
    return as_vector(mesh.points[mesh.face(f)[k]]);
  };
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Piece& piece = pieces[sets.find(f)];
    const Vector3d a = corner(f, 0);
    const Vector3d cross = (corner(f, 1) - a).cross(corner(f, 2) - a);
    piece.area += cross.norm();
    piece.centre += cross.norm() * (a + corner(f, 1) + corner(f, 2)) / 3;
    piece.normal += cross;
    for (const Index v : mesh.face(f)) {
      if (!normals.empty()) piece.along_normals += cross.dot(as_vector(normals[v]));
    }
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Piece& piece = pieces[sets.find(f)];
    const Vector3d centre = piece.area > 0 ? Vector3d(piece.centre / piece.area) : corner(f, 0);
    piece.volume +=
        (corner(f, 0) - centre).dot((corner(f, 1) - centre).cross(corner(f, 2) - centre));
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (verdict(pieces[sets.find(f)]) >= 0) continue;
    std::swap(mesh.face_vertices[mesh.face_offsets[f] + 1],
              mesh.face_vertices[mesh.face_offsets[f] + 2]);
  }
}

}  // namespace surpass::reconstruction

// The signed volume of a closed piece is the sum over its faces of the tetrahedra that they make
// with one point; it is negative if the faces look inward.
#include <surpass/topology.hpp>

#include "mesh/disjoint_sets.hpp"
#include "mesh/repair_steps.hpp"
#include "mesh/turn_faces.hpp"
#include "mesh/wording.hpp"

namespace surpass::repair_step {
namespace {

double determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Relative to a point of the piece and in units of its box, so that nothing overflows or cancels.
Point local(const Point& p, const Point& origin, double unit) {
  return {(p[0] - origin[0]) / unit, (p[1] - origin[1]) / unit, (p[2] - origin[2]) / unit};
}

double cone_volume(const Mesh& mesh, Index f, const Point& origin, double unit) {
  const auto face = mesh.face(f);
  const auto at = [&](std::size_t i) { return local(mesh.points[face[i]], origin, unit); };
  double volume = 0;
  for (std::size_t i = 2; i < face.size(); ++i) volume += determinant(at(0), at(i - 1), at(i));
  return volume;
}

// Pieces of faces joined along edges.
DisjointSets pieces_of(const Topology& topology) {
  DisjointSets pieces(topology.face_count());
  for (Index h = 0; h < topology.corner_count(); ++h) {
    const Index other = topology.opposite(h);
    if (other != kNone && h < other) pieces.unite(topology.face(h), topology.face(other));
  }
  return pieces;
}

}  // namespace

void turn_outward(Mended& mended) {
  const Mesh& mesh = mended.mesh;
  const auto topology = Topology::build(mesh);
  const double unit = bounding_box(mesh.points).side();
  if (!topology || unit == 0) return;
  DisjointSets pieces = pieces_of(*topology);
  std::vector<unsigned char> open(mesh.face_count(), 0);
  for (Index h = 0; h < topology->corner_count(); ++h) {
    if (topology->opposite(h) == kNone) open[pieces.find(topology->face(h))] = 1;
  }
  std::vector<double> volume(mesh.face_count(), 0.0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index piece = pieces.find(f);  // its smallest face
    const Point& origin = mesh.points[mesh.face(piece)[0]];
    volume[piece] += cone_volume(mesh, f, origin, unit);
  }
  std::vector<unsigned char> turn(mesh.face_count(), 0);
  std::size_t turned_pieces = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index piece = pieces.find(f);
    turn[f] = open[piece] == 0 && volume[piece] < 0 ? 1 : 0;
    if (piece == f) turned_pieces += turn[f];
  }
  if (turned_pieces == 0) return;
  mended.mesh = turn_faces(mesh, turn);
  mended.done.push_back(fmt::format("turned {} outward, of negative volume before",
                                    counted(turned_pieces, "closed piece", "closed pieces")));
}

}  // namespace surpass::repair_step

// Breadth-first over edges with exactly two faces, from the first face of each piece.
#include <algorithm>

#include "mesh/corner_faces.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/repair_steps.hpp"
#include "mesh/turn_faces.hpp"
#include "mesh/wording.hpp"

namespace surpass::repair_step {
namespace {

constexpr unsigned char kUnseen = 2;

class Orienter {
 public:
  explicit Orienter(const Mesh& mesh)
      : mesh_(mesh), edges_(mesh), face_of_(corner_faces(mesh)), turn_(mesh.face_count(), kUnseen) {
    for (Index f = 0; f < mesh.face_count(); ++f) {
      if (turn_[f] == kUnseen) orient_piece(f);
    }
  }
  [[nodiscard]] const std::vector<unsigned char>& turn() const { return turn_; }

 private:
  // Gives every face of the piece a direction relative to its first face, then turns the fewer.
  void orient_piece(Index first) {
    piece_.assign(1, first);
    turn_[first] = 0;
    std::size_t turned = 0;
    std::size_t next = 0;
    while (next < piece_.size()) {  // which grows as faces are visited
      const Index f = piece_[next++];
      turned += turn_[f];
      for (Index h = mesh_.face_offsets[f]; h < mesh_.face_offsets[f + 1]; ++h) visit(f, h);
    }
    if (2 * turned > piece_.size()) {
      for (const Index f : piece_) turn_[f] ^= 1;
    }
  }

  void visit(Index f, Index h) {
    const auto sides = edges_.halfedges(edges_.edge(h));
    if (sides.size() != 2) return;
    const Index other = sides[0] == h ? sides[1] : sides[0];
    const Index g = face_of_[other];
    if (turn_[g] != kUnseen) return;
    const bool disagree = edges_.ascends(h) == edges_.ascends(other);
    turn_[g] = disagree ? turn_[f] ^ 1 : turn_[f];
    piece_.push_back(g);
  }

  const Mesh& mesh_;
  EdgeTable edges_;
  std::vector<Index> face_of_;
  std::vector<unsigned char> turn_;  // 0, 1 or kUnseen
  std::vector<Index> piece_;
};

}  // namespace

void orient_consistently(Mended& mended) {
  const Orienter orienter(mended.mesh);
  const auto& turn = orienter.turn();
  const auto turned = static_cast<std::size_t>(std::count(turn.begin(), turn.end(), 1));
  if (turned == 0) return;
  mended.mesh = turn_faces(mended.mesh, turn);
  mended.done.push_back(
      fmt::format("turned {} to agree with the neighbours", counted(turned, "face", "faces")));
}

}  // namespace surpass::repair_step

// The derivatives of one Doo-Sabin patch: what four faces make around a smooth vertex, a square
// whose corners are the faces' centroids. After `level` refinements it is a square of cells, each
// the patch of a fine vertex; its samples are the cells' corners, centroids of fine faces. A cell
// among quads is biquadratic: first and mixed derivatives are differences at a quad, the second one
// along an axis is constant along it and jumps between patches, so that it is taken within the
// patch. There are no third ones.
//
// Lai and Cheng, Similarity based interpolation using Catmull-Clark subdivision surfaces, 2006,
// have this for Catmull-Clark patches and say that it can be done for others. Where a corner's face
// is no quad, first derivatives are the limit tangents across the face's edges (left eigenvectors
// of the face rule: cosines of one turn), and the cell at that corner has nothing else.
#include <array>
#include <cmath>
#include <numbers>

#include "scheme/doo_sabin.hpp"
#include "scheme/fine_piece.hpp"

namespace surpass::doo_sabin {
namespace {

using Row = Eigen::RowVectorXd;
using Position = std::size_t;

constexpr Index kSides = 4;
constexpr Index kEast = 0;
constexpr Index kNorth = 1;
constexpr Index kWest = 2;
constexpr Index kSouth = 3;

// A fine vertex; its spokes point east, north, west, south, u runs east and v north.
struct Cell {
  std::array<Index, kSides> spokes = {};  // half-edges
  bool regular = false;                   // four quads, all known
};

// A cell's face, seen from the cell: its corner 0, its half-edge along the spoke is `begin`.
struct Quadrant {
  Index cell_spoke = 0;  // the face lies between this spoke and the next
  Index begin = kNone;
};

class PatchBuilder {
 public:
  PatchBuilder(const FinePiece& piece, int level, std::span<const unsigned char> sides,
               std::span<const Index> cut)
      : piece_(piece), fine_(&piece), cells_along_(1), sides_(sides), cut_(cut), level_(level) {}
  Result<PatchKind> build(const SubdivisionScheme& scheme, const Rules& rules);

 private:
  [[nodiscard]] Cell cell_from(Index halfedge, Index direction) const;
  void split_cells();
  void forget_cut_faces();
  void find_regular();
  [[nodiscard]] const Cell& cell(Position i, Position j) const {
    return cells_[j * cells_along_ + i];
  }
  [[nodiscard]] Quadrant quadrant_of(Position i, Position j) const;
  [[nodiscard]] Row point(Index v) const { return fine_->weights.row(v); }
  [[nodiscard]] std::optional<std::array<Row, 2>> first(Position i, Position j) const;
  [[nodiscard]] std::optional<Row> mixed(Position i, Position j) const;
  [[nodiscard]] Row second_in(const Cell& cell, Index ahead, Index aside) const;
  [[nodiscard]] std::optional<Row> second(int axis, Position line, Position along) const;
  [[nodiscard]] double times(int axis, Position i, Position j) const;
  void add_sample(Position i, Position j);
  void add_second(int axis, Position line);
  void add_row(const Row& row, Derivative which, double samples, double part) {
    if (samples == 0 || row.isZero(0)) return;
    kind_.add({row.data(), static_cast<std::size_t>(row.size())}, which, samples, part);
  }

  const FinePiece& piece_;
  const FinePiece* fine_;
  FinePiece kept_;
  std::vector<Cell> cells_;  // row after row from the south-west
  Position cells_along_;
  std::span<const unsigned char> sides_;
  std::span<const Index> cut_;  // faces
  int level_;
  PatchKind kind_;
};

Cell PatchBuilder::cell_from(Index halfedge, Index direction) const {
  Cell cell;
  for (Index k = 0; k < kSides; ++k) {
    cell.spokes[(direction + k) % kSides] = halfedge;
    halfedge = fine_->topology.rotate(halfedge);
  }
  return cell;
}

// The corner point of half-edge h has the number h and so has its half-edge in the face's new face:
// see doo_sabin.hpp.
void PatchBuilder::split_cells() {
  std::vector<Cell> fine(4 * cells_.size());
  const Position along = 2 * cells_along_;
  for (Position j = 0; j < cells_along_; ++j) {
    for (Position i = 0; i < cells_along_; ++i) {
      const auto& spokes = cell(i, j).spokes;
      const auto put = [&](Index spoke, Position right, Position up) {
        fine[(2 * j + up) * along + 2 * i + right] = cell_from(spokes[spoke], spoke);
      };
      put(kEast, 1, 1);
      put(kNorth, 0, 1);
      put(kWest, 0, 0);
      put(kSouth, 1, 0);
    }
  }
  cells_ = std::move(fine);
  cells_along_ = along;
}

// Their corner points, of which everything else there is made.
void PatchBuilder::forget_cut_faces() {
  for (const Index f : cut_) {
    for (Index h = piece_.topology.face_begin(f); h < piece_.topology.face_end(f); ++h) {
      kept_.forget(h);
    }
  }
}

void PatchBuilder::find_regular() {
  for (Cell& cell : cells_) {
    cell.regular = true;
    for (const Index h : cell.spokes) {
      const Index f = fine_->topology.face(h);
      cell.regular = cell.regular && fine_->topology.face_degree(f) == kSides;
    }
  }
}

Quadrant PatchBuilder::quadrant_of(Position i, Position j) const {
  const Index spoke = j > 0 ? (i > 0 ? kEast : kNorth) : (i > 0 ? kSouth : kWest);
  const Cell& beside = cell(i > 0 ? i - 1 : i, j > 0 ? j - 1 : j);
  return {spoke, beside.spokes[spoke]};
}

// Along u and v. From the middle of a face with corners p_0 to p_(m-1), across its edge from p_k:
// twice the way to the edge's middle if the face is regular and plane.
std::optional<std::array<Row, 2>> PatchBuilder::first(Position i, Position j) const {
  const Position n = cells_along_;
  const bool corner = i % n == 0 && j % n == 0;
  Quadrant at = quadrant_of(i, j);
  const FinePiece& mesh = corner ? piece_ : *fine_;
  if (corner) {
    if (std::find(cut_.begin(), cut_.end(), at.cell_spoke) != cut_.end()) return {};
    at.begin = piece_.topology.face_begin(at.cell_spoke);
  }
  const Index f = mesh.topology.face(at.begin);
  const Index m = mesh.topology.face_degree(f);
  const double turn = 2 * std::numbers::pi / m;
  const auto across = [&](double edge) {
    Row sum = Row::Zero(mesh.weights.cols());
    Index h = at.begin;
    for (Index k = 0; k < m; ++k, h = mesh.topology.next(h)) {
      sum += std::cos(turn * (k - edge - 0.5)) * mesh.weights.row(mesh.topology.tail(h));
    }
    return Row(sum * (4 * std::cos(turn / 2) / m * (corner ? 1.0 : static_cast<double>(n))));
  };
  // Across the cell's spoke to the quadrant before it, and across the next one.
  const Row before = across(0);
  const Row after = across(m - 1);
  if (before.hasNaN()) return {};
  using Pair = std::array<Row, 2>;
  switch (at.cell_spoke) {
    case kEast: return Pair{-after, -before};
    case kNorth: return Pair{before, -after};
    case kWest: return Pair{after, before};
    default: return Pair{-before, after};
  }
}

std::optional<Row> PatchBuilder::mixed(Position i, Position j) const {
  const Quadrant at = quadrant_of(i, j);
  const Topology& topology = fine_->topology;
  if (topology.face_degree(topology.face(at.begin)) != kSides) return {};
  Row sum = Row::Zero(fine_->weights.cols());
  double sign = at.cell_spoke == kEast || at.cell_spoke == kWest ? 1 : -1;
  Index h = at.begin;
  for (Index k = 0; k < kSides; ++k, h = topology.next(h), sign = -sign) {
    sum += sign * point(topology.tail(h));
  }
  if (sum.hasNaN()) return {};
  return Row(sum * static_cast<double>(cells_along_ * cells_along_));
}

// Along the spoke `ahead`, on the side that lies at the spoke `aside`: half of the difference on
// the line through the vertex, and half of that on the line beside.
Row PatchBuilder::second_in(const Cell& cell, Index ahead, Index aside) const {
  const Topology& topology = fine_->topology;
  const auto head = [&](Index spoke) { return point(topology.head(cell.spokes[spoke])); };
  const auto diagonal = [&](Index spoke) {
    return point(topology.head(topology.next(cell.spokes[spoke])));
  };
  const Index back = (ahead + 2) % kSides;
  // The face between `ahead` and `aside` belongs to the spoke that the other follows.
  const bool left = aside == (ahead + 1) % kSides;
  const Row line = head(ahead) - 2 * point(topology.tail(cell.spokes[ahead])) + head(back);
  const Row beside =
      diagonal(left ? ahead : aside) - 2 * head(aside) + diagonal(left ? aside : back);
  return (line + beside) / 2 * static_cast<double>(cells_along_ * cells_along_);
}

// On the line (0 to n) of an axis, within the cell `along` it; either side of the line knows it.
std::optional<Row> PatchBuilder::second(int axis, Position line, Position along) const {
  const auto at = [&](Position l) -> const Cell& {
    return axis == 0 ? cell(along, l) : cell(l, along);
  };
  const Index ahead = axis == 0 ? kEast : kNorth;
  if (line < cells_along_ && at(line).regular) {
    Row row = second_in(at(line), ahead, axis == 0 ? kSouth : kWest);
    if (!row.hasNaN()) return row;
  }
  if (line > 0 && at(line - 1).regular) {
    Row row = second_in(at(line - 1), ahead, axis == 0 ? kNorth : kEast);
    if (!row.hasNaN()) return row;
  }
  return {};
}

// How many times a derivative along an axis counts. Where two sides meet it is one along either of
// them.
double PatchBuilder::times(int axis, Position i, Position j) const {
  const Position n = cells_along_;
  if (j % n == 0 && (axis == 0 || i % n != 0)) return sides_[j == 0 ? kSouth : kNorth];
  if (i % n == 0) return sides_[i == 0 ? kWest : kEast];
  return 1;
}

void PatchBuilder::add_sample(Position i, Position j) {
  const Position n = cells_along_;
  const bool end_i = i % n == 0;
  const bool end_j = j % n == 0;
  // Of the four cells around a sample, those inside the patch.
  const double part =
      (end_i ? 1.0 : 2.0) * (end_j ? 1.0 : 2.0) / (4.0 * static_cast<double>(n * n));
  if (const auto tangents = first(i, j)) {
    for (const int axis : {0, 1}) {
      const double count = times(axis, i, j);
      add_row((*tangents)[static_cast<std::size_t>(axis)], Derivative::first, count, count * part);
    }
  }
  if (const auto found = mixed(i, j)) {
    const double count = end_i && end_j ? 1 : times(0, i, j);
    add_row(*found, Derivative::mixed, count, count * part);
  }
}

// A sample between two cells is half of either, as far as they are known.
void PatchBuilder::add_second(int axis, Position line) {
  const Position n = cells_along_;
  std::vector<std::optional<Row>> of_cell;
  for (Position k = 0; k < n; ++k) of_cell.push_back(second(axis, line, k));
  std::vector<double> count(n, 0.0);
  for (Position sample = 0; sample <= n; ++sample) {
    const bool before = sample > 0 && of_cell[sample - 1];
    const bool after = sample < n && of_cell[sample];
    const double share = before && after ? 0.5 : 1;
    if (before) count[sample - 1] += share;
    if (after) count[sample] += share;
  }
  const double times_line = axis == 0 ? times(0, 1, line) : times(1, line, 1);
  const double part = times_line * (line % n == 0 ? 1.0 : 2.0) / (2.0 * static_cast<double>(n * n));
  for (Position k = 0; k < n;) {
    // In the middle of a regular patch they are all the same.
    double counts = 0;
    Position same = k;
    for (; same < n && (same == k || (of_cell[k] && of_cell[same] &&
                                      of_cell[same]->isApprox(*of_cell[k], 1e-12)));
         ++same) {
      counts += count[same];
    }
    if (of_cell[k]) {
      add_row(*of_cell[k], Derivative::second, times_line * counts,
              static_cast<double>(same - k) * part);
    }
    k = same;
  }
}

Result<PatchKind> PatchBuilder::build(const SubdivisionScheme& scheme, const Rules& rules) {
  // The piece's faces follow each other around the vertex, and begin at it.
  cells_ = {{}};
  for (Index k = 0; k < kSides; ++k) cells_[0].spokes[k] = piece_.topology.face_begin(k);
  for (int level = 0; level < level_; ++level) {
    auto next = fine_->refined(scheme, rules, 1);
    if (!next) return tl::make_unexpected(next.error());
    kept_ = std::move(*next);
    fine_ = &kept_;
    if (level == 0) forget_cut_faces();
    split_cells();
  }
  find_regular();
  kind_.columns = static_cast<std::size_t>(fine_->weights.cols());
  for (Position j = 0; j <= cells_along_; ++j) {
    for (Position i = 0; i <= cells_along_; ++i) add_sample(i, j);
  }
  for (const int axis : {0, 1}) {
    for (Position line = 0; line <= cells_along_; ++line) add_second(axis, line);
  }
  return std::move(kind_);
}

}  // namespace

Result<PatchKind> DooSabin::patch_kind(const Mesh& piece, const Rules& rules, int level,
                                       std::span<const unsigned char> sides,
                                       std::span<const Index> cut) const {
  const auto given = FinePiece::as_given(piece, rules);
  if (!given) return tl::make_unexpected(given.error());
  return PatchBuilder(*given, level, sides, cut).build(*this, rules);
}

}  // namespace surpass::doo_sabin

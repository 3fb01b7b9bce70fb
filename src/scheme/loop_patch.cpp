// The derivatives of one Loop patch, a triangle, along the three directions of its sides. After
// `level` refinements its samples are vertices; at regular ones the quartic box spline has its
// derivatives in closed form (loop_jets.cpp): the second one along a side is the plain second
// difference, and linear between vertices, so that the third one is a difference of these. Along a
// sharp curve beside three faces the surface is a box spline, too, with points mirrored such that
// each quad across the curve is a parallelogram.
//
// Lai and Cheng, Similarity based interpolation using Catmull-Clark subdivision surfaces, 2006,
// have this for Catmull-Clark patches and say that it can be done for others. As there,
// extraordinary corners have first derivatives only, the limit tangents along their spokes.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scheme/fine_piece.hpp"
#include "scheme/loop.hpp"
#include "scheme/loop_masks.hpp"

namespace surpass::loop {
namespace {

using Row = Eigen::RowVectorXd;

constexpr std::size_t kDirections = 6;
constexpr std::size_t kAxes = 3;
// Directions of a lattice of triangles, counterclockwise; side 0 runs along the first.
constexpr std::array<std::array<int, 2>, kDirections> kSteps = {
    {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
// Of the three sides.
constexpr std::array<std::size_t, kAxes> kAlong = {0, 2, 1};

struct Corner2 {
  int i;
  int j;
};

// What is known at a sample along an axis.
struct Along {
  std::optional<Row> first;
  std::optional<Row> second;
};

struct Sample {
  Index vertex = kNone;
  std::vector<Index> halfedges;  // in the patch, leaving the vertex
  std::array<Along, kAxes> along;
  std::optional<std::array<Row, kAxes>> regular;  // second derivatives, where all are known
};

class Builder {
 public:
  Builder(const FinePiece& piece, const FinePiece& fine, Boundary boundary, int level,
          std::span<const unsigned char> sides)
      : piece_(piece), fine_(fine), boundary_(boundary), side_(1 << level), sides_(sides) {
    samples_.resize(number_of(side_, side_) + 1);
    place({{{0, 0}, {side_, 0}, {0, side_}}}, 0, level);
  }
  PatchKind build();

 private:
  void place(std::array<Corner2, 3> corners, Index face, int level);
  [[nodiscard]] std::size_t number_of(int i, int j) const {
    const int number = j * (side_ + 1) + i;
    return static_cast<std::size_t>(number);
  }
  [[nodiscard]] Sample& at(int i, int j) { return samples_[number_of(i, j)]; }
  [[nodiscard]] bool has(int i, int j) const { return i >= 0 && j >= 0 && i + j <= side_; }
  [[nodiscard]] std::size_t direction_of(int i, int j, Index halfedge) const;
  void derive(int i, int j, Sample& sample);
  void derive_regular(const LoopRing& ring, std::size_t begin, std::size_t direction,
                      Sample& sample) const;
  void derive_along(const LoopRing& ring, std::size_t spoke, Along& along) const;
  void derive_tangent(int i, int j, Sample& sample) const;
  [[nodiscard]] double times(int i, int j, std::size_t axis) const;
  void add_sample(int i, int j, const Sample& sample);
  void add_third(std::size_t axis);
  void add_row(const Row& row, Derivative which, double samples, double part) {
    if (samples == 0 || row.isZero(0)) return;
    kind_.add({row.data(), static_cast<std::size_t>(row.size())}, which, samples, part);
  }

  const FinePiece& piece_;
  const FinePiece& fine_;
  Boundary boundary_;
  int side_;
  std::span<const unsigned char> sides_;
  std::vector<Sample> samples_;
  PatchKind kind_;
};

// The four triangles of a refined one follow each other; see loop_refine.cpp.
void Builder::place(std::array<Corner2, 3> corners, Index face, int level) {
  if (level == 0) {
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * face + k;
      Sample& sample = at(corners[k].i, corners[k].j);
      sample.vertex = fine_.topology.tail(h);
      sample.halfedges.push_back(h);
    }
    return;
  }
  std::array<Corner2, 3> middle{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner2& a = corners[k];
    const Corner2& b = corners[(k + 1) % 3];
    middle[k] = {(a.i + b.i) / 2, (a.j + b.j) / 2};
  }
  place({{corners[0], middle[0], middle[2]}}, 4 * face, level - 1);
  place({{middle[0], corners[1], middle[1]}}, 4 * face + 1, level - 1);
  place({{middle[2], middle[1], corners[2]}}, 4 * face + 2, level - 1);
  place({{middle[0], middle[1], middle[2]}}, 4 * face + 3, level - 1);
}

std::size_t Builder::direction_of(int i, int j, Index halfedge) const {
  const Index head = fine_.topology.head(halfedge);
  std::size_t d = 0;
  while (!has(i + kSteps[d][0], j + kSteps[d][1]) ||
         samples_[number_of(i + kSteps[d][0], j + kSteps[d][1])].vertex != head) {
    ++d;
  }
  return d;
}

Mask unit(const LoopRing& ring, std::size_t point) {
  Mask mask(ring.point_count(), 0.0);
  mask[point] = 1;
  return mask;
}

void add(double factor, const Mask& mask, Mask& sum) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += factor * mask[k];
}

// The six neighbours of a regular place, from the first of a sector's spokes on; where the sector
// has three faces, two of them are mirrored.
std::array<Mask, kDirections> neighbours(const LoopRing& ring, std::size_t begin) {
  std::array<Mask, kDirections> p;
  const std::size_t n = ring.size();
  const std::size_t real = ring.rule() == VertexRule::smooth ? kDirections : 4;
  for (std::size_t k = 0; k < real; ++k) p[k] = unit(ring, 1 + (begin + k) % n);
  if (real == kDirections) return p;
  p[4] = unit(ring, 0);
  add(1, p[3], p[4]);
  add(-1, p[2], p[4]);
  p[5] = unit(ring, 0);
  add(1, p[0], p[5]);
  add(-1, p[1], p[5]);
  return p;
}

std::vector<Index> columns_of(const LoopRing& ring) {
  std::vector<Index> columns = {ring.center};
  columns.insert(columns.end(), ring.spokes.begin(), ring.spokes.end());
  return columns;
}

// `direction`: of the spoke `begin`.
void Builder::derive_regular(const LoopRing& ring, std::size_t begin, std::size_t direction,
                             Sample& sample) const {
  const auto p = neighbours(ring, begin);
  const auto columns = columns_of(ring);
  const double scale = side_;
  std::array<Row, kAxes> second;
  bool all_known = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::size_t d = kAlong[axis] + kDirections - direction;
    const auto q = [&](std::size_t k) -> const Mask& { return p[(d + k) % kDirections]; };
    Mask one(ring.point_count(), 0.0);
    add(2.0 / 6, q(0), one);
    add(-2.0 / 6, q(3), one);
    add(1.0 / 6, q(1), one);
    add(-1.0 / 6, q(4), one);
    add(1.0 / 6, q(5), one);
    add(-1.0 / 6, q(2), one);
    Mask two(ring.point_count(), 0.0);
    two[0] = -2;
    add(1, q(0), two);
    add(1, q(3), two);
    auto& along = sample.along[axis];
    along = {fine_.known_over_piece(columns, one), fine_.known_over_piece(columns, two)};
    if (along.first) *along.first *= scale;
    if (along.second) second[axis] = *along.second *= scale * scale;
    all_known = all_known && along.second;
  }
  if (all_known) sample.regular = std::move(second);
}

// Along a sharp spoke, whose curve is a cubic B-spline; at corners it ends.
void Builder::derive_along(const LoopRing& ring, std::size_t spoke, Along& along) const {
  if (!is_infinite(ring.spoke_sharpness[spoke])) return;
  const auto columns = columns_of(ring);
  const double scale = side_;
  Mask one(ring.point_count(), 0.0);
  if (ring.rule() == VertexRule::crease) {
    const auto sharp = ring.sharp_spokes();
    add(0.5, unit(ring, 1 + sharp[0]), one);
    add(-0.5, unit(ring, 1 + sharp[1]), one);
    Mask two(ring.point_count(), 0.0);
    two[0] = -2;
    two[1 + sharp[0]] = two[1 + sharp[1]] = 1;
    along.second = fine_.known_over_piece(columns, two);
    if (along.second) *along.second *= scale * scale;
  } else {
    one[0] = -1;
    one[1 + spoke] = 1;
  }
  along.first = fine_.known_over_piece(columns, one);
  if (along.first) *along.first *= scale;
}

// At an extraordinary corner of the patch, the tangents along its two sides.
void Builder::derive_tangent(int i, int j, Sample& sample) const {
  const Index corner = i > 0 ? 1 : j > 0 ? 2 : 0;
  const LoopRing ring = LoopRing::around(piece_.topology, piece_.sharpness, boundary_,
                                         piece_.mesh.face_vertices[corner]);
  const auto n = static_cast<double>(ring.size());
  const auto columns = columns_of(ring);
  for (const Index side : {corner, (corner + 2) % 3}) {
    const Index other = piece_.mesh.face_vertices[side == corner ? (corner + 1) % 3 : side];
    const auto spoke = static_cast<std::size_t>(
        std::find(ring.spokes.begin(), ring.spokes.end(), other) - ring.spokes.begin());
    Mask mask(ring.point_count(), 0.0);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      mask[1 + (spoke + k) % ring.size()] =
          2 / n * std::cos(2 * std::numbers::pi * static_cast<double>(k) / n);
    }
    sample.along[side].first = piece_.over_piece(columns, mask);
  }
}

void Builder::derive(int i, int j, Sample& sample) {
  if (piece_.is_cut(sample.vertex)) return;
  const LoopRing ring = LoopRing::around(fine_.topology, fine_.sharpness, boundary_, sample.vertex);
  if (ring.is_semi_sharp() || ring.rule() == VertexRule::dart) return;
  const auto spoke_of = [&](Index h) {
    return static_cast<std::size_t>(
        std::find(ring.spokes.begin(), ring.spokes.end(), fine_.topology.head(h)) -
        ring.spokes.begin());
  };
  if (ring.rule() == VertexRule::smooth) {
    const Index h = sample.halfedges.front();
    if (ring.size() == kDirections) {
      derive_regular(ring, spoke_of(h), direction_of(i, j, h), sample);
    } else if (ring.size() > 2 && (i + j == side_ ? i == 0 || j == 0 : i + j == 0)) {
      derive_tangent(i, j, sample);
    }
    return;
  }
  // Under these rules curves are no B-splines beside irregular vertices; so much is left out.
  if (boundary_ == Boundary::hoppe) return;
  for (const Index h : sample.halfedges) {
    const std::size_t spoke = spoke_of(h);
    const std::size_t direction = direction_of(i, j, h);
    if (ring.rule() == VertexRule::crease) {
      for (const Sector& sector : sectors(ring)) {
        const std::size_t inside = (spoke + ring.size() - sector.begin) % ring.size();
        if (sector.faces != 3 || inside >= sector.faces) continue;
        derive_regular(ring, sector.begin, (direction + kDirections - inside) % kDirections,
                       sample);
        return;
      }
    }
    // The sides of the face, of which the second is the next spoke.
    for (const std::size_t k : {0U, 1U}) {
      const std::size_t d = (direction + k) % kAxes;
      const auto axis =
          static_cast<std::size_t>(std::find(kAlong.begin(), kAlong.end(), d) - kAlong.begin());
      derive_along(ring, (spoke + k) % ring.size(), sample.along[axis]);
    }
  }
}

// How many times a derivative counts; at a corner of the patch, two of three lie along sides.
double Builder::times(int i, int j, std::size_t axis) const {
  const std::array<bool, 3> on = {j == 0, i + j == side_, i == 0};
  const auto count = static_cast<int>(on[0]) + static_cast<int>(on[1]) + static_cast<int>(on[2]);
  if (count == 2) return axis < kAxes && on[axis] ? sides_[axis] : 1;
  for (std::size_t side = 0; side < on.size(); ++side) {
    if (on[side]) return sides_[side];
  }
  return 1;
}

// With the second derivatives a, b, c along the three directions and their mean m, |Suu|^2 + 2
// |Suv|^2 + |Svv|^2 = 2 |m|^2 + 4/3 (|a - m|^2 + |b - m|^2 + |c - m|^2) in any parameters with
// right angles; and |Su|^2 + |Sv|^2 is 2/3 of the sum of the first ones' squares. The area of mixed
// rows counts twice in the thin plate.
void Builder::add_sample(int i, int j, const Sample& sample) {
  const int ends =
      static_cast<int>(i == 0) + static_cast<int>(j == 0) + static_cast<int>(i + j == side_);
  const double triangles = ends == 0 ? 6 : ends == 1 ? 3 : 1;
  const double part = triangles / (3.0 * side_ * side_);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Along& along = sample.along[axis];
    const double count = times(i, j, axis);
    if (along.first) add_row(*along.first, Derivative::first, count, count * part * 2 / 3);
    if (along.second) add_row(*along.second, Derivative::second, count, 0);
  }
  if (!sample.regular) return;
  const double count = ends == 2 ? 1 : times(i, j, kAxes);
  const auto& second = *sample.regular;
  const Row mean = (second[0] + second[1] + second[2]) / 3;
  add_row(mean, Derivative::mixed, count, count * part);
  for (const Row& row : second) {
    add_row(row - mean, Derivative::mixed, count, count * part * 2 / 3);
  }
}

// Along the lines of an axis; as on Catmull-Clark patches, the samples that are known are shared by
// the segments between them.
void Builder::add_third(std::size_t axis) {
  const auto [di, dj] = kSteps[kAlong[axis]];
  for (int line = 0; line < side_; ++line) {
    // The line nearest to the side first; it ends where the lattice does.
    int i = axis == 0 ? 0 : axis == 1 ? side_ - line : line;
    int j = axis == 0 ? line : 0;
    const double count_line = line == 0 ? sides_[axis] : 1;
    std::size_t known = 0;
    std::vector<Row> segments;
    for (const Along* before = nullptr; has(i, j); i += di, j += dj) {
      const Along& here = at(i, j).along[axis];
      known += here.second ? 1U : 0U;
      if (before != nullptr && before->second && here.second) {
        segments.emplace_back(side_ * (*here.second - *before->second));
      }
      before = &here;
    }
    for (const Row& row : segments) {
      add_row(row, Derivative::third,
              count_line * static_cast<double>(known) / static_cast<double>(segments.size()), 0);
    }
  }
}

PatchKind Builder::build() {
  kind_.columns = static_cast<std::size_t>(fine_.weights.cols());
  const auto for_all = [&](auto&& use) {
    for (int j = 0; j <= side_; ++j) {
      for (int i = 0; i + j <= side_; ++i) use(i, j, at(i, j));
    }
  };
  for_all([&](int i, int j, Sample& sample) { derive(i, j, sample); });
  for_all([&](int i, int j, const Sample& sample) { add_sample(i, j, sample); });
  for (std::size_t axis = 0; axis < kAxes; ++axis) add_third(axis);
  return std::move(kind_);
}

}  // namespace

Result<PatchKind> Loop::patch_kind(const Mesh& piece, const Rules& rules, int level,
                                   std::span<const unsigned char> sides,
                                   std::span<const Index> cut) const {
  const auto given = FinePiece::as_given(piece, rules, cut);
  if (!given) return tl::make_unexpected(given.error());
  const auto fine = given->refined(*this, rules, level);
  if (!fine) return tl::make_unexpected(fine.error());
  return Builder(*given, *fine, rules.boundary, level, sides).build();
}

}  // namespace surpass::loop

// The derivatives of one Catmull-Clark patch. After `level` refinements its samples are vertices,
// and all but its own corners are regular: there they have a closed form.
//
// Lai and Cheng, Similarity based interpolation using Catmull-Clark subdivision surfaces, 2006,
// sample nine points of a patch. They do not say what they do where a patch has an extraordinary
// corner; here first derivatives become the limit tangents, and higher ones are left out.
#include <array>

#include <Eigen/Core>

#include "scheme/catmull_clark.hpp"
#include "scheme/catmull_clark_derivatives.hpp"
#include "scheme/fine_piece.hpp"

namespace surpass::catmull_clark {
namespace {

using Row = Eigen::RowVectorXd;

FaceRing ring_of(const FinePiece& piece, Index v) {
  return FaceRing::around(piece.topology, piece.sharpness, v);
}

// The samples of a patch: a square of fine vertices, row after row, from corner 0 along side 0.
class Samples {
 public:
  Samples(const Topology& topology, int level);
  [[nodiscard]] std::size_t side() const { return side_; }  ///< cells along it
  [[nodiscard]] Index at(std::size_t i, std::size_t j) const {
    return vertices_[j * (side_ + 1) + i];
  }

 private:
  std::size_t side_;
  std::vector<Index> vertices_;
};

// The refined face that keeps corner 0 is number 0, and its half-edge 0 runs along side 0.
Samples::Samples(const Topology& topology, int level)
    : side_(std::size_t{1} << level), vertices_((side_ + 1) * (side_ + 1)) {
  Index row = 0;
  for (std::size_t j = 0; j < side_; ++j) {
    Index h = row;
    for (std::size_t i = 0; i < side_; ++i) {
      const std::array<Index, 4> cell = {h, topology.next(h), topology.next(topology.next(h)),
                                         topology.previous(h)};
      vertices_[j * (side_ + 1) + i] = topology.tail(cell[0]);
      vertices_[j * (side_ + 1) + i + 1] = topology.tail(cell[1]);
      vertices_[(j + 1) * (side_ + 1) + i + 1] = topology.tail(cell[2]);
      vertices_[(j + 1) * (side_ + 1) + i] = topology.tail(cell[3]);
      if (i + 1 < side_) h = topology.next(topology.opposite(cell[1]));
    }
    if (j + 1 < side_) row = topology.opposite(topology.next(topology.next(row)));
  }
}

class Builder {
 public:
  Builder(const FinePiece& piece, const FinePiece& fine, int level,
          std::span<const unsigned char> sides)
      : piece_(piece),
        fine_(fine),
        sides_(sides),
        samples_(fine.topology, level),
        scale_(std::ldexp(1.0, level)) {}
  PatchKind build();

 private:
  // What is known at a sample along one of the two axes.
  struct Along {
    std::optional<Row> first;
    std::optional<Row> second;
  };

  void add_sample(std::size_t i, std::size_t j);
  [[nodiscard]] Along along(const FaceRing& ring, Index neighbour) const;
  [[nodiscard]] std::optional<Row> tangent(std::size_t i, std::size_t j, int axis) const;
  void add_third(int axis, std::size_t line);
  [[nodiscard]] double times(int axis, std::size_t i, std::size_t j) const;
  void add_row(const Row& row, Derivative which, double samples, double part) {
    if (samples == 0 || row.isZero(0)) return;
    kind_.add({row.data(), static_cast<std::size_t>(row.size())}, which, samples, part);
  }
  [[nodiscard]] std::optional<Row>& second(int axis, std::size_t line, std::size_t along) {
    const std::size_t n = samples_.side() + 1;
    const std::size_t at = axis == 0 ? line * n + along : along * n + line;
    return second_[static_cast<std::size_t>(axis)][at];
  }

  const FinePiece& piece_;
  const FinePiece& fine_;
  std::span<const unsigned char> sides_;
  Samples samples_;
  double scale_;
  std::array<std::vector<std::optional<Row>>, 2> second_;  // for each axis, of every sample
  PatchKind kind_;
};

Builder::Along Builder::along(const FaceRing& ring, Index neighbour) const {
  const auto spoke = static_cast<std::size_t>(
      std::find(ring.spokes.begin(), ring.spokes.end(), neighbour) - ring.spokes.begin());
  const SpokeDerivatives found = spoke_derivatives(ring, spoke);
  Along along;
  if (found.first) along.first = fine_.known_over_piece(ring.columns, *found.first);
  if (found.second) along.second = fine_.known_over_piece(ring.columns, *found.second);
  if (along.first) *along.first *= scale_;
  if (along.second) *along.second *= scale_ * scale_;
  return along;
}

// At an extraordinary corner of the patch.
std::optional<Row> Builder::tangent(std::size_t i, std::size_t j, int axis) const {
  const std::size_t n = samples_.side();
  if (i % n != 0 || j % n != 0) return {};
  const Index corner = j == 0 ? (i == 0 ? 0 : 1) : (i == 0 ? 3 : 2);
  const Index other = axis == 0 ? corner ^ 1 : 3 - corner;
  if (piece_.is_cut(piece_.mesh.face_vertices[corner])) return {};
  const FaceRing ring = ring_of(piece_, piece_.mesh.face_vertices[corner]);
  const auto spoke = static_cast<std::size_t>(
      std::find(ring.spokes.begin(), ring.spokes.end(), piece_.mesh.face_vertices[other]) -
      ring.spokes.begin());
  const auto mask = tangent_along(ring, spoke);
  if (!mask) return {};
  return piece_.over_piece(ring.columns, *mask);
}

// How many times a derivative counts. Where two sides meet it is one along either of them.
double Builder::times(int axis, std::size_t i, std::size_t j) const {
  const std::size_t n = samples_.side();
  const bool along_u = axis == 0;
  if (j % n == 0 && (along_u || i % n != 0)) return sides_[j == 0 ? 0 : 2];
  if (i % n == 0) return sides_[i == 0 ? 3 : 1];
  return 1;
}

void Builder::add_sample(std::size_t i, std::size_t j) {
  const std::size_t n = samples_.side();
  const bool end_i = i % n == 0;
  const bool end_j = j % n == 0;
  // Of the four cells around a sample, those inside the patch.
  const double part =
      (end_i ? 1.0 : 2.0) * (end_j ? 1.0 : 2.0) / (4.0 * static_cast<double>(n * n));
  const FaceRing ring = ring_of(fine_, samples_.at(i, j));
  const Index beside = samples_.at(i < n ? i + 1 : i - 1, j);
  const Index above = samples_.at(i, j < n ? j + 1 : j - 1);
  for (const int axis : {0, 1}) {
    Along found = along(ring, axis == 0 ? beside : above);
    if (!found.first) found.first = tangent(i, j, axis);
    const double count = times(axis, i, j);
    if (found.first) add_row(*found.first, Derivative::first, count, count * part);
    if (found.second) add_row(*found.second, Derivative::second, count, count * part);
    second_[static_cast<std::size_t>(axis)].push_back(std::move(found.second));
  }
  // The cell between the two spokes.
  for (std::size_t f = 0; f < ring.faces.size(); ++f) {
    const Index a = ring.spokes[f];
    const Index b = ring.spokes[(f + 1) % ring.size()];
    if (!((a == beside && b == above) || (a == above && b == beside))) continue;
    const auto mixed = mixed_derivative(ring, f);
    const double count = end_i && end_j ? 1 : times(0, i, j);
    if (!mixed) break;
    const auto row = fine_.known_over_piece(ring.columns, *mixed);
    if (row) add_row(scale_ * scale_ * *row, Derivative::mixed, count, count * part);
    break;
  }
}

// Third derivatives are constant between neighbouring samples of a line, differences of the second
// ones. Where those are not known at an end, the samples that remain are shared by the segments
// that remain.
void Builder::add_third(int axis, std::size_t line) {
  const std::size_t n = samples_.side();
  std::size_t known = 0;
  for (std::size_t k = 0; k <= n; ++k) known += second(axis, line, k) ? 1U : 0U;
  std::vector<Row> segments;
  for (std::size_t k = 0; k < n; ++k) {
    const auto& a = second(axis, line, k);
    const auto& b = second(axis, line, k + 1);
    if (a && b) segments.emplace_back(scale_ * (*b - *a));
  }
  if (segments.empty()) return;
  const double times_line = axis == 0 ? times(0, 1, line) : times(1, line, 1);
  const double share =
      times_line * static_cast<double>(known) / static_cast<double>(segments.size());
  const double part = times_line * (line % n == 0 ? 1.0 : 2.0) / (2.0 * static_cast<double>(n * n));
  for (std::size_t k = 0; k < segments.size();) {
    // In the middle of a regular patch they are all the same.
    std::size_t same = k + 1;
    while (same < segments.size() && segments[same].isApprox(segments[k], 1e-12)) ++same;
    const auto count = static_cast<double>(same - k);
    add_row(segments[k], Derivative::third, count * share, count * part);
    k = same;
  }
}

PatchKind Builder::build() {
  kind_.columns = static_cast<std::size_t>(fine_.weights.cols());
  for (std::size_t j = 0; j <= samples_.side(); ++j) {
    for (std::size_t i = 0; i <= samples_.side(); ++i) add_sample(i, j);
  }
  for (const int axis : {0, 1}) {
    for (std::size_t line = 0; line <= samples_.side(); ++line) add_third(axis, line);
  }
  return std::move(kind_);
}

}  // namespace

Result<PatchKind> CatmullClark::patch_kind(const Mesh& piece, const Rules& rules, int level,
                                           std::span<const unsigned char> sides,
                                           std::span<const Index> cut) const {
  const auto given = FinePiece::as_given(piece, rules, cut);
  if (!given) return tl::make_unexpected(given.error());
  const auto fine = given->refined(*this, rules, level);
  if (!fine) return tl::make_unexpected(fine.error());
  return Builder(*given, *fine, level, sides).build();
}

}  // namespace surpass::catmull_clark

// Bounds of the distance between surfaces, by splitting one of them until the bounds meet. The idea
// of bounding by convexity on subdivided triangles: M. Tang, M. Lee, Y. J. Kim, Interactive
// Hausdorff distance computation for general polygonal models, ACM Transactions on Graphics 28
// (2009).
#include <surpass/quality.hpp>
#include <surpass/repair.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mesh/refusals.hpp"
#include "parallel/parallel.hpp"
#include "quality/surface_piece.hpp"

namespace surpass {
namespace {

using Eigen::Vector3d;
using Pieces = std::vector<SurfacePiece>;

constexpr double kMeanResolution = 1.0 / 64;  // longest edge of a piece, of the box side
constexpr double kRounding = 1e-13;           // no accuracy below this, of the common box
constexpr std::size_t kMostPieces = 1U << 22;
constexpr std::size_t kPiecesAChunk = 128;

Result<void> check(const Mesh& mesh, const char* which) {
  if (mesh.face_count() == 0) {
    return fail(ErrorCode::empty_mesh,
                fmt::format("the {} mesh has no faces, so there is no surface to compare", which));
  }
  return refusal::check_measurable(mesh);
}

// Both surfaces are moved into a common box of side 1, where nothing overflows.
struct Frame {
  Point origin = {};
  double unit = 1;
  [[nodiscard]] Vector3d in(const Point& p) const {
    return {(p[0] - origin[0]) / unit, (p[1] - origin[1]) / unit, (p[2] - origin[2]) / unit};
  }
  [[nodiscard]] Point out(const Vector3d& p) const {
    return {origin[0] + p[0] * unit, origin[1] + p[1] * unit, origin[2] + p[2] * unit};
  }
};

Frame common_frame(const Mesh& a, const Mesh& b) {
  const Box first = bounding_box(a.points);
  const Box second = bounding_box(b.points);
  const Box both = bounding_box(std::array{first.low, first.high, second.low, second.high});
  return {both.low, both.side() > 0 ? both.side() : 1};
}

struct Surface {
  std::vector<Vector3d> points;
  std::vector<std::array<Index, 3>> triangles;
};

Surface surface_of(const Mesh& mesh, const Frame& frame) {
  const Mesh cut = triangulate(mesh).mesh;
  Surface surface;
  for (const Point& p : cut.points) surface.points.push_back(frame.in(p));
  for (Index f = 0; f < cut.face_count(); ++f) {
    const auto face = cut.face(f);
    surface.triangles.push_back({face[0], face[1], face[2]});
  }
  return surface;
}

TriangleTree tree_of(const Surface& surface) {
  std::vector<SolidTriangle> triangles;
  for (const auto& [a, b, c] : surface.triangles) {
    triangles.emplace_back(surface.points[a], surface.points[b], surface.points[c]);
  }
  return TriangleTree(std::move(triangles));
}

// One direction: level by level, pieces are split until their bounds are close to the largest
// distance found so far and they are small enough for the mean.
class OneSidedSearch {
 public:
  OneSidedSearch(const Surface& from, const TriangleTree& to, double accuracy, double resolution,
                 const Context& context)
      : from_(from), to_(to), accuracy_(accuracy), resolution_(resolution), context_(context) {}

  Result<OneSided> run(const Frame& frame) {
    Pieces active = first_pieces();
    std::size_t made = active.size();
    const std::size_t most = kMostPieces + 8 * made;
    for (unsigned level = 0; !active.empty(); ++level) {
      if (context_.cancelled()) return fail(ErrorCode::cancelled, "the comparison was interrupted");
      for (const SurfacePiece& piece : active) note_farthest(piece.farthest());
      const bool last = made > most;
      Pieces open;
      for (const SurfacePiece& piece : active) {
        if (!last && !is_done(piece)) {
          open.push_back(piece);
        } else {
          finish(piece);
        }
      }
      active = split(open, level);
      made += active.size();
    }
    const double weight = area_ > 0 ? area_ : 1;
    return OneSided{largest_ * frame.unit, std::max(bound_, largest_) * frame.unit,
                    sum_ / weight * frame.unit, std::sqrt(sum_of_squares_ / weight) * frame.unit,
                    frame.out(at_)};
  }

 private:
  // Every part of the list, made by `make(i, parts)` for i in [0, n), in the order of i.
  template <class Make>
  Pieces gather(std::size_t n, Make&& make) const {
    std::vector<Pieces> chunks((n + kPiecesAChunk - 1) / kPiecesAChunk);
    parallel::for_ranges(
        context_, n,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) make(i, chunks[begin / kPiecesAChunk]);
        },
        kPiecesAChunk);
    Pieces all;
    for (Pieces& chunk : chunks) {
      all.insert(all.end(), chunk.begin(), chunk.end());
      Pieces().swap(chunk);
    }
    return all;
  }

  Pieces first_pieces() const {
    std::vector<Sample> samples(from_.points.size());
    parallel::for_ranges(
        context_, samples.size(),
        [&](std::size_t begin, std::size_t end) {
          Index guess = 0;
          for (std::size_t v = begin; v < end; ++v) {
            samples[v] = to_.nearest(from_.points[v], guess);
            guess = samples[v].triangle;
          }
        },
        kPiecesAChunk);
    return gather(from_.triangles.size(), [&](std::size_t f, Pieces& parts) {
      const auto& [a, b, c] = from_.triangles[f];
      parts.emplace_back(to_, std::array{samples[a], samples[b], samples[c]});
    });
  }

  // Three cuts follow the edges of a triangle; the halving after them sees to it that pieces get
  // short, which cuts alone might not.
  Pieces split(const Pieces& open, unsigned level) const {
    return gather(open.size(), [&](std::size_t i, Pieces& parts) {
      const bool for_bound = !is_bounded(open[i]);
      if (for_bound && level % 4 != 3) {
        open[i].cut(to_, parts);
      } else {
        open[i].bisect(to_, parts);
      }
    });
  }

  [[nodiscard]] bool is_bounded(const SurfacePiece& piece) const {
    return piece.upper_bound() <= largest_ + accuracy_;
  }
  [[nodiscard]] bool is_done(const SurfacePiece& piece) const {
    return is_bounded(piece) &&
           (piece.longest_edge() <= resolution_ || piece.upper_bound() <= accuracy_);
  }

  void note_farthest(const Sample& sample) {
    if (sample.distance < largest_) return;
    if (sample.distance == largest_ && noted_) return;
    noted_ = true;
    largest_ = sample.distance;
    at_ = sample.point;
  }

  void finish(const SurfacePiece& piece) {
    const double area = piece.area();
    bound_ = std::max(bound_, piece.upper_bound());
    area_ += area;
    sum_ += area * piece.mean([](double d) { return d; });
    sum_of_squares_ += area * piece.mean([](double d) { return d * d; });
  }

  const Surface& from_;
  const TriangleTree& to_;
  double accuracy_;
  double resolution_;
  const Context& context_;
  bool noted_ = false;
  double largest_ = 0;
  Vector3d at_ = Vector3d::Zero();
  double bound_ = 0;
  double area_ = 0;
  double sum_ = 0;
  double sum_of_squares_ = 0;
};

}  // namespace

Result<Deviation> deviation(const Mesh& a, const Mesh& b, double accuracy, const Context& context) {
  if (!(accuracy > 0)) {
    return fail(ErrorCode::invalid_argument, "the accuracy of a comparison must be positive");
  }
  if (auto checked = check(a, "first"); !checked) return tl::make_unexpected(checked.error());
  if (auto checked = check(b, "second"); !checked) return tl::make_unexpected(checked.error());
  const Frame frame = common_frame(a, b);
  const Surface first = surface_of(a, frame);
  const Surface second = surface_of(b, frame);
  const double side = bounding_box(a.points).side();
  const double error = std::max(accuracy * side / frame.unit, kRounding);
  // `one` is the surface that is split, `other` the one that distances are taken to.
  const auto search = [&](const Surface& one, const Surface& other) {
    return OneSidedSearch(one, tree_of(other), error, kMeanResolution, context).run(frame);
  };
  const auto forth = search(first, second);
  if (!forth) return tl::make_unexpected(forth.error());
  const auto back = search(second, first);
  if (!back) return tl::make_unexpected(back.error());
  return Deviation{*forth, *back, std::max(forth->max, back->max),
                   std::max(forth->max_bound, back->max_bound), side};
}

}  // namespace surpass

#include "reconstruct/neighbours.hpp"

#include <algorithm>

#include <nanoflann.hpp>

namespace surpass::reconstruction {

// What nanoflann asks of a set of points.
struct Neighbours::Tree {
  // NOLINTBEGIN(readability-identifier-naming): the names are nanoflann's.
  struct Source {
    std::span<const Point> points;
    [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t k) const { return points[i][k]; }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
      return false;
    }
  };
  // NOLINTEND(readability-identifier-naming)
  using Index3 = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Source>,
                                                     Source, 3, Index>;
  explicit Tree(std::span<const Point> points) : source{points}, index(3, source, {16}) {}
  Source source;
  Index3 index;
};

Neighbours::Neighbours(std::span<const Point> points)
    : points_(points), tree_(std::make_unique<Tree>(points)) {}

Neighbours::~Neighbours() = default;

std::span<const Index> Neighbours::in_space() const { return tree_->index.vAcc; }

void Neighbours::nearest(Index i, std::size_t k, std::vector<Index>& found) const {
  std::vector<double> distances(k + 1);
  found.resize(k + 1);
  const std::size_t count =
      tree_->index.knnSearch(points_[i].data(), k + 1, found.data(), distances.data());
  found.resize(count);
  // Points are different, so the nearest one is the point itself; rounding may say otherwise.
  const auto self = std::find(found.begin(), found.end(), i);
  found.erase(self != found.end() ? self : found.end() - 1);
}

}  // namespace surpass::reconstruction

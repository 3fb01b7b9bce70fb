// Only corners that are not convex can lie in an ear, and clipping ears makes none of those anew:
// they are put into a grid once, and an ear is tested against the cells under its box.
// G. H. Meisters, Polygons have ears, American Mathematical Monthly 82 (1975).
#include "mesh/ear_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace surpass {
namespace {

Point newell_normal(std::span<const Point> polygon) {
  Point n = {};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    const Point& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    n[0] += (p[1] - q[1]) * (p[2] + q[2]);
    n[1] += (p[2] - q[2]) * (p[0] + q[0]);
    n[2] += (p[0] - q[0]) * (p[1] + q[1]);
  }
  return n;
}

}  // namespace

void EarClipping::project(std::span<const Point> polygon) {
  double unit = bounding_box(polygon).side();
  if (!(unit > 0)) unit = 1;
  local_.clear();
  for (const Point& p : polygon) {
    Point& to = local_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) to[k] = (p[k] - polygon[0][k]) / unit;
  }
  const Point normal = newell_normal(local_);
  std::size_t axis = 0;
  for (const std::size_t k : {1U, 2U}) {
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  }
  std::size_t x = (axis + 1) % 3;
  std::size_t y = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(x, y);
  flat_.clear();
  for (const Point& p : local_) flat_.push_back({p[x], p[y]});
}

void EarClipping::link(Index k) {
  previous_.resize(k);
  next_.resize(k);
  for (Index i = 0; i < k; ++i) {
    previous_[i] = i == 0 ? k - 1 : i - 1;
    next_[i] = i + 1 == k ? 0 : i + 1;
  }
  stamp_.assign(k, 0);
  clipped_.assign(k, 0);
}

// Twice the signed area of a triangle in view.
double EarClipping::turn(Index a, Index b, Index c) const {
  return (flat_[b][0] - flat_[a][0]) * (flat_[c][1] - flat_[a][1]) -
         (flat_[b][1] - flat_[a][1]) * (flat_[c][0] - flat_[a][0]);
}

std::size_t EarClipping::cell(double x, std::size_t axis) const {
  const double place = extent_[axis] > 0 ? (x - low_[axis]) / extent_[axis] : 0.0;
  const auto last = static_cast<double>(side_ - 1);
  return place > 0 ? static_cast<std::size_t>(std::min(place * static_cast<double>(side_), last))
                   : 0;
}

void EarClipping::list_blockers() {
  std::vector<Index> blockers;
  for (Index v = 0; v < flat_.size(); ++v) {
    if (!(turn(previous_[v], v, next_[v]) > 0)) blockers.push_back(v);
  }
  side_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(blockers.size()))));
  if (side_ == 0) return;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [low, high] =
        std::minmax_element(flat_.begin(), flat_.end(),
                            [axis](const Point2& p, const Point2& q) { return p[axis] < q[axis]; });
    low_[axis] = (*low)[axis];
    extent_[axis] = (*high)[axis] - (*low)[axis];
  }
  // A counting sort; ends become beginnings as the cells are filled from behind.
  const auto cell_of = [&](Index v) { return cell(flat_[v][1], 1) * side_ + cell(flat_[v][0], 0); };
  cell_begin_.assign(side_ * side_ + 1, 0);
  for (const Index v : blockers) ++cell_begin_[cell_of(v)];
  std::partial_sum(cell_begin_.begin(), cell_begin_.end(), cell_begin_.begin());
  cell_items_.resize(blockers.size());
  for (const Index v : blockers) cell_items_[--cell_begin_[cell_of(v)]] = v;
}

// True if v keeps its neighbours' or any other corner's triangle from being an ear.
bool EarClipping::blocks(Index v, Index tip) const {
  const Index a = previous_[tip];
  const Index c = next_[tip];
  if (clipped_[v] != 0 || v == a || v == tip || v == c) return false;
  // The two sides of a bridge to a hole share positions and do not block each other.
  if (flat_[v] == flat_[a] || flat_[v] == flat_[tip] || flat_[v] == flat_[c]) return false;
  return turn(a, tip, v) >= 0 && turn(tip, c, v) >= 0 && turn(c, a, v) >= 0;
}

bool EarClipping::is_ear(Index tip) const {
  const Index a = previous_[tip];
  const Index c = next_[tip];
  if (!(turn(a, tip, c) > 0)) return false;
  if (side_ == 0) return true;
  const auto cells = [&](std::size_t axis) {
    const auto [low, high] = std::minmax({flat_[a][axis], flat_[tip][axis], flat_[c][axis]});
    return std::array{cell(low, axis), cell(high, axis)};
  };
  const auto [left, right] = cells(0);
  const auto [bottom, top] = cells(1);
  for (std::size_t y = bottom; y <= top; ++y) {
    // The cells of a row lie one behind the other.
    const Index end = cell_begin_[y * side_ + right + 1];
    for (Index i = cell_begin_[y * side_ + left]; i < end; ++i) {
      if (blocks(cell_items_[i], tip)) return false;
    }
  }
  return true;
}

// Puts a corner into the heap; one that is not convex comes last.
void EarClipping::consider(Index tip) {
  const Point& a = local_[previous_[tip]];
  const Point& c = local_[next_[tip]];
  double length = std::hypot(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
  if (!(turn(previous_[tip], tip, next_[tip]) > 0) || !std::isfinite(length)) {
    length = std::numeric_limits<double>::infinity();
  }
  heap_.push_back({length, tip, ++stamp_[tip]});
  std::push_heap(heap_.begin(), heap_.end());
}

void EarClipping::clip(Index tip) {
  const Index a = previous_[tip];
  const Index c = next_[tip];
  triangles_.push_back({a, tip, c});
  next_[a] = c;
  previous_[c] = a;
  clipped_[tip] = 1;
  ++stamp_[tip];
  consider(a);
  consider(c);
}

const std::vector<EarClipping::Triangle>& EarClipping::operator()(std::span<const Point> polygon) {
  const auto k = static_cast<Index>(polygon.size());
  triangles_.clear();
  heap_.clear();
  project(polygon);
  link(k);
  list_blockers();
  for (Index i = 0; i < k; ++i) consider(i);
  bool ears_only = true;
  while (triangles_.size() + 2 < k) {
    if (heap_.empty()) {  // the rest is not simple in view
      ears_only = false;
      for (Index i = 0; i < k; ++i) {
        if (clipped_[i] == 0) consider(i);
      }
    }
    const Candidate best = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    if (best.stamp != stamp_[best.tip] || (ears_only && !is_ear(best.tip))) continue;
    clip(best.tip);
  }
  return triangles_;
}

}  // namespace surpass

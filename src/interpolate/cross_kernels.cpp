#include "interpolate/cross_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "interpolate/regular_patch.hpp"

namespace surpass {
namespace {

std::size_t order_of(Derivative derivative) {
  switch (derivative) {
    case Derivative::first: return 0;
    case Derivative::third: return 2;
    case Derivative::second:
    case Derivative::mixed: break;
  }
  return 1;
}

// The weights of regular_patch::derivatives() over the columns of a PatchKind, with their scale.
std::vector<std::array<double, regular_patch::kPoints>> regular_rows() {
  std::vector<std::array<double, regular_patch::kPoints>> rows(regular_patch::kRows);
  for (std::size_t c = 0; c < regular_patch::kPoints; ++c) {
    double points[regular_patch::kPoints] = {};
    double found[regular_patch::kRows];
    points[regular_patch::kPlace[c]] = 1;
    regular_patch::derivatives(points, found);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto facts = regular_patch::kHalf[r % regular_patch::kHalf.size()];
      rows[r][c] = regular_patch::kScale[facts.order] * found[r];
    }
  }
  return rows;
}

// The same up to the sign, which has no meaning here.
bool same_row(std::span<const double> a, std::span<const double> b) {
  constexpr double kRounding = 1e-12;
  double plus = 0;
  double minus = 0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    plus = std::max(plus, std::abs(a[c] - b[c]));
    minus = std::max(minus, std::abs(a[c] + b[c]));
  }
  return std::min(plus, minus) < kRounding;
}

// The kind's rows in the order of regular_patch; empty if it is another kind.
std::vector<std::size_t> regular_order(const PatchKind& kind) {
  if (kind.columns != regular_patch::kPoints) return {};
  std::vector<std::size_t> left;
  for (std::size_t r = 0; r < kind.row_count(); ++r) {
    if (kind.derivative[r] != Derivative::mixed) left.push_back(r);
  }
  if (left.size() != regular_patch::kRows) return {};
  const auto wanted = regular_rows();
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto facts = regular_patch::kHalf[k % regular_patch::kHalf.size()];
    const auto found = std::find_if(left.begin(), left.end(), [&](std::size_t r) {
      return order_of(kind.derivative[r]) == facts.order && kind.count[r] == facts.count &&
             same_row(kind.row(r), wanted[k]);
    });
    if (found == left.end()) return {};
    order.push_back(*found);
    left.erase(found);
  }
  return order;
}

}  // namespace

CrossKind::CrossKind(const PatchKind& kind) : columns(kind.columns) {
  std::vector<std::size_t> order = regular_order(kind);
  is_regular = !order.empty();
  for (std::size_t r = 0; r < kind.row_count() && !is_regular; ++r) {
    if (kind.derivative[r] != Derivative::mixed) order.push_back(r);
  }
  for (const std::size_t r : order) {
    const std::size_t begin = column.size();
    for (std::size_t c = 0; c < columns; ++c) {
      const double w = kind.row(r)[c];
      if (w == 0) continue;
      column.push_back(static_cast<unsigned>(c));
      weight.push_back(w);
    }
    const std::size_t which = order_of(kind.derivative[r]);
    rows.push_back({begin, column.size(), kind.count[r], which,
                    is_regular ? regular_patch::kScale[which] : 1.0});
  }
}

std::vector<RowLaw> scaled_laws(const CrossKind& kind, const std::vector<RowLaw>& laws) {
  std::vector<RowLaw> scaled;
  for (std::size_t r = 0; r < laws.size(); ++r) {
    const double square = kind.rows[r].scale * kind.rows[r].scale;
    scaled.push_back({laws[r].numerator * square * square, laws[r].slope * square, laws[r].constant,
                      laws[r].threshold / square});
  }
  return scaled;
}

namespace {

// The vectors of some lanes.
template <class W>
struct Vectors {
  typename W::Numbers of[3];
};

template <class W>
[[gnu::always_inline]] inline typename W::Numbers& at(double* lanes) {
  return *reinterpret_cast<typename W::Numbers*>(lanes);
}
template <class W>
[[gnu::always_inline]] inline const typename W::Numbers& at(const double* lanes) {
  return *reinterpret_cast<const typename W::Numbers*>(lanes);
}

template <class W>
[[gnu::always_inline]] inline void dot(const Vectors<W>& a, const Vectors<W>& b,
                                       typename W::Numbers& product) {
  product = a.of[0] * b.of[0] + a.of[1] * b.of[1] + a.of[2] * b.of[2];
}

template <class W>
[[gnu::always_inline]] inline void weigh(const RowLaw& law, const typename W::Numbers& square,
                                         typename W::Numbers& weight) {
  using Numbers = typename W::Numbers;
  using Bits = typename W::Bits;
  const Numbers found = law.numerator / (law.slope * square + law.constant);
  const Bits above = square > law.threshold;
  weight = reinterpret_cast<Numbers>(reinterpret_cast<Bits>(found) & above);
}

// q becomes the weight times (g.g q - g.q g).
template <class W>
[[gnu::always_inline]] inline void cross_twice(const RowLaw& law, const Vectors<W>& g,
                                               Vectors<W>& q) {
  typename W::Numbers square;
  typename W::Numbers along;
  typename W::Numbers weight;
  dot<W>(g, g, square);
  dot<W>(g, q, along);
  weigh<W>(law, square, weight);
  square *= weight;
  along *= weight;
  for (std::size_t c = 0; c < 3; ++c) q.of[c] = square * q.of[c] - along * g.of[c];
}

// A row times points; of the lanes from `first` on, as below.
template <class W>
[[gnu::always_inline]] inline void derive(const CrossKind& kind, const CrossKind::Row& row,
                                          const LaneVectors* points, std::size_t first,
                                          Vectors<W>& sum) {
  sum = {};
  for (std::size_t i = row.begin; i < row.end; ++i) {
    const LaneVectors& p = points[kind.column[i]];
    for (std::size_t c = 0; c < 3; ++c) sum.of[c] += kind.weight[i] * at<W>(p.of[c] + first);
  }
}

template <class W>
[[gnu::always_inline]] inline void regular_derivatives(const LaneVectors* points, std::size_t first,
                                                       Vectors<W>* rows) {
  for (std::size_t c = 0; c < 3; ++c) {
    typename W::Numbers p[regular_patch::kPoints];
    typename W::Numbers r[regular_patch::kRows];
    for (std::size_t k = 0; k < regular_patch::kPoints; ++k) {
      p[regular_patch::kPlace[k]] = at<W>(points[k].of[c] + first);
    }
    regular_patch::derivatives(p, r);
    for (std::size_t k = 0; k < regular_patch::kRows; ++k) rows[k].of[c] = r[k];
  }
}

template <class W>
[[gnu::always_inline]] inline void regular_gradient(const RowLaw* laws,
                                                    const LaneVectors* reference,
                                                    const LaneVectors* x, std::size_t first,
                                                    LaneVectors* sums) {
  Vectors<W> g[regular_patch::kRows];
  Vectors<W> q[regular_patch::kRows];
  regular_derivatives<W>(reference, first, g);
  regular_derivatives<W>(x, first, q);
  for (std::size_t r = 0; r < regular_patch::kRows; ++r) cross_twice<W>(laws[r], g[r], q[r]);
  for (std::size_t c = 0; c < 3; ++c) {
    typename W::Numbers p[regular_patch::kPoints];
    typename W::Numbers r[regular_patch::kRows];
    for (std::size_t k = 0; k < regular_patch::kRows; ++k) r[k] = q[k].of[c];
    regular_patch::collect(r, p);
    for (std::size_t k = 0; k < regular_patch::kPoints; ++k) {
      at<W>(sums[k].of[c] + first) = p[regular_patch::kPlace[k]];
    }
  }
}

template <class W>
[[gnu::always_inline]] inline void squares_of(const CrossKind& kind, const LaneVectors* reference,
                                              std::size_t first, LaneNumbers* squares) {
  if (kind.is_regular) {
    Vectors<W> g[regular_patch::kRows];
    regular_derivatives<W>(reference, first, g);
    for (std::size_t r = 0; r < regular_patch::kRows; ++r) {
      dot<W>(g[r], g[r], at<W>(squares[r].value + first));
    }
    return;
  }
  for (std::size_t r = 0; r < kind.rows.size(); ++r) {
    Vectors<W> g;
    derive<W>(kind, kind.rows[r], reference, first, g);
    dot<W>(g, g, at<W>(squares[r].value + first));
  }
}

template <class W>
[[gnu::always_inline]] inline void gradient_of(const CrossKind& kind, const RowLaw* laws,
                                               const LaneVectors* reference, const LaneVectors* x,
                                               std::size_t first, LaneVectors* sums) {
  if (kind.is_regular) return regular_gradient<W>(laws, reference, x, first, sums);
  for (std::size_t k = 0; k < kind.columns; ++k) {
    for (auto& numbers : sums[k].of) at<W>(numbers + first) = typename W::Numbers{};
  }
  for (std::size_t r = 0; r < kind.rows.size(); ++r) {
    const CrossKind::Row& row = kind.rows[r];
    Vectors<W> g;
    Vectors<W> q;
    derive<W>(kind, row, reference, first, g);
    derive<W>(kind, row, x, first, q);
    cross_twice<W>(laws[r], g, q);
    for (std::size_t i = row.begin; i < row.end; ++i) {
      LaneVectors& to = sums[kind.column[i]];
      for (std::size_t c = 0; c < 3; ++c) at<W>(to.of[c] + first) += kind.weight[i] * q.of[c];
    }
  }
}

template <class W>
[[gnu::always_inline]] inline void diagonal_of(const CrossKind& kind, const RowLaw* laws,
                                               const LaneVectors* reference, std::size_t first,
                                               LaneBlock* sums) {
  using Numbers = typename W::Numbers;
  for (std::size_t k = 0; k < kind.columns; ++k) {
    for (auto& numbers : sums[k].of) at<W>(numbers + first) = Numbers{};
  }
  for (std::size_t r = 0; r < kind.rows.size(); ++r) {
    const CrossKind::Row& row = kind.rows[r];
    Vectors<W> g;
    Numbers square;
    Numbers w;
    derive<W>(kind, row, reference, first, g);
    dot<W>(g, g, square);
    weigh<W>(laws[r], square, w);
    const Numbers& x = g.of[0];
    const Numbers& y = g.of[1];
    const Numbers& z = g.of[2];
    const Numbers block[6] = {w * (square - x * x), -w * x * y, -w * x * z,
                              w * (square - y * y), -w * y * z, w * (square - z * z)};
    for (std::size_t i = row.begin; i < row.end; ++i) {
      const double factor = kind.weight[i] * kind.weight[i];
      LaneBlock& to = sums[kind.column[i]];
      for (std::size_t k = 0; k < 6; ++k) at<W>(to.of[k] + first) += factor * block[k];
    }
  }
}

}  // namespace

void squares_of_patches(const CrossKind& kind, const LaneVectors* reference, LaneNumbers* squares) {
  run_on_lanes([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes; l += W::kCount) squares_of<W>(kind, reference, l, squares);
  });
}

void gradient_of_patches(const CrossKind& kind, const RowLaw* laws, const LaneVectors* reference,
                         const LaneVectors* x, LaneVectors* sums) {
  run_on_lanes([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes; l += W::kCount) {
      gradient_of<W>(kind, laws, reference, x, l, sums);
    }
  });
}

void diagonal_of_patches(const CrossKind& kind, const RowLaw* laws, const LaneVectors* reference,
                         LaneBlock* sums) {
  run_on_lanes([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes; l += W::kCount) {
      diagonal_of<W>(kind, laws, reference, l, sums);
    }
  });
}

}  // namespace surpass

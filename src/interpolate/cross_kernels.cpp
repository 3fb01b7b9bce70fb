#include "interpolate/cross_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "interpolate/each_machine.hpp"
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

using Bits [[gnu::vector_size(64)]] = long long;

[[gnu::always_inline]] inline void weigh(const RowLaw& law, const Lanes& square, Lanes& weight) {
  const Lanes found = law.numerator / (law.slope * square + law.constant);
  const Bits above = square > law.threshold;
  weight = reinterpret_cast<Lanes>(reinterpret_cast<Bits>(found) & above);
}

// A row times points.
[[gnu::always_inline]] inline void derive(const CrossKind& kind, const CrossKind::Row& row,
                                          const LaneVectors* points, LaneVectors& sum) {
  sum = {};
  for (std::size_t i = row.begin; i < row.end; ++i) {
    const LaneVectors& p = points[kind.column[i]];
    for (std::size_t c = 0; c < 3; ++c) sum.of[c] += kind.weight[i] * p.of[c];
  }
}

[[gnu::always_inline]] inline void dot(const LaneVectors& a, const LaneVectors& b, Lanes& product) {
  product = a.of[0] * b.of[0] + a.of[1] * b.of[1] + a.of[2] * b.of[2];
}

// q becomes the weight times (g.g q - g.q g).
[[gnu::always_inline]] inline void cross_twice(const RowLaw& law, const LaneVectors& g,
                                               LaneVectors& q) {
  Lanes square;
  Lanes along;
  Lanes weight;
  dot(g, g, square);
  dot(g, q, along);
  weigh(law, square, weight);
  square *= weight;
  along *= weight;
  for (std::size_t c = 0; c < 3; ++c) q.of[c] = square * q.of[c] - along * g.of[c];
}

[[gnu::always_inline]] inline void regular_derivatives(const LaneVectors* points,
                                                       LaneVectors* rows) {
  for (std::size_t c = 0; c < 3; ++c) {
    Lanes p[regular_patch::kPoints];
    Lanes r[regular_patch::kRows];
    for (std::size_t k = 0; k < regular_patch::kPoints; ++k) {
      p[regular_patch::kPlace[k]] = points[k].of[c];
    }
    regular_patch::derivatives(p, r);
    for (std::size_t k = 0; k < regular_patch::kRows; ++k) rows[k].of[c] = r[k];
  }
}

[[gnu::always_inline]] inline void regular_gradient(const RowLaw* laws,
                                                    const LaneVectors* reference,
                                                    const LaneVectors* x, LaneVectors* sums) {
  LaneVectors g[regular_patch::kRows];
  LaneVectors q[regular_patch::kRows];
  regular_derivatives(reference, g);
  regular_derivatives(x, q);
  for (std::size_t r = 0; r < regular_patch::kRows; ++r) cross_twice(laws[r], g[r], q[r]);
  for (std::size_t c = 0; c < 3; ++c) {
    Lanes p[regular_patch::kPoints];
    Lanes r[regular_patch::kRows];
    for (std::size_t k = 0; k < regular_patch::kRows; ++k) r[k] = q[k].of[c];
    regular_patch::collect(r, p);
    for (std::size_t k = 0; k < regular_patch::kPoints; ++k) {
      sums[k].of[c] = p[regular_patch::kPlace[k]];
    }
  }
}

}  // namespace

SURPASS_FOR_EACH_MACHINE("avx512f", "avx2", "default")
void squares_of_patches(const CrossKind& kind, const LaneVectors* reference, LaneNumbers* squares) {
  if (kind.is_regular) {
    LaneVectors g[regular_patch::kRows];
    regular_derivatives(reference, g);
    for (std::size_t r = 0; r < regular_patch::kRows; ++r) dot(g[r], g[r], squares[r].value);
    return;
  }
  for (std::size_t r = 0; r < kind.rows.size(); ++r) {
    LaneVectors g;
    derive(kind, kind.rows[r], reference, g);
    dot(g, g, squares[r].value);
  }
}

SURPASS_FOR_EACH_MACHINE("avx512f", "avx2", "default")
void gradient_of_patches(const CrossKind& kind, const RowLaw* laws, const LaneVectors* reference,
                         const LaneVectors* x, LaneVectors* sums) {
  if (kind.is_regular) return regular_gradient(laws, reference, x, sums);
  std::fill_n(sums, kind.columns, LaneVectors{});
  for (std::size_t r = 0; r < kind.rows.size(); ++r) {
    const CrossKind::Row& row = kind.rows[r];
    LaneVectors g;
    LaneVectors q;
    derive(kind, row, reference, g);
    derive(kind, row, x, q);
    cross_twice(laws[r], g, q);
    for (std::size_t i = row.begin; i < row.end; ++i) {
      LaneVectors& to = sums[kind.column[i]];
      for (std::size_t c = 0; c < 3; ++c) to.of[c] += kind.weight[i] * q.of[c];
    }
  }
}

SURPASS_FOR_EACH_MACHINE("avx512f", "avx2", "default")
void diagonal_of_patches(const CrossKind& kind, const RowLaw* laws, const LaneVectors* reference,
                         LaneBlock* sums) {
  std::fill_n(sums, kind.columns, LaneBlock{});
  for (std::size_t r = 0; r < kind.rows.size(); ++r) {
    const CrossKind::Row& row = kind.rows[r];
    LaneVectors g;
    Lanes square;
    Lanes w;
    derive(kind, row, reference, g);
    dot(g, g, square);
    weigh(laws[r], square, w);
    const Lanes& x = g.of[0];
    const Lanes& y = g.of[1];
    const Lanes& z = g.of[2];
    const Lanes block[6] = {w * (square - x * x), -w * x * y, -w * x * z,
                            w * (square - y * y), -w * y * z, w * (square - z * z)};
    for (std::size_t i = row.begin; i < row.end; ++i) {
      const double factor = kind.weight[i] * kind.weight[i];
      LaneBlock& to = sums[kind.column[i]];
      for (std::size_t k = 0; k < 6; ++k) to.of[k] += factor * block[k];
    }
  }
}

}  // namespace surpass

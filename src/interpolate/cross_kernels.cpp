#include "interpolate/cross_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "interpolate/star_patch.hpp"

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

using Rows = std::vector<std::vector<double>>;

// The weights of regular_patch::derivatives() over the columns of a PatchKind, with their scale.
Rows regular_rows() {
  Rows rows(regular_patch::kRows, std::vector<double>(regular_patch::kPoints));
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

// The same of the patches of a star, one after the other. Rows that are not found by refinement
// are 0.
Rows star_rows(star_patch::Faces faces) {
  const std::size_t points = 1 + star_patch::kPoints * faces.count;
  const bool regular = faces.count == 4;
  const std::size_t count = star_patch::row_count(regular);
  Rows rows(count * faces.count, std::vector<double>(points));
  std::vector<double> fine(1 + star_patch::kFine * faces.count);
  for (std::size_t c = 0; c < points; ++c) {
    star_patch::refine<double>(
        faces, [&](std::size_t i) { return i == c ? 1.0 : 0.0; },
        [&](std::size_t i) -> double& { return fine[i]; });
    for (std::size_t k = 0; k < faces.count; ++k) {
      double window[25] = {};
      double found[star_patch::kMostRows] = {};
      star_patch::for_window(faces, k, regular,
                             [&](std::size_t to, std::size_t from) { window[to] = fine[from]; });
      star_patch::rows_of_patch(window, regular, found);
      for (std::size_t r = 0; r < count; ++r) {
        const std::size_t order = star_patch::order_of_row(r, regular);
        rows[count * k + r][c] = regular_patch::kScale[order] * found[r];
      }
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

// Takes the row of this order and these weights out of `left`, which are rows of the kind.
std::optional<std::size_t> take_row(const PatchKind& kind, std::size_t order,
                                    std::span<const double> weights,
                                    std::vector<std::size_t>& left) {
  const auto found = std::find_if(left.begin(), left.end(), [&](std::size_t r) {
    return order_of(kind.derivative[r]) == order && same_row(kind.row(r), weights);
  });
  if (found == left.end()) return {};
  const std::size_t row = *found;
  left.erase(found);
  return row;
}

std::vector<std::size_t> without_mixed(const PatchKind& kind, std::size_t first, std::size_t last) {
  std::vector<std::size_t> rows;
  for (std::size_t r = first; r < last; ++r) {
    if (kind.derivative[r] != Derivative::mixed) rows.push_back(r);
  }
  return rows;
}

// The kind's rows in the order of regular_patch; empty if it is another kind.
std::vector<std::size_t> regular_order(const PatchKind& kind) {
  if (kind.columns != regular_patch::kPoints) return {};
  auto left = without_mixed(kind, 0, kind.row_count());
  if (left.size() != regular_patch::kRows) return {};
  const auto wanted = regular_rows();
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto facts = regular_patch::kHalf[k % regular_patch::kHalf.size()];
    const auto row = take_row(kind, facts.order, wanted[k], left);
    if (!row || kind.count[*row] != facts.count) return {};
    order.push_back(*row);
  }
  return order;
}

// The kind's rows in the order of star_patch; empty if it is another kind. The rows of its patches
// come one patch after the other.
std::vector<std::size_t> star_order(const PatchKind& kind, star_patch::Faces faces) {
  const std::size_t rows = kind.row_count() / faces.count;
  if (rows * faces.count != kind.row_count()) return {};
  const bool regular = faces.count == 4;
  const auto wanted = star_rows(faces);
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < faces.count; ++k) {
    auto left = without_mixed(kind, rows * k, rows * (k + 1));
    if (left.size() != star_patch::row_count(regular)) return {};
    const std::size_t first = order.size();
    for (std::size_t r = 0; r < star_patch::row_count(regular); ++r) {
      order.push_back(0);
      if (!regular && r == star_patch::kAtCentre) continue;
      const auto row =
          take_row(kind, star_patch::order_of_row(r, regular), wanted[first + r], left);
      if (!row) return {};
      order.back() = *row;
    }
    if (regular) continue;
    order[first + star_patch::kAtCentre] = left.front();
  }
  return order;
}

}  // namespace

void CrossKind::add(const PatchKind& kind, std::size_t row, double scale) {
  const std::size_t begin = column.size();
  for (std::size_t c = 0; c < columns; ++c) {
    const double w = kind.row(row)[c];
    if (w == 0) continue;
    column.push_back(static_cast<unsigned>(c));
    weight.push_back(w);
    square.push_back(w / scale * (w / scale));
  }
  rows.push_back({begin, column.size(), kind.count[row], order_of(kind.derivative[row]), scale});
}

bool CrossKind::add_star(const PatchKind& kind) {
  const std::size_t faces = (columns - 1) / star_patch::kPoints;
  if (faces * star_patch::kPoints + 1 != columns || faces < 3 || faces > star_patch::kMostFaces) {
    return false;
  }
  const auto order = star_order(kind, {faces});
  const bool regular = faces == 4;
  for (std::size_t r = 0; r < order.size(); ++r) {
    const bool alone = !regular && r % star_patch::row_count(regular) == star_patch::kAtCentre;
    add(kind, order[r], alone ? 1 : regular_patch::kScale[order_of(kind.derivative[order[r]])]);
  }
  if (!order.empty()) star = faces;
  return star != 0;
}

CrossKind::CrossKind(const PatchKind& kind) : columns(kind.columns) {
  if (add_star(kind)) return;
  const std::vector<std::size_t> order = regular_order(kind);
  is_regular = !order.empty();
  for (const std::size_t r : is_regular ? order : without_mixed(kind, 0, kind.row_count())) {
    add(kind, r, is_regular ? regular_patch::kScale[order_of(kind.derivative[r])] : 1.0);
  }
}

std::size_t CrossKind::fine_points() const { return star == 0 ? 0 : 1 + star_patch::kFine * star; }

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

// What the weight is divided by, or 1 where there is none.
template <class W>
[[gnu::always_inline]] inline void divisor(const RowLaw& law, const typename W::Numbers& square,
                                           typename W::Numbers& found) {
  using Numbers = typename W::Numbers;
  using Bits = typename W::Bits;
  const Bits above = square > law.threshold;
  const Numbers plain = law.slope * square + law.constant;
  const Numbers one = Numbers{} + 1.0;
  found = reinterpret_cast<Numbers>((reinterpret_cast<Bits>(plain) & above) |
                                    (reinterpret_cast<Bits>(one) & ~above));
}

template <class W>
[[gnu::always_inline]] inline void weigh(const RowLaw& law, const typename W::Numbers& square,
                                         const typename W::Numbers& reciprocal,
                                         typename W::Numbers& weight) {
  using Numbers = typename W::Numbers;
  using Bits = typename W::Bits;
  const Bits above = square > law.threshold;
  weight = reinterpret_cast<Numbers>(reinterpret_cast<Bits>(law.numerator * reciprocal) & above);
}

// Each q becomes the weight times (g.g q - g.q g). Two rows share a division, which takes as long
// as all else that is done for them here.
template <class W>
[[gnu::always_inline]] inline void cross_twice(const RowLaw* laws, const Vectors<W>* g,
                                               std::size_t rows, Vectors<W>* q) {
  using Numbers = typename W::Numbers;
  const auto finish = [&](std::size_t r, Numbers & square, const Numbers& reciprocal)
      __attribute__((always_inline)) {
    Numbers along;
    Numbers weight;
    dot<W>(g[r], q[r], along);
    weigh<W>(laws[r], square, reciprocal, weight);
    square *= weight;
    along *= weight;
    for (std::size_t c = 0; c < 3; ++c) q[r].of[c] = square * q[r].of[c] - along * g[r].of[c];
  };
  std::size_t r = 0;
  for (; r + 1 < rows; r += 2) {
    Numbers squares[2];
    Numbers divisors[2];
    for (std::size_t k = 0; k < 2; ++k) {
      dot<W>(g[r + k], g[r + k], squares[k]);
      divisor<W>(laws[r + k], squares[k], divisors[k]);
    }
    const Numbers both = 1 / (divisors[0] * divisors[1]);
    finish(r, squares[0], both * divisors[1]);
    finish(r + 1, squares[1], both * divisors[0]);
  }
  if (r < rows) {
    Numbers square;
    Numbers only;
    dot<W>(g[r], g[r], square);
    divisor<W>(laws[r], square, only);
    finish(r, square, 1 / only);
  }
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
  cross_twice<W>(laws, g, regular_patch::kRows, q);
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

// Coordinate c of the fine points of a star.
template <class W>
[[gnu::always_inline]] inline void refine_star(star_patch::Faces faces, const LaneVectors* points,
                                               std::size_t first, LaneVectors* fine) {
  using Numbers = typename W::Numbers;
  for (std::size_t c = 0; c < 3; ++c) {
    star_patch::refine<Numbers>(
        faces,
        [&](std::size_t i) __attribute__((always_inline))->const Numbers& {
          return at<W>(points[i].of[c] + first);
        },
        [&](std::size_t i) __attribute__((always_inline))->Numbers& {
          return at<W>(fine[i].of[c] + first);
        });
  }
}

// The rows of patch k of a star, from its fine points or, where these do not tell, its points.
template <class W, bool kRegular>
[[gnu::always_inline]] inline void star_derivatives(const CrossKind& kind, std::size_t k,
                                                    const LaneVectors* points,
                                                    const LaneVectors* fine, std::size_t first,
                                                    Vectors<W>* rows) {
  for (std::size_t c = 0; c < 3; ++c) {
    alignas(kLaneAlignment) typename W::Numbers window[25];
    alignas(kLaneAlignment) typename W::Numbers found[star_patch::kMostRows];
    star_patch::for_window(
        {kind.star}, k,
        kRegular, [&](std::size_t to, std::size_t from) __attribute__((always_inline)) {
          window[to] = at<W>(fine[from].of[c] + first);
        });
    star_patch::rows_of_patch(window, kRegular, found);
    for (std::size_t r = 0; r < star_patch::row_count(kRegular); ++r) rows[r].of[c] = found[r];
  }
  if (kRegular) return;
  const CrossKind::Row& row = kind.rows[star_patch::kMostRows * k + star_patch::kAtCentre];
  derive<W>(kind, row, points, first, rows[star_patch::kAtCentre]);
}

// Adds the transposed, apart from the row at the centre that the fine points do not tell.
template <class W, bool kRegular>
[[gnu::always_inline]] inline void collect_star_rows(const CrossKind& kind, std::size_t k,
                                                     const Vectors<W>* rows, std::size_t first,
                                                     LaneVectors* fine) {
  for (std::size_t c = 0; c < 3; ++c) {
    alignas(kLaneAlignment) typename W::Numbers window[25] = {};
    alignas(kLaneAlignment) typename W::Numbers found[star_patch::kMostRows];
    for (std::size_t r = 0; r < star_patch::row_count(kRegular); ++r) found[r] = rows[r].of[c];
    star_patch::collect_patch(found, kRegular, window);
    star_patch::for_window(
        {kind.star}, k,
        kRegular, [&](std::size_t from, std::size_t to) __attribute__((always_inline)) {
          at<W>(fine[to].of[c] + first) += window[from];
        });
  }
}

template <class W, bool kRegular>
[[gnu::always_inline]] inline void star_gradient(const CrossKind& kind, const RowLaw* laws,
                                                 const LaneVectors* reference, const LaneVectors* x,
                                                 std::size_t first, LaneVectors* sums,
                                                 LaneVectors* work) {
  using Numbers = typename W::Numbers;
  const star_patch::Faces faces{kind.star};
  const std::size_t size = kind.fine_points();
  LaneVectors* const of_reference = work;
  LaneVectors* const of_x = work + size;
  LaneVectors* const of_sums = work + 2 * size;
  refine_star<W>(faces, reference, first, of_reference);
  refine_star<W>(faces, x, first, of_x);
  for (std::size_t i = 0; i < size; ++i) {
    for (auto& numbers : of_sums[i].of) at<W>(numbers + first) = Numbers{};
  }
  Vectors<W> tangents[star_patch::kMostFaces];
  for (std::size_t k = 0; k < faces.count; ++k) {
    Vectors<W> g[star_patch::kMostRows];
    Vectors<W> q[star_patch::kMostRows];
    star_derivatives<W, kRegular>(kind, k, reference, of_reference, first, g);
    star_derivatives<W, kRegular>(kind, k, x, of_x, first, q);
    const RowLaw* const own = laws + star_patch::row_count(kRegular) * k;
    cross_twice<W>(own, g, star_patch::row_count(kRegular), q);
    if (!kRegular) tangents[k] = q[star_patch::kAtCentre];
    collect_star_rows<W, kRegular>(kind, k, q, first, of_sums);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    star_patch::collect<Numbers>(
        faces,
        [&](std::size_t i) __attribute__((always_inline))->const Numbers& {
          return at<W>(of_sums[i].of[c] + first);
        },
        [&](std::size_t i) __attribute__((always_inline))->Numbers& {
          return at<W>(sums[i].of[c] + first);
        });
  }
  for (std::size_t k = 0; !kRegular && k < faces.count; ++k) {
    const CrossKind::Row& row = kind.rows[star_patch::kMostRows * k + star_patch::kAtCentre];
    for (std::size_t i = row.begin; i < row.end; ++i) {
      LaneVectors& to = sums[kind.column[i]];
      for (std::size_t c = 0; c < 3; ++c) {
        at<W>(to.of[c] + first) += kind.weight[i] * tangents[k].of[c];
      }
    }
  }
}

// use(r, derivative r of the points) for the rows of a kind.
template <class W, class Use>
[[gnu::always_inline]] inline void for_derivatives(const CrossKind& kind, const LaneVectors* points,
                                                   std::size_t first, LaneVectors* work,
                                                   Use&& use) {
  if (kind.star != 0) {
    refine_star<W>({kind.star}, points, first, work);
    for (std::size_t k = 0; k < kind.star; ++k) {
      Vectors<W> g[star_patch::kMostRows];
      const std::size_t count = star_patch::row_count(kind.star == 4);
      if (kind.star == 4) {
        star_derivatives<W, true>(kind, k, points, work, first, g);
      } else {
        star_derivatives<W, false>(kind, k, points, work, first, g);
      }
      for (std::size_t r = 0; r < count; ++r) use(count * k + r, g[r]);
    }
  } else if (kind.is_regular) {
    Vectors<W> g[regular_patch::kRows];
    regular_derivatives<W>(points, first, g);
    for (std::size_t r = 0; r < regular_patch::kRows; ++r) use(r, g[r]);
  } else {
    for (std::size_t r = 0; r < kind.rows.size(); ++r) {
      Vectors<W> g;
      derive<W>(kind, kind.rows[r], points, first, g);
      use(r, g);
    }
  }
}

template <class W>
[[gnu::always_inline]] inline void squares_of(const CrossKind& kind, const LaneVectors* reference,
                                              std::size_t first, LaneNumbers* squares,
                                              LaneVectors* work) {
  for_derivatives<W>(
      kind, reference, first,
      work, [&](std::size_t r, const Vectors<W>& g) __attribute__((always_inline)) {
        dot<W>(g, g, at<W>(squares[r].value + first));
      });
}

template <class W>
[[gnu::always_inline]] inline void gradient_of(const CrossKind& kind, const RowLaw* laws,
                                               const LaneVectors* reference, const LaneVectors* x,
                                               std::size_t first, LaneVectors* sums,
                                               LaneVectors* work) {
  if (kind.star == 4) {
    return star_gradient<W, true>(kind, laws, reference, x, first, sums, work);
  }
  if (kind.star != 0) {
    return star_gradient<W, false>(kind, laws, reference, x, first, sums, work);
  }
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
    cross_twice<W>(laws + r, &g, 1, &q);
    for (std::size_t i = row.begin; i < row.end; ++i) {
      LaneVectors& to = sums[kind.column[i]];
      for (std::size_t c = 0; c < 3; ++c) at<W>(to.of[c] + first) += kind.weight[i] * q.of[c];
    }
  }
}

template <class W>
[[gnu::always_inline]] inline void diagonal_of(const CrossKind& kind, const RowLaw* laws,
                                               const LaneVectors* reference, std::size_t first,
                                               LaneBlock* sums, LaneVectors* work) {
  using Numbers = typename W::Numbers;
  for (std::size_t k = 0; k < kind.columns; ++k) {
    for (auto& numbers : sums[k].of) at<W>(numbers + first) = Numbers{};
  }
  const auto add = [&](std::size_t r, const Vectors<W>& g) __attribute__((always_inline)) {
    const CrossKind::Row& row = kind.rows[r];
    Numbers square;
    Numbers w;
    Numbers reciprocal;
    dot<W>(g, g, square);
    divisor<W>(laws[r], square, reciprocal);
    reciprocal = 1 / reciprocal;
    weigh<W>(laws[r], square, reciprocal, w);
    const Numbers& x = g.of[0];
    const Numbers& y = g.of[1];
    const Numbers& z = g.of[2];
    const Numbers block[6] = {w * (square - x * x), -w * x * y, -w * x * z,
                              w * (square - y * y), -w * y * z, w * (square - z * z)};
    for (std::size_t i = row.begin; i < row.end; ++i) {
      const double factor = kind.square[i];
      LaneBlock& to = sums[kind.column[i]];
      for (std::size_t k = 0; k < 6; ++k) at<W>(to.of[k] + first) += factor * block[k];
    }
  };
  for_derivatives<W>(kind, reference, first, work, add);
}

}  // namespace

void squares_of_patches(const CrossKind& kind, const LaneVectors* reference, LaneNumbers* squares,
                        LaneVectors* work) {
  run_on_lanes([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes; l += W::kCount) {
      squares_of<W>(kind, reference, l, squares, work);
    }
  });
}

void gradient_of_patches(const CrossKind& kind, const RowLaw* laws, const LaneVectors* reference,
                         const LaneVectors* x, LaneVectors* sums, LaneVectors* work) {
  run_on_lanes([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes; l += W::kCount) {
      gradient_of<W>(kind, laws, reference, x, l, sums, work);
    }
  });
}

void diagonal_of_patches(const CrossKind& kind, const RowLaw* laws, const LaneVectors* reference,
                         LaneBlock* sums, LaneVectors* work) {
  run_on_lanes([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes; l += W::kCount) {
      diagonal_of<W>(kind, laws, reference, l, sums, work);
    }
  });
}

}  // namespace surpass

#include "interpolate/cross_kernels.hpp"

#include "interpolate/star_patch.hpp"

namespace surpass {
namespace {

// The vectors of some lanes.
template <class W>
struct Vectors {
  typename W::Numbers of[3];
};

template <class W>
[[gnu::always_inline]] inline typename W::Numbers& at(typename W::Real* lanes) {
  return *reinterpret_cast<typename W::Numbers*>(lanes);
}
template <class W>
[[gnu::always_inline]] inline const typename W::Numbers& at(const typename W::Real* lanes) {
  return *reinterpret_cast<const typename W::Numbers*>(lanes);
}

template <class W>
using LanePoints = LaneVectors<typename W::Real>;
template <class W>
using LaneLaw = RowLaw<typename W::Real>;

template <class W>
[[gnu::always_inline]] inline typename W::Real weight_at(const CrossKind& kind, std::size_t i) {
  return static_cast<typename W::Real>(kind.weight[i]);
}

template <class W>
[[gnu::always_inline]] inline void dot(const Vectors<W>& a, const Vectors<W>& b,
                                       typename W::Numbers& product) {
  product = a.of[0] * b.of[0] + a.of[1] * b.of[1] + a.of[2] * b.of[2];
}

// What the weight is divided by. kBounded: laws have thresholds, and it is 1 where there is no
// weight.
template <class W, bool kBounded>
[[gnu::always_inline]] inline void divisor(const LaneLaw<W>& law, const typename W::Numbers& square,
                                           typename W::Numbers& found) {
  using Numbers = typename W::Numbers;
  using Bits = typename W::Bits;
  found = law.slope * square + law.constant;
  if (!kBounded) return;
  const Bits above = square > law.threshold;
  const Numbers one = Numbers{} + 1;
  found = reinterpret_cast<Numbers>((reinterpret_cast<Bits>(found) & above) |
                                    (reinterpret_cast<Bits>(one) & ~above));
}

template <class W, bool kBounded>
[[gnu::always_inline]] inline void weigh(const LaneLaw<W>& law, const typename W::Numbers& square,
                                         const typename W::Numbers& reciprocal,
                                         typename W::Numbers& weight) {
  using Numbers = typename W::Numbers;
  using Bits = typename W::Bits;
  weight = law.numerator * reciprocal;
  if (!kBounded) return;
  const Bits above = square > law.threshold;
  weight = reinterpret_cast<Numbers>(reinterpret_cast<Bits>(weight) & above);
}

// q becomes the weight times (g.g q - g.q g); `square` is g.g, the reciprocal that of its divisor.
template <class W, bool kBounded>
[[gnu::always_inline]] inline void cross_twice(const LaneLaw<W>& law, const Vectors<W>& g,
                                               typename W::Numbers& square,
                                               const typename W::Numbers& reciprocal,
                                               Vectors<W>& q) {
  typename W::Numbers along;
  typename W::Numbers weight;
  dot<W>(g, q, along);
  weigh<W, kBounded>(law, square, reciprocal, weight);
  square *= weight;
  along *= weight;
  for (std::size_t c = 0; c < 3; ++c) q.of[c] = square * q.of[c] - along * g.of[c];
}

template <class W>
[[gnu::always_inline]] inline void cross_twice(const LaneLaw<W>& law, const Vectors<W>& g,
                                               Vectors<W>& q) {
  typename W::Numbers square;
  typename W::Numbers only;
  dot<W>(g, g, square);
  divisor<W, true>(law, square, only);
  cross_twice<W, true>(law, g, square, 1 / only, q);
}

// Those of a patch, coordinate by coordinate.
template <class W>
struct Derivatives {
  typename W::Numbers of[3][star_patch::kMostRows];
  [[gnu::always_inline]] void get(std::size_t row, Vectors<W>& v) const {
    for (std::size_t c = 0; c < 3; ++c) v.of[c] = of[c][row];
  }
  [[gnu::always_inline]] void set(std::size_t row, const Vectors<W>& v) {
    for (std::size_t c = 0; c < 3; ++c) of[c][row] = v.of[c];
  }
};

// Two rows share a division, which takes as long as all else that is done for them here.
template <class W, bool kBounded>
[[gnu::always_inline]] inline void cross_pairs(const LaneLaw<W>* laws, const Derivatives<W>& g,
                                               std::size_t rows, Derivatives<W>& q) {
  using Numbers = typename W::Numbers;
  for (std::size_t r = 0; r + 1 < rows; r += 2) {
    Vectors<W> of_reference[2];
    Numbers squares[2];
    Numbers divisors[2];
    for (std::size_t k = 0; k < 2; ++k) {
      g.get(r + k, of_reference[k]);
      dot<W>(of_reference[k], of_reference[k], squares[k]);
      divisor<W, kBounded>(laws[r + k], squares[k], divisors[k]);
    }
    const Numbers both = 1 / (divisors[0] * divisors[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      Vectors<W> of_x;
      q.get(r + k, of_x);
      cross_twice<W, kBounded>(laws[r + k], of_reference[k], squares[k], both * divisors[1 - k],
                               of_x);
      q.set(r + k, of_x);
    }
  }
}

template <class W>
[[gnu::always_inline]] inline void cross_all(const LaneLaw<W>* laws, const Derivatives<W>& g,
                                             std::size_t rows, Derivatives<W>& q) {
  if (laws->is_bounded()) {
    cross_pairs<W, true>(laws, g, rows, q);
  } else {
    cross_pairs<W, false>(laws, g, rows, q);
  }
  if (rows % 2 == 0) return;
  Vectors<W> of_reference;
  Vectors<W> of_x;
  g.get(rows - 1, of_reference);
  q.get(rows - 1, of_x);
  cross_twice<W>(laws[rows - 1], of_reference, of_x);
  q.set(rows - 1, of_x);
}

// A row times points; of the lanes from `first` on, as below.
template <class W>
[[gnu::always_inline]] inline void derive(const CrossKind& kind, const CrossKind::Row& row,
                                          const LanePoints<W>* points, std::size_t first,
                                          Vectors<W>& sum) {
  sum = {};
  for (std::size_t i = row.begin; i < row.end; ++i) {
    const LanePoints<W>& p = points[kind.column[i]];
    for (std::size_t c = 0; c < 3; ++c) sum.of[c] += weight_at<W>(kind, i) * at<W>(p.of[c] + first);
  }
}

template <class W>
[[gnu::always_inline]] inline void regular_derivatives(const LanePoints<W>* points,
                                                       std::size_t first, Derivatives<W>& rows) {
  for (std::size_t c = 0; c < 3; ++c) {
    typename W::Numbers p[regular_patch::kPoints];
    for (std::size_t k = 0; k < regular_patch::kPoints; ++k) {
      p[regular_patch::kPlace[k]] = at<W>(points[k].of[c] + first);
    }
    regular_patch::derivatives(p, rows.of[c]);
  }
}

template <class W>
[[gnu::always_inline]] inline void regular_gradient(const LaneLaw<W>* laws,
                                                    const LanePoints<W>* reference,
                                                    const LanePoints<W>* x, std::size_t first,
                                                    LanePoints<W>* sums) {
  Derivatives<W> g;
  Derivatives<W> q;
  regular_derivatives<W>(reference, first, g);
  regular_derivatives<W>(x, first, q);
  cross_all<W>(laws, g, regular_patch::kRows, q);
  for (std::size_t c = 0; c < 3; ++c) {
    typename W::Numbers p[regular_patch::kPoints];
    regular_patch::collect(q.of[c], p);
    for (std::size_t k = 0; k < regular_patch::kPoints; ++k) {
      at<W>(sums[k].of[c] + first) = p[regular_patch::kPlace[k]];
    }
  }
}

// Coordinate c of the fine points of a star.
template <class W>
[[gnu::always_inline]] inline void refine_star(star_patch::Faces faces, const LanePoints<W>* points,
                                               std::size_t first, LanePoints<W>* fine) {
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

// The fine points that a patch of a star needs, as regular_patch looks at them.
template <class W>
class Window {
 public:
  Window(star_patch::Faces faces, std::size_t k, const typename W::Real* fine)
      : fine_(fine), at_(faces, k) {}
  [[gnu::always_inline]] const typename W::Numbers& operator[](std::size_t place) const {
    return at<W>(fine_ + kStride * at_.fine(place));
  }

 private:
  static constexpr std::size_t kStride = sizeof(LanePoints<W>) / sizeof(typename W::Real);
  const typename W::Real* fine_;
  star_patch::Window at_;
};

// The rows of patch k of a star, from its fine points or, where these do not tell, its points.
template <class W, bool kRegular>
[[gnu::always_inline]] inline void star_derivatives(const CrossKind& kind, std::size_t k,
                                                    const LanePoints<W>* points,
                                                    const LanePoints<W>* fine, std::size_t first,
                                                    Derivatives<W>& rows) {
  for (std::size_t c = 0; c < 3; ++c) {
    star_patch::rows_of_patch(Window<W>({kind.star}, k, fine->of[c] + first), kRegular, rows.of[c]);
  }
  if (kRegular) return;
  const CrossKind::Row& row = kind.rows[star_patch::kMostRows * k + star_patch::kAtCentre];
  Vectors<W> found;
  derive<W>(kind, row, points, first, found);
  rows.set(star_patch::kAtCentre, found);
}

// Adds the transposed, apart from the row at the centre that the fine points do not tell.
template <class W, bool kRegular>
[[gnu::always_inline]] inline void collect_star_rows(const CrossKind& kind, std::size_t k,
                                                     const Derivatives<W>& rows, std::size_t first,
                                                     LanePoints<W>* fine) {
  const star_patch::Window places({kind.star}, k);
  for (std::size_t c = 0; c < 3; ++c) {
    // Among three faces two of the places are of the same fine point.
    alignas(kLaneAlignment) typename W::Numbers window[25] = {};
    star_patch::collect_patch(rows.of[c], kRegular, window);
    constexpr std::size_t kUnseen = kRegular ? 15 : 0;  // by any row
    star_patch::for_places([&](std::size_t i) __attribute__((always_inline)) {
      if (i != kUnseen) at<W>(fine[places.fine(i)].of[c] + first) += window[i];
    });
  }
}

template <class W, bool kRegular>
[[gnu::always_inline]] inline void star_gradient(const CrossKind& kind, const LaneLaw<W>* laws,
                                                 const LanePoints<W>* reference,
                                                 const LanePoints<W>* x, std::size_t first,
                                                 LanePoints<W>* sums, LanePoints<W>* work) {
  using Numbers = typename W::Numbers;
  const star_patch::Faces faces{kind.star};
  const std::size_t size = kind.fine_points();
  LanePoints<W>* const of_reference = work;
  LanePoints<W>* const of_x = work + size;
  LanePoints<W>* const of_sums = work + 2 * size;
  refine_star<W>(faces, reference, first, of_reference);
  refine_star<W>(faces, x, first, of_x);
  for (std::size_t i = 0; i < size; ++i) {
    for (auto& numbers : of_sums[i].of) at<W>(numbers + first) = Numbers{};
  }
  Vectors<W> tangents[star_patch::kMostFaces];
  for (std::size_t k = 0; k < faces.count; ++k) {
    Derivatives<W> g;
    Derivatives<W> q;
    star_derivatives<W, kRegular>(kind, k, reference, of_reference, first, g);
    star_derivatives<W, kRegular>(kind, k, x, of_x, first, q);
    const LaneLaw<W>* const own = laws + star_patch::row_count(kRegular) * k;
    cross_all<W>(own, g, star_patch::row_count(kRegular), q);
    if (!kRegular) q.get(star_patch::kAtCentre, tangents[k]);
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
      LanePoints<W>& to = sums[kind.column[i]];
      for (std::size_t c = 0; c < 3; ++c) {
        at<W>(to.of[c] + first) += weight_at<W>(kind, i) * tangents[k].of[c];
      }
    }
  }
}

// use(r, derivative r of the points) for the rows of a kind.
template <class W, class Use>
[[gnu::always_inline]] inline void for_derivatives(const CrossKind& kind,
                                                   const LanePoints<W>* points, std::size_t first,
                                                   LanePoints<W>* work, Use&& use) {
  if (kind.star != 0) {
    refine_star<W>({kind.star}, points, first, work);
    for (std::size_t k = 0; k < kind.star; ++k) {
      Derivatives<W> g;
      const std::size_t count = star_patch::row_count(kind.star == 4);
      if (kind.star == 4) {
        star_derivatives<W, true>(kind, k, points, work, first, g);
      } else {
        star_derivatives<W, false>(kind, k, points, work, first, g);
      }
      for (std::size_t r = 0; r < count; ++r) {
        Vectors<W> v;
        g.get(r, v);
        use(count * k + r, v);
      }
    }
  } else if (kind.is_regular) {
    Derivatives<W> g;
    regular_derivatives<W>(points, first, g);
    for (std::size_t r = 0; r < regular_patch::kRows; ++r) {
      Vectors<W> v;
      g.get(r, v);
      use(r, v);
    }
  } else {
    for (std::size_t r = 0; r < kind.rows.size(); ++r) {
      Vectors<W> g;
      derive<W>(kind, kind.rows[r], points, first, g);
      use(r, g);
    }
  }
}

template <class W>
[[gnu::always_inline]] inline void squares_of(const CrossKind& kind, const LanePoints<W>* reference,
                                              std::size_t first, LaneNumbers* squares,
                                              LanePoints<W>* work) {
  for_derivatives<W>(
      kind, reference, first,
      work, [&](std::size_t r, const Vectors<W>& g) __attribute__((always_inline)) {
        dot<W>(g, g, at<W>(squares[r].value + first));
      });
}

template <class W>
[[gnu::always_inline]] inline void gradient_of(const CrossKind& kind, const LaneLaw<W>* laws,
                                               const LanePoints<W>* reference,
                                               const LanePoints<W>* x, std::size_t first,
                                               LanePoints<W>* sums, LanePoints<W>* work) {
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
    cross_twice<W>(laws[r], g, q);
    for (std::size_t i = row.begin; i < row.end; ++i) {
      LanePoints<W>& to = sums[kind.column[i]];
      for (std::size_t c = 0; c < 3; ++c)
        at<W>(to.of[c] + first) += weight_at<W>(kind, i) * q.of[c];
    }
  }
}

// First the blocks of all rows, then their sums: so these stay in registers.
template <class W>
[[gnu::always_inline]] inline void diagonal_of(const CrossKind& kind, const LaneLaw<W>* laws,
                                               const LanePoints<W>* reference, std::size_t first,
                                               LaneBlock<typename W::Real>* sums,
                                               LanePoints<W>* work) {
  using Numbers = typename W::Numbers;
  auto* const blocks = reinterpret_cast<LaneBlock<typename W::Real>*>(work + kind.fine_points());
  const auto keep = [&](std::size_t r, const Vectors<W>& g) __attribute__((always_inline)) {
    Numbers square;
    Numbers w;
    Numbers only;
    dot<W>(g, g, square);
    divisor<W, true>(laws[r], square, only);
    weigh<W, true>(laws[r], square, 1 / only, w);
    const Numbers& x = g.of[0];
    const Numbers& y = g.of[1];
    const Numbers& z = g.of[2];
    at<W>(blocks[r].of[0] + first) = w * (square - x * x);
    at<W>(blocks[r].of[1] + first) = -w * x * y;
    at<W>(blocks[r].of[2] + first) = -w * x * z;
    at<W>(blocks[r].of[3] + first) = w * (square - y * y);
    at<W>(blocks[r].of[4] + first) = -w * y * z;
    at<W>(blocks[r].of[5] + first) = w * (square - z * z);
  };
  for_derivatives<W>(kind, reference, first, work, keep);
  for (std::size_t c = 0; c < kind.columns; ++c) {
    Numbers sum[6] = {};
    for (const CrossKind::Entry& entry : kind.of_column[c]) {
      for (std::size_t k = 0; k < 6; ++k) {
        sum[k] +=
            static_cast<typename W::Real>(entry.square) * at<W>(blocks[entry.row].of[k] + first);
      }
    }
    for (std::size_t k = 0; k < 6; ++k) at<W>(sums[c].of[k] + first) = sum[k];
  }
}

}  // namespace

void squares_of_patches(const CrossKind& kind, const LaneVectors<double>* reference,
                        LaneNumbers* squares, LaneVectors<double>* work) {
  run_on_lanes<double>([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes<double>; l += kCount<W>) {
      squares_of<W>(kind, reference, l, squares, work);
    }
  });
}

template <class Real>
void gradient_of_patches(const CrossKind& kind, const RowLaw<Real>* laws,
                         const LaneVectors<Real>* reference, const LaneVectors<Real>* x,
                         LaneVectors<Real>* sums, LaneVectors<Real>* work) {
  run_on_lanes<Real>([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes<Real>; l += kCount<W>) {
      gradient_of<W>(kind, laws, reference, x, l, sums, work);
    }
  });
}
template void gradient_of_patches(const CrossKind&, const RowLaw<double>*,
                                  const LaneVectors<double>*, const LaneVectors<double>*,
                                  LaneVectors<double>*, LaneVectors<double>*);
template void gradient_of_patches(const CrossKind&, const RowLaw<float>*, const LaneVectors<float>*,
                                  const LaneVectors<float>*, LaneVectors<float>*,
                                  LaneVectors<float>*);

template <class Real>
void diagonal_of_patches(const CrossKind& kind, const RowLaw<Real>* laws,
                         const LaneVectors<Real>* reference, LaneBlock<Real>* sums,
                         LaneVectors<Real>* work) {
  run_on_lanes<Real>([&]<class W>(W) __attribute__((always_inline)) {
    for (std::size_t l = 0; l < kLanes<Real>; l += kCount<W>) {
      diagonal_of<W>(kind, laws, reference, l, sums, work);
    }
  });
}
template void diagonal_of_patches(const CrossKind&, const RowLaw<double>*,
                                  const LaneVectors<double>*, LaneBlock<double>*,
                                  LaneVectors<double>*);
template void diagonal_of_patches(const CrossKind&, const RowLaw<float>*, const LaneVectors<float>*,
                                  LaneBlock<float>*, LaneVectors<float>*);

}  // namespace surpass

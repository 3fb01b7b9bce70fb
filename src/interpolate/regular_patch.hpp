// The derivatives of regular bicubic patches at three by three samples, for as many as T holds:
// those inside, and those on sides 0 and 1, which count for the neighbour, too.
//
// After one refinement the samples are vertices. With s the sums of fine points weighted 1 4 1
// across, the first derivative along a line of samples is a difference of neighbours in s, the
// second one their second difference, and the third one, constant along the line, a difference of
// second ones. Lines along side 1 are those along side 0 of the patch turned over.
#pragma once

#include <array>

#include "interpolate/lanes.hpp"

namespace surpass::regular_patch {

inline constexpr std::size_t kPoints = 16;
inline constexpr std::size_t kRows = 24;

struct RowFacts {
  std::size_t order;  // from 0
  double count;
};

/// Of the rows along side 0, then once more along side 1.
inline constexpr std::array<RowFacts, kRows / 2> kHalf = {{{0, 2},
                                                           {0, 2},
                                                           {0, 2},
                                                           {0, 1},
                                                           {0, 2},
                                                           {1, 2},
                                                           {1, 2},
                                                           {1, 2},
                                                           {1, 1},
                                                           {1, 2},
                                                           {2, 6},
                                                           {2, 3}}};

/// What the rows below are to be multiplied with, by the order of the derivative.
inline constexpr std::array<double, 3> kScale = {2.0 / (12 * 64), 4.0 / (6 * 64), 8.0 / (6 * 64)};

/// Where the points of a patch, in the order in which PatchRows has them, lie in its grid of four
/// by four, row after row.
inline constexpr std::array<std::size_t, kPoints> kPlace = {5, 6, 10, 9,  8,  4,  0,  1,
                                                            2, 3, 7,  11, 15, 14, 13, 12};

// Five fine places along a line of four points, times 8; and the transposed of that.
template <class T>
[[gnu::always_inline]] inline void refine_line(const T* p, std::size_t step, T* fine,
                                               std::size_t fine_step) {
  const T& a = p[0];
  const T& b = p[step];
  const T& c = p[2 * step];
  const T& d = p[3 * step];
  fine[0] = 4 * (a + b);
  fine[fine_step] = a + 6 * b + c;
  fine[2 * fine_step] = 4 * (b + c);
  fine[3 * fine_step] = b + 6 * c + d;
  fine[4 * fine_step] = 4 * (c + d);
}
template <class T>
[[gnu::always_inline]] inline void collect_line(const T* fine, std::size_t fine_step, T* p,
                                                std::size_t step) {
  const T a = 4 * fine[0];
  const T& b = fine[fine_step];
  const T c = 4 * fine[2 * fine_step];
  const T& d = fine[3 * fine_step];
  const T e = 4 * fine[4 * fine_step];
  p[0] = a + b;
  p[step] = a + 6 * b + c + d;
  p[2 * step] = b + c + 6 * d + e;
  p[3 * step] = d + e;
}

// Fine points as seen along one of the two sides: five lines of five.
template <int kOrigin, int kAlong, int kAcross>
struct View {
  static constexpr std::size_t at(int i, int j) {
    const int place = kOrigin + kAlong * i + kAcross * j;
    return static_cast<std::size_t>(place);
  }
};
using AlongSide0 = View<0, 1, 5>;
using AlongSide1 = View<24, -5, -1>;

// sum = of the line's fine points at i, 1 4 1 across, from `kFrom` on. The place is a constant, so
// that fine points that are not in an array are found without a search.
template <class V, int kAt, int kFrom, class Fine, class T>
[[gnu::always_inline]] inline void add_across(const Fine& f, T& sum) {
  sum = f[V::at(kAt, kFrom)] + 4 * f[V::at(kAt, kFrom + 1)] + f[V::at(kAt, kFrom + 2)];
}

// The rows that do not see the origin of the view, and s, the sums along the first line, from 1 on.
template <class V, class Fine, class T>
[[gnu::always_inline]] inline void half_rows_inside(const Fine& f, T* rows, T* s) {
  alignas(kLaneAlignment) T t[5];
  add_across<V, 1, 0>(f, s[1]);
  add_across<V, 2, 0>(f, s[2]);
  add_across<V, 3, 0>(f, s[3]);
  add_across<V, 4, 0>(f, s[4]);
  add_across<V, 1, 1>(f, t[1]);
  add_across<V, 2, 1>(f, t[2]);
  add_across<V, 3, 1>(f, t[3]);
  add_across<V, 4, 1>(f, t[4]);
  rows[1] = s[3] - s[1];
  rows[2] = s[4] - s[2];
  rows[3] = t[3] - t[1];
  rows[4] = t[4] - t[2];
  rows[6] = s[1] - 2 * s[2] + s[3];
  rows[7] = s[2] - 2 * s[3] + s[4];
  rows[8] = t[1] - 2 * t[2] + t[3];
  rows[9] = t[2] - 2 * t[3] + t[4];
  rows[11] = rows[9] - rows[8];
}

template <class V, class Fine, class T>
[[gnu::always_inline]] inline void half_rows(const Fine& f, T* rows) {
  alignas(kLaneAlignment) T s[5];
  half_rows_inside<V>(f, rows, s);
  add_across<V, 0, 0>(f, s[0]);
  rows[0] = s[2] - s[0];
  rows[5] = s[0] - 2 * s[1] + s[2];
  rows[10] = rows[6] - rows[5];
}

template <class V, class T>
[[gnu::always_inline]] inline void collect_half(const T* r, T* f) {
  const T a = r[5] - r[10];
  const T b = r[6] + r[10];
  const T& c = r[7];
  const T d = r[8] - r[11];
  const T e = r[9] + r[11];
  alignas(kLaneAlignment) const T s[5] = {a - r[0], b - 2 * a - r[1], a + c - 2 * b + r[0] - r[2],
                                          b - 2 * c + r[1], c + r[2]};
  alignas(kLaneAlignment)
      const T t[5] = {{}, d - r[3], e - 2 * d - r[4], d - 2 * e + r[3], e + r[4]};
  for (int i = 0; i < 5; ++i) {
    f[V::at(i, 0)] += s[i];
    f[V::at(i, 1)] += 4 * s[i];
    f[V::at(i, 2)] += s[i];
  }
  for (int i = 1; i < 5; ++i) {
    f[V::at(i, 1)] += t[i];
    f[V::at(i, 2)] += 4 * t[i];
    f[V::at(i, 3)] += t[i];
  }
}

// The same two where the origin of the view is an irregular corner: rows 0 and 5 are not there, and
// row 10 is the third derivative beyond it.
template <class V, class Fine, class T>
[[gnu::always_inline]] inline void half_rows_beyond(const Fine& f, T* rows) {
  alignas(kLaneAlignment) T s[5];
  half_rows_inside<V>(f, rows, s);
  rows[10] = rows[7] - rows[6];
}

template <class V, class T>
[[gnu::always_inline]] inline void collect_half_beyond(const T* r, T* f) {
  const T b = r[6] - r[10];
  const T c = r[7] + r[10];
  const T d = r[8] - r[11];
  const T e = r[9] + r[11];
  alignas(kLaneAlignment)
      const T s[5] = {{}, b - r[1], c - 2 * b - r[2], b - 2 * c + r[1], c + r[2]};
  alignas(kLaneAlignment)
      const T t[5] = {{}, d - r[3], e - 2 * d - r[4], d - 2 * e + r[3], e + r[4]};
  for (int i = 1; i < 5; ++i) {
    f[V::at(i, 0)] += s[i];
    f[V::at(i, 1)] += 4 * s[i] + t[i];
    f[V::at(i, 2)] += s[i] + 4 * t[i];
    f[V::at(i, 3)] += t[i];
  }
}

// The third derivative of the line in the middle, before that of row 11. They differ where a corner
// of the patch is irregular.
template <class V, class Fine, class T>
[[gnu::always_inline]] inline void third_before(const Fine& f, T& row) {
  alignas(kLaneAlignment) T t[4];
  add_across<V, 0, 1>(f, t[0]);
  add_across<V, 1, 1>(f, t[1]);
  add_across<V, 2, 1>(f, t[2]);
  add_across<V, 3, 1>(f, t[3]);
  row = 3 * (t[1] - t[2]) + (t[3] - t[0]);
}
template <class V, class T>
[[gnu::always_inline]] inline void collect_third_before(const T& row, T* f) {
  constexpr typename NumberOf<T>::Type kThird[4] = {-1, 3, -3, 1};
  for (int i = 0; i < 4; ++i) {
    const T t = kThird[i] * row;
    f[V::at(i, 1)] += t;
    f[V::at(i, 2)] += 4 * t;
    f[V::at(i, 3)] += t;
  }
}

/// points, kPoints in the order of the grid -> rows, kRows.
template <class T>
[[gnu::always_inline]] inline void derivatives(const T* points, T* rows) {
  alignas(kLaneAlignment) T lines[4 * 5];
  alignas(kLaneAlignment) T fine[5 * 5];
  for (std::size_t j = 0; j < 4; ++j) refine_line(points + 4 * j, 1, lines + 5 * j, 1);
  for (std::size_t i = 0; i < 5; ++i) refine_line(lines + i, 5, fine + i, 5);
  half_rows<AlongSide0>(fine, rows);
  half_rows<AlongSide1>(fine, rows + kRows / 2);
}

/// The transposed: points = the sum over rows of the row's weights times `rows`.
template <class T>
[[gnu::always_inline]] inline void collect(const T* rows, T* points) {
  alignas(kLaneAlignment) T fine[5 * 5] = {};
  alignas(kLaneAlignment) T lines[4 * 5];
  collect_half<AlongSide0>(rows, fine);
  collect_half<AlongSide1>(rows + kRows / 2, fine);
  for (std::size_t i = 0; i < 5; ++i) collect_line(fine + i, 5, lines + i, 5);
  for (std::size_t j = 0; j < 4; ++j) collect_line(lines + 5 * j, 1, points + 4 * j, 1);
}

}  // namespace surpass::regular_patch

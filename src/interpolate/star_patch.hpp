// The derivatives of a star of bicubic patches (scheme/patch_star.hpp) at three by three samples of
// each, as regular_patch has them for one patch: after one refinement they are differences, now of
// fine points that the patches have in common. A centre of another valence than 4 leaves three of
// a patch's rows different.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "interpolate/regular_patch.hpp"

namespace surpass::star_patch {

inline constexpr std::size_t kMostFaces = 16;
/// Control points and fine points a face, besides the centre, which comes first.
inline constexpr std::size_t kPoints = 6;
inline constexpr std::size_t kFine = 12;

/// A patch has regular_patch's rows. But where the centre is irregular the first one, at the
/// centre, is not told by the fine points; and on the lines in the middle there are two third
/// derivatives, so that one comes in the place of the second derivative at the centre, and one more
/// at the end.
inline constexpr std::size_t kAtCentre = 0;
inline constexpr std::size_t kThirdAlong0 = 5;
inline constexpr std::size_t kThirdAlong1 = regular_patch::kRows;
inline constexpr std::size_t kMostRows = regular_patch::kRows + 1;
[[nodiscard]] constexpr std::size_t row_count(bool regular) {
  return regular ? regular_patch::kRows : kMostRows;
}
/// Of its derivative, from 0.
[[nodiscard]] constexpr std::size_t order_of_row(std::size_t row, bool regular) {
  if (!regular && (row == kThirdAlong0 || row == kThirdAlong1)) return 2;
  return regular_patch::kHalf[row % regular_patch::kHalf.size()].order;
}

/// The faces of a star, by number, and those beside them.
struct Faces {
  std::size_t count;
  [[nodiscard]] std::size_t after(std::size_t k) const { return k + 1 < count ? k + 1 : 0; }
  [[nodiscard]] std::size_t before(std::size_t k) const { return (k > 0 ? k : count) - 1; }
};

// Vertices of a refined mesh are sums over those of the coarse one and of the sums over faces:
// times 64, 16 at faces; 16 and 4 on edges; 32, 4 and 1 at regular vertices.

/// Fine points times 64: the centre, then of each face those at (1, 0), (1, 1), (2, 0), (2, 1),
/// (2, 2), (1, 2), (3, 0), (3, 1), (3, 2), (3, 3), (2, 3) and (1, 3), in halves of its sides.
/// p(i): control point i; fine(i): a place for fine point i.
template <class T, class Points, class Fine>
[[gnu::always_inline]] inline void refine(Faces faces, Points&& p, Fine&& fine) {
  const std::size_t n = faces.count;
  alignas(kLaneAlignment) T inner[kMostFaces];  // sums over faces: at the centre,
  alignas(kLaneAlignment) T above[kMostFaces];  // and across the side 2 of these
  T spokes = {};
  T sums = {};
  const T centre = p(0);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at = 1 + kPoints * k;
    const std::size_t next = 1 + kPoints * faces.after(k);
    const T side = p(at + 1) + p(next);
    inner[k] = centre + p(at) + side;
    above[k] = side + p(at + 5) + p(next + 2);
    spokes += p(at);
    sums += inner[k];
  }
  const auto count = static_cast<typename NumberOf<T>::Type>(n);
  fine(0) = 64 * (count - 2) / count * centre + 64 / (count * count) * spokes +
            16 / (count * count) * sums;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t b = faces.before(k);
    const std::size_t at = 1 + kPoints * k;
    const std::size_t to = 1 + kFine * k;
    const T e = p(at);
    const T f = p(at + 1);
    const T outer = p(at + 2);
    const T corner_before = p(at + 3);
    const T corner_after = p(at + 5);
    const T e_next = p(1 + kPoints * faces.after(k));
    const T f_before = p(1 + kPoints * b + 1);
    const T right = e + outer + corner_before + f;
    const T corner = f + corner_before + p(at + 4) + corner_after;
    fine(to) = 16 * (centre + e) + 4 * (inner[k] + inner[b]);
    fine(to + 1) = 16 * inner[k];
    fine(to + 2) =
        32 * e + 4 * (centre + outer + f + f_before) + (inner[k] + inner[b] + right + above[b]);
    fine(to + 3) = 16 * (e + f) + 4 * (inner[k] + right);
    fine(to + 4) = 32 * f + 4 * (e + corner_before + corner_after + e_next) +
                   (inner[k] + right + corner + above[k]);
    fine(to + 5) = 16 * (f + e_next) + 4 * (inner[k] + above[k]);
    fine(to + 6) = 16 * (e + outer) + 4 * (right + above[b]);
    fine(to + 7) = 16 * right;
    fine(to + 8) = 16 * (f + corner_before) + 4 * (right + corner);
    fine(to + 9) = 16 * corner;
    fine(to + 10) = 16 * (f + corner_after) + 4 * (corner + above[k]);
    fine(to + 11) = 16 * above[k];
  }
}

/// The transposed: p(i) becomes the sum over fine points of the weight of control point i in each.
template <class T, class Fine, class Points>
[[gnu::always_inline]] inline void collect(Faces faces, Fine&& fine, Points&& p) {
  const std::size_t n = faces.count;
  const auto count = static_cast<typename NumberOf<T>::Type>(n);
  const T centre = fine(0);
  const T of_spokes = 64 / (count * count) * centre;
  const T of_sums = 16 / (count * count) * centre;
  T at_centre = 64 * (count - 2) / count * centre;
  alignas(kLaneAlignment) T inner[kMostFaces];
  alignas(kLaneAlignment) T above[kMostFaces];
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at = 1 + kFine * k;
    const std::size_t next = 1 + kFine * faces.after(k);
    const T both = fine(next + 2) + fine(at + 4) + 4 * fine(at + 5);
    inner[k] = 4 * (fine(at) + fine(next) + fine(at + 3)) + 16 * fine(at + 1) + fine(at + 2) +
               both + of_sums;
    above[k] = both + 4 * (fine(next + 6) + fine(at + 10)) + 16 * fine(at + 11);
    at_centre += 16 * fine(at) + 4 * fine(at + 2) + inner[k];
  }
  p(0) = at_centre;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t b = faces.before(k);
    const std::size_t at = 1 + kFine * k;
    const std::size_t before = 1 + kFine * b;
    const std::size_t next = 1 + kFine * faces.after(k);
    const std::size_t to = 1 + kPoints * k;
    const T right = fine(at + 2) + 4 * (fine(at + 3) + fine(at + 6) + fine(at + 8)) + fine(at + 4) +
                    16 * fine(at + 7);
    const T corner = fine(at + 4) + 4 * (fine(at + 8) + fine(at + 10)) + 16 * fine(at + 9);
    const T outer = right + above[b];
    p(to) = 16 * (fine(at) + fine(at + 3) + fine(before + 5) + fine(at + 6)) + 32 * fine(at + 2) +
            4 * (fine(at + 4) + fine(before + 4)) + of_spokes + inner[k] + inner[b] + outer;
    p(to + 1) = 4 * (fine(at + 2) + fine(next + 2)) +
                16 * (fine(at + 3) + fine(at + 5) + fine(at + 8) + fine(at + 10)) +
                32 * fine(at + 4) + inner[k] + right + corner + above[k];
    p(to + 2) = 4 * fine(at + 2) + 16 * fine(at + 6) + outer;
    p(to + 3) = 4 * fine(at + 4) + 16 * fine(at + 8) + right + corner;
    p(to + 4) = corner;
    p(to + 5) = 4 * fine(at + 4) + 16 * fine(at + 10) + corner + above[k];
  }
}

/// Of the places of a patch's five by five fine points, those that rows of a star's patches
/// need.
inline constexpr std::array<std::size_t, 24> kPlaces = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 21, 22, 23, 24};

/// use(place) for each of them, a constant once this is compiled.
template <class Use>
[[gnu::always_inline]] inline void for_places(Use&& use) {
  [&]<std::size_t... kAt>(std::index_sequence<kAt...>) __attribute__((always_inline)) {
    (use(kPlaces[kAt]), ...);
  }
  (std::make_index_sequence<kPlaces.size()>());
}

/// The star's fine points at the places of a patch's.
class Window {
 public:
  [[gnu::always_inline]] Window(Faces faces, std::size_t k)
      : own_(1 + kFine * k),
        before_(1 + kFine * faces.before(k)),
        next_(1 + kFine * faces.after(k)),
        across_(1 + kFine * faces.after(faces.after(k))) {}

  /// To be called with constants: then there is nothing to choose.
  [[nodiscard, gnu::always_inline]] std::size_t fine(std::size_t place) const {
    switch (place) {
      case 0: return across_ + 1;
      case 1: return before_;
      case 2: return before_ + 1;
      case 3: return before_ + 5;
      case 4: return before_ + 11;
      case 5: return across_;
      case 7: return own_;
      case 8: return own_ + 2;
      case 9: return own_ + 6;
      case 10: return next_ + 1;
      case 11: return next_;
      case 12: return own_ + 1;
      case 13: return own_ + 3;
      case 14: return own_ + 7;
      case 15: return next_ + 3;
      case 16: return next_ + 2;
      case 17: return own_ + 5;
      case 18: return own_ + 4;
      case 19: return own_ + 8;
      case 21: return next_ + 6;
      case 22: return own_ + 11;
      case 23: return own_ + 10;
      case 24: return own_ + 9;
      default: return 0;  // 6, the centre
    }
  }

 private:
  std::size_t own_;
  std::size_t before_;
  std::size_t next_;
  std::size_t across_;
};

/// The rows of a patch from its fine points, as regular_patch::derivatives() ends; those that are
/// not told are left as they are.
template <class Fine, class T>
[[gnu::always_inline]] inline void rows_of_patch(const Fine& window, bool regular, T* rows) {
  regular_patch::half_rows<regular_patch::AlongSide1>(window, rows + regular_patch::kRows / 2);
  if (regular) return regular_patch::half_rows<regular_patch::AlongSide0>(window, rows);
  regular_patch::half_rows_beyond<regular_patch::AlongSide0>(window, rows);
  regular_patch::third_before<regular_patch::AlongSide0>(window, rows[kThirdAlong0]);
  regular_patch::third_before<regular_patch::AlongSide1>(window, rows[kThirdAlong1]);
}

/// The transposed; adds to the window.
template <class T>
[[gnu::always_inline]] inline void collect_patch(const T* rows, bool regular, T* window) {
  regular_patch::collect_half<regular_patch::AlongSide1>(rows + regular_patch::kRows / 2, window);
  if (regular) return regular_patch::collect_half<regular_patch::AlongSide0>(rows, window);
  regular_patch::collect_half_beyond<regular_patch::AlongSide0>(rows, window);
  regular_patch::collect_third_before<regular_patch::AlongSide0>(rows[kThirdAlong0], window);
  regular_patch::collect_third_before<regular_patch::AlongSide1>(rows[kThirdAlong1], window);
}

}  // namespace surpass::star_patch

// The rows of a kind of patch as the kernels of directions want them: which of them refinement
// finds, and in which order.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "interpolate/cross_kernels.hpp"
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

using WeightRows = std::vector<std::vector<double>>;

// The weights of regular_patch::derivatives() over the columns of a PatchKind, with their scale.
WeightRows regular_rows() {
  WeightRows rows(regular_patch::kRows, std::vector<double>(regular_patch::kPoints));
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
WeightRows star_rows(star_patch::Faces faces) {
  const std::size_t points = 1 + star_patch::kPoints * faces.count;
  const bool regular = faces.count == 4;
  const std::size_t count = star_patch::row_count(regular);
  WeightRows rows(count * faces.count, std::vector<double>(points));
  std::vector<double> fine(1 + star_patch::kFine * faces.count);
  for (std::size_t c = 0; c < points; ++c) {
    star_patch::refine<double>(
        faces, [&](std::size_t i) { return i == c ? 1.0 : 0.0; },
        [&](std::size_t i) -> double& { return fine[i]; });
    for (std::size_t k = 0; k < faces.count; ++k) {
      const star_patch::Window places(faces, k);
      double window[25] = {};
      double found[star_patch::kMostRows] = {};
      star_patch::for_places([&](std::size_t i) { window[i] = fine[places.fine(i)]; });
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
  constexpr double kNegligible = 1e-12;
  double plus = 0;
  double minus = 0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    plus = std::max(plus, std::abs(a[c] - b[c]));
    minus = std::max(minus, std::abs(a[c] + b[c]));
  }
  return std::min(plus, minus) < kNegligible;
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
    of_column[c].push_back({rows.size(), w / scale * (w / scale)});
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

CrossKind::CrossKind(const PatchKind& kind) : columns(kind.columns), of_column(kind.columns) {
  if (add_star(kind)) return;
  const std::vector<std::size_t> order = regular_order(kind);
  is_regular = !order.empty();
  for (const std::size_t r : is_regular ? order : without_mixed(kind, 0, kind.row_count())) {
    add(kind, r, is_regular ? regular_patch::kScale[order_of(kind.derivative[r])] : 1.0);
  }
}

std::size_t CrossKind::fine_points() const { return star == 0 ? 0 : 1 + star_patch::kFine * star; }

std::vector<RowLaw<double>> scaled_laws(const CrossKind& kind,
                                        const std::vector<RowLaw<double>>& laws) {
  std::vector<RowLaw<double>> scaled;
  for (std::size_t r = 0; r < laws.size(); ++r) {
    const double square = kind.rows[r].scale * kind.rows[r].scale;
    scaled.push_back({laws[r].numerator * square * square, laws[r].slope * square, laws[r].constant,
                      laws[r].threshold / square});
  }
  return scaled;
}

}  // namespace surpass

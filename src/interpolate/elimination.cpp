#include "interpolate/elimination.hpp"

#include <algorithm>
#include <cmath>

namespace surpass {

Result<Elimination> Elimination::build(SparseRows limits, Index control_points,
                                       const Context& context,
                                       std::span<const unsigned char> released) {
  Elimination e;
  e.limits_ = std::move(limits);
  const Index n = e.given_count();
  std::vector<unsigned char> uses(control_points, 0);  // none, one, more
  for (Index i = 0; i < n; ++i) {
    for (const Index j : e.limits_.row_columns(i)) uses[j] = uses[j] == 0 ? 1 : 2;
  }
  e.dependent_.assign(n, kNone);
  e.pivot_.assign(n, 0.0);
  e.given_of_.assign(control_points, kNone);
  std::vector<Index> stuck;  // rows without a column of their own
  for (Index i = 0; i < n; ++i) {
    if (!released.empty() && released[i] != 0) continue;
    for (Index k = 0; k < e.limits_.row_length(i); ++k) {
      const Index j = e.limits_.row_columns(i)[k];
      const double weight = e.limits_.row_weights(i)[k];
      if (uses[j] != 1 || std::abs(weight) <= std::abs(e.pivot_[i])) continue;
      e.dependent_[i] = j;
      e.pivot_[i] = weight;
    }
    if (e.dependent_[i] == kNone) {
      stuck.push_back(i);
    } else {
      e.given_of_[e.dependent_[i]] = i;
    }
  }
  if (!stuck.empty()) {
    if (auto ok = e.couple(stuck); !ok) return tl::make_unexpected(ok.error());
  }
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while setting up");
  e.find_dependents_of_free();
  return e;
}

Result<void> Elimination::couple(const std::vector<Index>& stuck) {
  for (const Index i : stuck) {
    for (Index k = 0; k < limits_.row_length(i); ++k) {
      const Index j = limits_.row_columns(i)[k];
      const double weight = limits_.row_weights(i)[k];
      if (given_of_[j] != kNone || std::abs(weight) <= std::abs(pivot_[i])) continue;
      dependent_[i] = j;
      pivot_[i] = weight;
    }
    if (dependent_[i] != kNone) given_of_[dependent_[i]] = i;
  }
  // They, and those that have what they depend on.
  std::vector<unsigned char> taken(control_count(), 0);
  for (const Index i : stuck) {
    if (dependent_[i] != kNone) taken[dependent_[i]] = 1;
  }
  std::vector<Index> together;
  std::vector<Index> pivots;
  for (Index i = 0; i < given_count(); ++i) {
    if (dependent_[i] == kNone) continue;
    const auto columns = limits_.row_columns(i);
    const bool has =
        std::any_of(columns.begin(), columns.end(), [&](Index j) { return taken[j] != 0; });
    if (!has) continue;
    together.push_back(i);
    pivots.push_back(dependent_[i]);
  }
  const bool all =
      std::all_of(stuck.begin(), stuck.end(), [&](Index i) { return dependent_[i] != kNone; });
  if (all) coupled_ = coupled_rows(limits_, together, pivots, control_count());
  if (coupled_.empty()) {
    return fail(ErrorCode::singular,
                "every control point that decides this vertex's limit also decides another's",
                {.vertex = stuck.front()});
  }
  coupled_number_.assign(given_count(), kNone);
  for (std::size_t k = 0; k < together.size(); ++k) {
    coupled_number_[together[k]] = static_cast<Index>(k);
  }
  return {};
}

void Elimination::find_dependents_of_free() {
  starts_.assign(given_of_.size() + 1, 0);
  const auto for_all = [&](auto&& use) {
    for (Index i = 0; i < given_count(); ++i) {
      for_each_coefficient(i, [&](Index j, double c) { use(i, j, c); });
    }
  };
  for_all([&](Index, Index j, double) { ++starts_[j + 1]; });
  for (std::size_t j = 1; j < starts_.size(); ++j) starts_[j] += starts_[j - 1];
  dependents_.resize(starts_.back());
  coefficients_.resize(starts_.back());
  std::vector<Index> at(starts_.begin(), starts_.end() - 1);
  for_all([&](Index i, Index j, double c) {
    dependents_[at[j]] = dependent_[i];
    coefficients_[at[j]++] = c;
  });
}

namespace {

// to = own, and what is missing of it.
void meet_coupled(const CoupledRow& row, std::size_t width, std::span<const double> targets,
                  const double* own, std::span<const double> x, double* to) {
  std::fill_n(to, width, 0.0);
  for (const auto& [i, share] : row.shares) {
    for (std::size_t c = 0; c < width && !targets.empty(); ++c) {
      to[c] += share * (targets[i * width + c] - own[c]);
    }
  }
  for (const auto& [j, w] : row.others) {
    for (std::size_t c = 0; c < width; ++c) to[c] -= w * (x[j * width + c] - own[c]);
  }
  for (std::size_t c = 0; c < width; ++c) to[c] += own[c];
}

}  // namespace

// A row's weights sum to one. So all can be said of differences to the row's own target, which far
// from the origin are exact where the numbers themselves would be rounded.
//
// For three numbers a point, the case that matters: the sums stay in registers.
void Elimination::meet_3(Index i, const double* own, std::span<double> x) const {
  const auto columns = limits_.row_columns(i);
  const auto weights = limits_.row_weights(i);
  double rest[3] = {};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k] == dependent_[i]) continue;
    const double* other = &x[std::size_t{3} * columns[k]];
    for (std::size_t c = 0; c < 3; ++c) rest[c] -= weights[k] * (other[c] - own[c]);
  }
  double* to = &x[std::size_t{3} * dependent_[i]];
  for (std::size_t c = 0; c < 3; ++c) to[c] = own[c] + rest[c] / pivot_[i];
}

void Elimination::meet(const Context& context, std::size_t width, std::span<const double> targets,
                       std::span<double> x) const {
  parallel::for_ranges(context, given_count(), [&](std::size_t begin, std::size_t end) {
    std::vector<double> rest(width);
    const std::vector<double> zero(width, 0.0);
    for (std::size_t i = begin; i < end; ++i) {
      if (dependent_[i] == kNone) continue;
      const auto row = static_cast<Index>(i);
      const double* own = targets.empty() ? zero.data() : &targets[i * width];
      double* to = &x[dependent_[i] * width];
      if (const CoupledRow* terms = coupled(row)) {
        meet_coupled(*terms, width, targets, own, x, to);
        continue;
      }
      if (width == 3) {
        meet_3(row, own, x);
        continue;
      }
      std::fill(rest.begin(), rest.end(), 0.0);
      const auto columns = limits_.row_columns(row);
      const auto weights = limits_.row_weights(row);
      for (std::size_t k = 0; k < columns.size(); ++k) {
        if (columns[k] == dependent_[i]) continue;
        const double* other = &x[columns[k] * width];
        for (std::size_t c = 0; c < width; ++c) rest[c] -= weights[k] * (other[c] - own[c]);
      }
      for (std::size_t c = 0; c < width; ++c) to[c] = own[c] + rest[c] / pivot_[i];
    }
  });
}

void Elimination::restrict_gradient(const Context& context, std::size_t width,
                                    std::span<double> y) const {
  // Free points read dependent ones only, so that nothing is read that is written.
  parallel::for_ranges(context, control_count(), [&](std::size_t begin, std::size_t end) {
    std::vector<double> sum(width);
    for (std::size_t j = begin; j < end; ++j) {
      if (!is_free(static_cast<Index>(j))) continue;
      restricted<0>(j, width, y.data(), sum.data());
      std::copy(sum.begin(), sum.end(), y.data() + j * width);
    }
  });
  parallel::for_ranges(context, given_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (dependent_[i] != kNone) std::fill_n(&y[dependent_[i] * width], width, 0.0);
    }
  });
}

}  // namespace surpass

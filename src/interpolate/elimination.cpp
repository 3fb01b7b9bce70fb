#include "interpolate/elimination.hpp"

#include <cmath>

namespace surpass {

Result<Elimination> Elimination::build(SparseRows limits, Index control_points,
                                       const Context& context) {
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
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < e.limits_.row_length(i); ++k) {
      const Index j = e.limits_.row_columns(i)[k];
      const double weight = e.limits_.row_weights(i)[k];
      if (uses[j] != 1 || std::abs(weight) <= std::abs(e.pivot_[i])) continue;
      e.dependent_[i] = j;
      e.pivot_[i] = weight;
    }
    if (e.dependent_[i] == kNone) {
      return fail(ErrorCode::singular,
                  "every control point that decides this vertex's limit also decides another's",
                  {.vertex = i});
    }
    e.given_of_[e.dependent_[i]] = i;
  }
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while setting up");
  e.find_dependents_of_free();
  return e;
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
  givens_.resize(starts_.back());
  coefficients_.resize(starts_.back());
  std::vector<Index> at(starts_.begin(), starts_.end() - 1);
  for_all([&](Index i, Index j, double c) {
    givens_[at[j]] = i;
    coefficients_[at[j]++] = c;
  });
}

void Elimination::meet(const Context& context, std::size_t width, std::span<const double> targets,
                       std::span<double> x) const {
  parallel::for_ranges(context, given_count(), [&](std::size_t begin, std::size_t end) {
    std::vector<double> rest(width);
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<Index>(i);
      for (std::size_t c = 0; c < width; ++c) {
        rest[c] = targets.empty() ? 0 : targets[i * width + c];
      }
      const auto columns = limits_.row_columns(row);
      const auto weights = limits_.row_weights(row);
      for (std::size_t k = 0; k < columns.size(); ++k) {
        if (columns[k] == dependent_[i]) continue;
        for (std::size_t c = 0; c < width; ++c) rest[c] -= weights[k] * x[columns[k] * width + c];
      }
      for (std::size_t c = 0; c < width; ++c) x[dependent_[i] * width + c] = rest[c] / pivot_[i];
    }
  });
}

void Elimination::restrict_gradient(const Context& context, std::size_t width,
                                    std::span<double> y) const {
  // Free points read dependent ones only, so that nothing is read that is written.
  parallel::for_ranges(context, given_of_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      for (Index k = starts_[j]; k < starts_[j + 1]; ++k) {
        const std::size_t from = dependent_[givens_[k]] * width;
        for (std::size_t c = 0; c < width; ++c) y[j * width + c] += coefficients_[k] * y[from + c];
      }
    }
  });
  parallel::for_ranges(context, given_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t c = 0; c < width; ++c) y[dependent_[i] * width + c] = 0;
    }
  });
}

}  // namespace surpass

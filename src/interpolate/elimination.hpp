// Interpolation as an explicit requirement: one control point of every given vertex's limit mean is
// expressed by the others (Lai and Cheng 2006, equation 1).
#pragma once

#include <span>
#include <vector>

#include "interpolate/coupled_rows.hpp"

namespace surpass {

/// Arrays are #control points by width, row after row. Free points are those that no given vertex
/// depends on for its own sake.
class Elimination {
 public:
  /// `limits`: a row per given vertex over `control_points` columns. In each row the largest weight
  /// among the columns that no other row has becomes the dependent one. Rows without such a column
  /// take the largest that no row has taken, and are solved together with those that have it; fails
  /// with `singular` if they cannot be.
  /// Vertices marked in `released` (#given, or empty: none) need not be met: they have none.
  static Result<Elimination> build(SparseRows limits, Index control_points, const Context& context,
                                   std::span<const unsigned char> released = {});

  [[nodiscard]] Index given_count() const { return limits_.row_count(); }
  [[nodiscard]] Index control_count() const { return static_cast<Index>(given_of_.size()); }
  [[nodiscard]] bool is_free(Index j) const { return given_of_[j] == kNone; }
  [[nodiscard]] const SparseRows& limits() const { return limits_; }
  /// The control point that depends on the others for the sake of given vertex i; kNone if i is
  /// released.
  [[nodiscard]] Index dependent(Index i) const { return dependent_[i]; }

  /// Sets the dependent points such that the limits are the targets (#given by width), or 0 without
  /// any.
  void meet(const Context& context, std::size_t width, std::span<const double> targets,
            std::span<double> x) const;

  /// From the derivative of a function by all control points to that by the free ones alone, of
  /// which the dependent ones follow; 0 at these.
  void restrict_gradient(const Context& context, std::size_t width, std::span<double> y) const;

  /// The same for point j alone, y left as it is: `kWidth` numbers or, for 0, as many as there are.
  template <std::size_t kWidth>
  void restricted(std::size_t j, std::size_t any_width, const double* y, double* to) const {
    const std::size_t width = kWidth == 0 ? any_width : kWidth;
    const bool free = is_free(static_cast<Index>(j));
    for (std::size_t c = 0; c < width; ++c) to[c] = free ? y[j * width + c] : 0;
    for (Index k = starts_[j]; k < starts_[j + 1]; ++k) {
      const double* from = y + dependents_[k] * width;
      for (std::size_t c = 0; c < width; ++c) to[c] += coefficients_[k] * from[c];
    }
  }

  /// The given vertex that control point j depends for, or kNone.
  [[nodiscard]] Index given_of(Index j) const { return given_of_[j]; }

  /// use(j, coefficient) for each free point j on which dependent(i) depends.
  template <class Use>
  void for_each_coefficient(Index i, Use&& use) const {
    if (dependent_[i] == kNone) return;
    if (const CoupledRow* row = coupled(i)) {
      for (const auto& [j, w] : row->others) use(j, -w);
      return;
    }
    const auto columns = limits_.row_columns(i);
    const auto weights = limits_.row_weights(i);
    const double pivot = pivot_[i];
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k] != dependent_[i]) use(columns[k], -weights[k] / pivot);
    }
  }

 private:
  [[nodiscard]] Result<void> couple(const std::vector<Index>& stuck);
  void find_dependents_of_free();
  void meet_3(Index i, const double* own, std::span<double> x) const;
  [[nodiscard]] const CoupledRow* coupled(Index i) const {
    return coupled_number_.empty() || coupled_number_[i] == kNone ? nullptr
                                                                  : &coupled_[coupled_number_[i]];
  }

  SparseRows limits_;
  std::vector<Index> dependent_;       // #given, kNone where released
  std::vector<double> pivot_;          // #given: weight of the dependent point
  std::vector<Index> given_of_;        // #control: the given vertex that it depends for, or kNone
  std::vector<Index> coupled_number_;  // #given, kNone for most; empty: for all
  std::vector<CoupledRow> coupled_;
  // The coefficients once more, by free points.
  std::vector<Index> starts_;
  std::vector<Index> dependents_;
  std::vector<double> coefficients_;
};

}  // namespace surpass

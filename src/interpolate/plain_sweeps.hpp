// The sweeps of sweeps.hpp one after the other over all rows: for rows that cannot be ordered, and
// what those over ordered rows must equal bit by bit.
#pragma once

#include <optional>
#include <vector>

#include "interpolate/sweeps.hpp"

namespace surpass {

/// See Wavefront, which has the same functions.
class PlainSweeps {
 public:
  PlainSweeps(const LinearSystem& system, std::span<const double> x);

  std::optional<SweepErrors> advance(std::span<const SweepStep> sweeps, const Tick& tick = {},
                                     std::span<double> out = {});
  void copy_measured(std::span<double> x) const;

 private:
  ErrorNorms measure(const SweepStep& step);
  [[nodiscard]] float product(Index v, std::size_t c) const;
  void sweep(const SweepStep& step);
  void move();

  const LinearSystem& system_;
  double scale_;
  bool started_ = false;
  std::vector<double> point_;      // #V by width, as all the others
  std::vector<double> residual_;   // of the point
  std::vector<float> scaled_;      // the same, times scale_
  std::vector<float> correction_;  // of the point, times scale_
  std::vector<float> older_;       // the correction before, or by how much the last sweep moved
};

}  // namespace surpass

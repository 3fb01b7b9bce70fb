#include "interpolate/plain_sweeps.hpp"

#include <utility>

#include "interpolate/ordered_rows.hpp"

namespace surpass {

PlainSweeps::PlainSweeps(const LinearSystem& system, std::span<const double> x)
    : system_(system),
      scale_(correction_scale(system)),
      point_(x.begin(), x.end()),
      residual_(x.size(), 0.0),
      scaled_(x.size(), 0.0F),
      correction_(x.size(), 0.0F),
      older_(x.size(), 0.0F) {
  system.for_values([&](std::size_t at, std::size_t) { point_[at] = system.target[at]; });
}

// The residual in double precision, and the first sweep from it: L times no correction is 0.
ErrorNorms PlainSweeps::measure(const SweepStep& step) {
  const ErrorNorms norms = system_.residual(point_, residual_);
  const auto momentum = static_cast<float>(step.momentum);
  const auto length = static_cast<float>(step.step);
  system_.for_values([&](std::size_t at, std::size_t) {
    scaled_[at] = static_cast<float>(residual_[at] * scale_);
    correction_[at] = momentum * older_[at] + length * scaled_[at];
    older_[at] = 0;
  });
  return norms;
}

// Row v times right-hand side c of the correction.
float PlainSweeps::product(Index v, std::size_t c) const {
  const RowView row = system_.op.rows.row(v);
  const std::size_t length = row.columns.size();
  const auto weight = [&](std::size_t k) { return static_cast<float>(row.weights[k]); };
  const auto value = [&](std::size_t k) { return correction_[row.columns[k] * system_.width + c]; };
  if (weights_alike(system_.op.rows.row_weights(v))) {
    float sum = value(1);
    for (std::size_t k = 2; k < length; ++k) sum += value(k);
    return weight(0) * value(0) + weight(1) * sum;
  }
  float sum = weight(0) * value(0);
  for (std::size_t k = 1; k < length; ++k) sum += weight(k) * value(k);
  return sum;
}

void PlainSweeps::sweep(const SweepStep& step) {
  const auto momentum = static_cast<float>(step.momentum);
  const auto length = static_cast<float>(step.step);
  system_.for_values([&](std::size_t at, std::size_t c) {
    const float product_at = product(static_cast<Index>(at / system_.width), c);
    const float z = correction_[at];
    older_[at] = z + momentum * (z - older_[at]) + length * (scaled_[at] - product_at);
  });
  std::swap(correction_, older_);
}

void PlainSweeps::move() {
  system_.for_values([&](std::size_t at, std::size_t) {
    point_[at] += static_cast<double>(correction_[at]) * (1 / scale_);
    older_[at] = correction_[at] - older_[at];
  });
}

std::optional<SweepErrors> PlainSweeps::advance(std::span<const SweepStep> sweeps, const Tick& tick,
                                                std::span<double> out) {
  SweepErrors errors;
  std::size_t k = 0;
  if (!started_) errors.start = errors.last = measure(sweeps[k++]);
  started_ = true;
  if (k == sweeps.size()) return errors;
  for (; k + 1 < sweeps.size(); ++k) {
    if (system_.context.cancelled()) return std::nullopt;
    if (tick) tick(static_cast<double>(k) / static_cast<double>(sweeps.size()));
    sweep(sweeps[k]);
  }
  move();
  errors.last = measure(sweeps.back());
  if (!out.empty()) copy_measured(out);
  return errors;
}

void PlainSweeps::copy_measured(std::span<double> x) const {
  system_.for_values([&](std::size_t at, std::size_t) { x[at] = point_[at]; });
}

}  // namespace surpass

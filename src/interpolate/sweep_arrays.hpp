// What the sweeps over ordered rows work on, kept for the next solve.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>

namespace surpass {

/// In double precision the target and a point, in single precision the point's residual and two
/// corrections of it, which take turns.
struct SweepArrays {
  std::size_t size = 0;  ///< numbers that each has
  std::unique_ptr<double[]> target = nullptr;
  std::unique_ptr<double[]> point = nullptr;
  std::unique_ptr<float[]> residual = nullptr;
  std::array<std::unique_ptr<float[]>, 2> corrections = {};

  /// Nothing is cleared: fresh memory costs more to touch than to fill.
  static SweepArrays of(std::size_t size) {
    const auto make = [&] { return std::make_unique_for_overwrite<float[]>(size); };
    return {size,
            std::make_unique_for_overwrite<double[]>(size),
            std::make_unique_for_overwrite<double[]>(size),
            make(),
            {make(), make()}};
  }
};

/// Hands out the arrays of one block and takes them back: memory that was used before costs
/// nothing, fresh memory as much as a few sweeps. They are kept from the second time on, as most
/// topologies are solved on once and what follows needs the memory. Solves at the same time get
/// arrays of their own.
class SpareArrays {
 public:
  [[nodiscard]] SweepArrays take(std::size_t size) {
    {
      const std::lock_guard lock(mutex_);
      ++taken_;
      if (kept_.size == size) return std::exchange(kept_, {});
    }
    return SweepArrays::of(size);
  }
  void give_back(SweepArrays arrays) {
    const std::lock_guard lock(mutex_);
    if (taken_ > 1) kept_ = std::move(arrays);
  }

 private:
  std::mutex mutex_;
  std::size_t taken_ = 0;
  SweepArrays kept_;
};

}  // namespace surpass

// What the sweeps over ordered rows work on, kept for the next solve.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

namespace surpass {

/// Numbers, not cleared, that start at a chosen place of a page of memory. Processors tell a load
/// from what was just stored by the last twelve bits of the addresses: where two arrays that are
/// walked through together start at nearly the same place, a load from one waits for the store to
/// the other. In WebAssembly that made sweeps three times as long, or not, as the heap happened to
/// be.
class PlacedNumbers {
 public:
  static constexpr std::size_t kPage = 4096 / sizeof(double);

  PlacedNumbers() = default;
  PlacedNumbers(std::size_t size, std::size_t place)
      : memory_(std::make_unique_for_overwrite<double[]>(size + kPage)) {
    const auto at = reinterpret_cast<std::uintptr_t>(memory_.get()) / sizeof(double) % kPage;
    first_ = memory_.get() + (kPage + place - at) % kPage;
  }
  [[nodiscard]] double* get() const { return first_; }

 private:
  std::unique_ptr<double[]> memory_ = nullptr;
  double* first_ = nullptr;
};

/// The target and two points of a semi-iteration, which is all that it needs of them.
struct SweepArrays {
  std::size_t size = 0;  ///< numbers that each has
  PlacedNumbers target = {};
  std::array<PlacedNumbers, 2> points = {};

  /// Nothing is cleared: fresh memory costs more to touch than to fill.
  static SweepArrays of(std::size_t size) {
    constexpr std::size_t kApart = 160;  // well away from each other, also round the page's end
    return {size, {size, 0}, {PlacedNumbers(size, kApart), PlacedNumbers(size, 2 * kApart)}};
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

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
template <class T>
class PlacedNumbers {
 public:
  PlacedNumbers() = default;
  /// `place`: in bytes, a multiple of the size of a number.
  PlacedNumbers(std::size_t size, std::size_t place)
      : memory_(std::make_unique_for_overwrite<T[]>(size + kPage / sizeof(T))) {
    const auto at = reinterpret_cast<std::uintptr_t>(memory_.get()) % kPage;
    first_ = memory_.get() + (kPage + place - at) % kPage / sizeof(T);
  }
  [[nodiscard]] T* get() const { return first_; }
  [[nodiscard]] T& operator[](std::size_t i) const { return first_[i]; }

 private:
  static constexpr std::size_t kPage = 4096;

  std::unique_ptr<T[]> memory_ = nullptr;
  T* first_ = nullptr;
};

/// In double precision the target and a point, in single precision the point's residual and two
/// corrections of it, which take turns.
struct SweepArrays {
  std::size_t size = 0;  ///< numbers that each has
  PlacedNumbers<double> target = {};
  PlacedNumbers<double> point = {};
  PlacedNumbers<float> residual = {};
  std::array<PlacedNumbers<float>, 2> corrections = {};

  /// Nothing is cleared: fresh memory costs more to touch than to fill.
  static SweepArrays of(std::size_t size) {
    constexpr std::size_t kApart = 768;  // well away from each other, also round the page's end
    return {size,
            {size, 0},
            {size, kApart},
            {size, 2 * kApart},
            {PlacedNumbers<float>(size, 3 * kApart), PlacedNumbers<float>(size, 4 * kApart)}};
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

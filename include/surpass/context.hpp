// What a long computation is told and tells: threads, progress, cancellation.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string_view>

namespace surpass {

/// A snapshot of a running computation.
struct Progress {
  std::string_view stage;       ///< "topology", "solve", ...
  double fraction = 0;          ///< done, 0 to 1; an estimate while iterating
  std::uint64_t iteration = 0;  ///< 0 outside iterations
  double error = 0;             ///< while iterating: the largest one now, relative to the box side
  /// Instead, of methods that interpolate from the start (SimilarityInterpolator): the length of
  /// what is to vanish, relative to that at the start.
  double residual = 0;
};

/// Passed by const reference; the defaults are silent and use every core.
/// The result of a computation does not depend on anything in here.
struct Context {
  int threads = 0;  ///< 0 = all cores
  std::function<void(const Progress&)> progress = {};
  const std::atomic<bool>* cancel = nullptr;  ///< set it from any thread to stop with `cancelled`

  [[nodiscard]] bool cancelled() const {
    return cancel != nullptr && cancel->load(std::memory_order_relaxed);
  }
  void report(const Progress& p) const {
    if (progress) progress(p);
  }
};

}  // namespace surpass

// Independent work on every point, with progress and cancellation in between.
#pragma once

#include <surpass/context.hpp>
#include <surpass/result.hpp>

#include <algorithm>
#include <string_view>

#include "parallel/parallel.hpp"

namespace surpass::reconstruction {

/// Calls body(begin, end) for chunks of [0, n), on several threads. Error: cancelled.
template <class Body>
Result<void> for_points(const Context& context, std::string_view stage, std::size_t n,
                        Body&& body) {
  constexpr std::size_t kBlock = 16384;  // some ten milliseconds of work
  constexpr std::size_t kChunk = 256;
  for (std::size_t first = 0; first < n; first += kBlock) {
    context.report(
        {.stage = stage, .fraction = static_cast<double>(first) / static_cast<double>(n)});
    if (context.cancelled())
      return fail(ErrorCode::cancelled, "the reconstruction was interrupted");
    parallel::for_ranges(
        context, std::min(kBlock, n - first),
        [&](std::size_t begin, std::size_t end) { body(first + begin, first + end); }, kChunk);
  }
  return {};
}

}  // namespace surpass::reconstruction

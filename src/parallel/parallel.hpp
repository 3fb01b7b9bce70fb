// The only door to threads. Ranges are cut into chunks whose size depends on nothing but the range,
// so sums added chunk by chunk in order have the same bits for every number of threads.
#pragma once

#include <surpass/context.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace surpass::parallel {

/// Elements a chunk: large enough to pay for a task, small enough to share out.
inline constexpr std::size_t kChunk = 4096;

/// Number of threads that Context::threads asks for.
[[nodiscard]] int thread_count(const Context& context);

/// A call without ownership: what run_chunks is given in place of a template.
struct ChunkTask {
  void* body;
  void (*call)(void* body, std::size_t chunk);
};

/// Calls task(c) for c in [0, chunks), in any order, on as many threads as `context` asks for;
/// returns when all are done. With one chunk or one thread everything happens on the caller's own
/// thread.
void run_chunks(const Context& context, std::size_t chunks, ChunkTask task);

/// Calls first() here and, beside it, second() on a thread of its own if more than one is allowed
/// and to be had; else one after the other. So second may wait for first, never first for second.
/// Neither may throw.
void run_beside(const Context& context, const std::function<void()>& first,
                const std::function<void()>& second);

/// Calls body(begin, end) for consecutive chunks of [0, n).
template <class Body>
void for_ranges(const Context& context, std::size_t n, Body&& body, std::size_t chunk = kChunk) {
  const std::size_t chunks = (n + chunk - 1) / chunk;
  auto run = [&](std::size_t c) { body(c * chunk, std::min(n, (c + 1) * chunk)); };
  run_chunks(context, chunks,
             {&run, [](void* r, std::size_t c) { (*static_cast<decltype(run)*>(r))(c); }});
}

/// Combines partial(begin, end) of consecutive chunks from left to right.
template <class T, class Partial, class Combine>
T reduce(const Context& context, std::size_t n, T first, Partial&& partial, Combine&& combine,
         std::size_t chunk = kChunk) {
  // In a struct, for a vector<bool> would put the parts of different threads into one word.
  struct Part {
    T value;
  };
  std::vector<Part> parts((n + chunk - 1) / chunk);
  for_ranges(
      context, n,
      [&](std::size_t begin, std::size_t end) { parts[begin / chunk].value = partial(begin, end); },
      chunk);
  for (const Part& part : parts) first = combine(first, part.value);
  return first;
}

}  // namespace surpass::parallel

#include "parallel/parallel.hpp"

#if defined(SURPASS_THREADS_TBB) || defined(SURPASS_THREADS_STD)
#include <system_error>
#include <thread>
#endif

#if defined(SURPASS_THREADS_TBB)
#include <optional>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#elif defined(SURPASS_THREADS_STD)
#include <atomic>
#endif

namespace surpass::parallel {

#if defined(SURPASS_THREADS_TBB)

int thread_count(const Context& context) {
  return context.threads > 0 ? context.threads : tbb::this_task_arena::max_concurrency();
}

static void run_on_threads(int threads, std::size_t chunks, ChunkTask task) {
  // More threads than cores are only granted, and not complained about, while such a control lives.
  std::optional<tbb::global_control> more;
  if (threads > tbb::info::default_concurrency()) {
    more.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) { task.call(task.body, c); });
  });
}

#elif defined(SURPASS_THREADS_STD)

int thread_count(const Context& context) {
  return context.threads > 0 ? context.threads
                             : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

static void run_on_threads(int threads, std::size_t chunks, ChunkTask task) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t c = next++; c < chunks; c = next++) task.call(task.body, c);
  };
  std::vector<std::thread> helpers;
  for (int t = 1; t < threads && static_cast<std::size_t>(t) < chunks; ++t) {
    helpers.emplace_back(work);
  }
  work();
  for (std::thread& helper : helpers) helper.join();
}

#else

int thread_count(const Context&) { return 1; }

static void run_on_threads(int, std::size_t chunks, ChunkTask task) {
  for (std::size_t c = 0; c < chunks; ++c) task.call(task.body, c);
}

#endif

// Not a task: a task that waits might keep the one that it waits for from running.
void run_beside(const Context& context, const std::function<void()>& first,
                const std::function<void()>& second) {
#if defined(SURPASS_THREADS_TBB) || defined(SURPASS_THREADS_STD)
  if (thread_count(context) > 1) {
    std::thread beside;
    try {
      beside = std::thread(second);
    } catch (const std::system_error&) {  // no more threads are to be had
    }
    first();
    if (beside.joinable()) return beside.join();
    return second();
  }
#else
  static_cast<void>(context);
#endif
  first();
  second();
}

void run_chunks(const Context& context, std::size_t chunks, ChunkTask task) {
  // One chunk does not ask how many threads there are: to answer, TBB starts up.
  const int threads = chunks <= 1 ? 1 : thread_count(context);
  if (threads == 1) {
    for (std::size_t c = 0; c < chunks; ++c) task.call(task.body, c);
    return;
  }
  run_on_threads(threads, chunks, task);
}

}  // namespace surpass::parallel

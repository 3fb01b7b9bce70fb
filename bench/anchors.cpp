// What the machine itself can do: figures that ratios can be taken to on any machine.
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "contenders.hpp"

namespace surpass::bench {
namespace {

constexpr char kTool[] = "this machine";

// a = b + 3 c over three arrays of a mesh's points: 72 bytes a vertex, as STREAM counts them.
auto prepare_triad(const Workload& workload) {
  const std::size_t n = 3 * workload.mesh().points.size();
  return [a = std::vector<double>(n, 0.0), b = std::vector<double>(n, 1.0),
          c = std::vector<double>(n, 2.0)]() mutable {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = b[i] + 3 * c[i];
    return a.back();
  };
}

// The bytes of a file in the page cache, read() into a buffer that was written to before.
auto prepare_raw_read(const std::string& path) {
  struct stat facts = {};
  if (::stat(path.c_str(), &facts) != 0) throw std::runtime_error("cannot find " + path);
  return [path, buffer = std::vector<char>(static_cast<std::size_t>(facts.st_size))]() mutable {
    const int file = ::open(path.c_str(), O_RDONLY);
    std::size_t done = 0;
    for (ssize_t got = 1; got > 0 && done < buffer.size(); done += static_cast<std::size_t>(got)) {
      got = ::read(file, buffer.data() + done, buffer.size() - done);
      if (got < 0) break;
    }
    ::close(file);
    return done == buffer.size();
  };
}

Verdict judge_read(const Workload&, bool complete) { return {.difference = complete ? 0.0 : 1.0}; }

}  // namespace

void add_triad(Harness& harness, Index side, const char* step) {
  harness.add({.step = step, .tool = kTool, .counted = "one triad pass over 72 bytes a vertex"},
              side, prepare_triad,
              [](const Workload&, double last) { return Verdict{.difference = last - 7}; });
}

void add_anchors(Harness& harness, Index side) {
  for (const char* step : {"sweep", "solve again"}) add_triad(harness, side, step);
  harness.add(
      {.step = "read OBJ",
       .tool = kTool,
       .counted = "warm read() of the file into a touched buffer"},
      side, [](const Workload& w) { return prepare_raw_read(w.obj()); }, judge_read);
  harness.add(
      {.step = "read PLY",
       .tool = kTool,
       .counted = "warm read() of the file into a touched buffer"},
      side, [](const Workload& w) { return prepare_raw_read(w.ply()); }, judge_read);
}

}  // namespace surpass::bench

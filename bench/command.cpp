// The program itself, as a user starts it: from the OBJ file to the certified control mesh on disk.
#include <surpass/io.hpp>

#include <array>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "contenders.hpp"
#include "judges.hpp"

namespace surpass::bench {
namespace {

struct Run {
  std::string control;  ///< the file that was written
  double peak_bytes;
};

Run interpolate_file(const std::string& obj) {
  const std::string control = obj + ".control.ply";
  const std::string tolerance = fmt::format("{}", kTolerance);
  std::array<const char*, 11> arguments = {
      SURPASS_BENCH_PROGRAM, "interpolate", obj.c_str(), "-o",      control.c_str(), "--tolerance",
      tolerance.c_str(),     "--threads",   "1",         "--quiet", nullptr};
  pid_t child = 0;
  if (::posix_spawn(&child, arguments[0], nullptr, nullptr, const_cast<char**>(arguments.data()),
                    environ) != 0) {
    throw std::runtime_error("cannot start " SURPASS_BENCH_PROGRAM);
  }
  int status = 0;
  rusage usage = {};
  if (::wait4(child, &status, 0, &usage) != child || status != 0) {
    throw std::runtime_error("surpass interpolate failed");
  }
  return {control, 1024.0 * static_cast<double>(usage.ru_maxrss)};
}

Verdict judge(const Workload& workload, const Run& run) {
  const auto read = read_mesh(run.control);
  if (!read) throw std::runtime_error(describe(read.error()));
  ::unlink(run.control.c_str());
  Verdict verdict = judge_control(workload, read->mesh.points);
  verdict.peak = run.peak_bytes / static_cast<double>(workload.mesh().points.size());
  return verdict;
}

}  // namespace

void add_command(Harness& harness, Index side) {
  harness.add(
      {.step = "whole command",
       .tool = "Surpass",
       .counted = "surpass interpolate, OBJ in, binary PLY out, certificate included; a "
                  "process of its own"},
      side, [](const Workload& w) { return [path = w.obj()] { return interpolate_file(path); }; },
      judge);
}

}  // namespace surpass::bench

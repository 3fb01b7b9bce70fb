// The program itself, as a user starts it: from the OBJ file to the certified control mesh on disk.
#include <surpass/io.hpp>

#include <fstream>
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "contenders.hpp"
#include "judges.hpp"

namespace surpass::bench {
namespace {

struct Run {
  std::string obj;
  std::string control;  ///< the file that was written
};

// With a report, if it has a name.
Run interpolate_file(const std::string& obj, const std::string& report = {}) {
  const std::string control = obj + ".control.ply";
  const std::string tolerance = fmt::format("{}", kTolerance);
  std::vector<const char*> arguments = {
      SURPASS_BENCH_PROGRAM, "interpolate",     obj.c_str(), "-o", control.c_str(),
      "--tolerance",         tolerance.c_str(), "--threads", "1",  "--quiet"};
  if (!report.empty()) arguments.insert(arguments.end(), {"--report", report.c_str()});
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (::posix_spawn(&child, arguments[0], nullptr, nullptr, const_cast<char**>(arguments.data()),
                    environ) != 0) {
    throw std::runtime_error("cannot start " SURPASS_BENCH_PROGRAM);
  }
  int status = 0;
  if (::waitpid(child, &status, 0) != child || status != 0) {
    throw std::runtime_error("surpass interpolate failed");
  }
  return {obj, control};
}

// The program's own account, in a run that is not timed. What the system says of a child begins
// with the memory of this process.
double peak_bytes(const std::string& obj) {
  const std::string report = obj + ".report.json";
  interpolate_file(obj, report);
  const auto json = nlohmann::json::parse(std::ifstream(report));
  ::unlink(report.c_str());
  return json.at("peak_memory_bytes").get<double>();
}

Verdict judge(const Workload& workload, const Run& run) {
  const auto read = read_mesh(run.control);
  if (!read) throw std::runtime_error(describe(read.error()));
  Verdict verdict = judge_control(workload, read->mesh.points);
  verdict.peak = peak_bytes(run.obj) / static_cast<double>(workload.mesh().points.size());
  ::unlink(run.control.c_str());
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

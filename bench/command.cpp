// The program itself, as a user starts it: from the OBJ file to the certified control mesh on disk.
#include <surpass/io.hpp>

#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "contenders.hpp"
#include "judges.hpp"
#include "program.hpp"

namespace surpass::bench {
namespace {

struct Run {
  std::string obj;
  [[nodiscard]] std::string control() const { return obj + ".control.ply"; }
  [[nodiscard]] std::vector<std::string> arguments() const {
    return {"interpolate", obj, "-o", control(), "--tolerance", fmt::format("{}", kTolerance)};
  }
};

Verdict judge(const Workload& workload, const Run& run) {
  const auto read = read_mesh(run.control());
  if (!read) throw std::runtime_error(describe(read.error()));
  Verdict verdict = judge_control(workload, read->mesh.points);
  verdict.peak = report_of_program(run.arguments()).at("peak_memory_bytes").get<double>() /
                 static_cast<double>(workload.mesh().points.size());
  ::unlink(run.control().c_str());
  return verdict;
}

}  // namespace

void add_command(Harness& harness, Index side) {
  harness.add(
      {.step = "whole command",
       .tool = "Surpass",
       .counted = "surpass interpolate, OBJ in, binary PLY out, certificate included; a "
                  "process of its own"},
      side,
      [](const Workload& w) {
        return [run = Run{w.obj()}] {
          run_program(run.arguments());
          return run;
        };
      },
      judge);
}

}  // namespace surpass::bench

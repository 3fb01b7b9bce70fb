// Interpolation by similarity on quads, from file to file as the paper's times are told, to its
// tolerance 1e-2: how it grows, what it holds in memory, and which solver is faster.
#include <surpass/io.hpp>
#include <surpass/quality.hpp>

#include <stdexcept>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "contenders.hpp"
#include "mesh_files.hpp"
#include "program.hpp"

namespace surpass::bench {
namespace {

struct Run {
  std::string obj;  // of the quads
  std::string form;
  std::string solver;
  [[nodiscard]] std::string control() const { return obj + ".control.ply"; }
  [[nodiscard]] std::vector<std::string> arguments() const {
    return {"interpolate", obj,          "-o",           control(), "--scheme", "catmull-clark",
            "--method",    "similarity", "--similarity", form,      "--solver", solver};
  }
};

Verdict judge(const Workload& workload, const Run& run) {
  const auto read = read_mesh(run.control());
  if (!read) throw std::runtime_error(describe(read.error()));
  const Mesh& given = workload.quads();
  const auto certificate = certify(read->mesh, given.points, {.scheme = Scheme::catmull_clark});
  if (!certificate) throw std::runtime_error(describe(certificate.error()));
  const auto report = report_of_program(run.arguments());
  ::unlink(run.control().c_str());
  ::unlink(run.obj.c_str());
  return {.error = certificate->max,
          .sweeps = report.at("iterations").get<double>(),
          .peak = report.at("peak_memory_bytes").get<double>() /
                  static_cast<double>(given.points.size())};
}

void add_run(Harness& harness, Index side, const std::string& form, const std::string& solver,
             const std::string& tool) {
  harness.add(
      {.step = "similarity, " + form,
       .tool = tool,
       .counted =
           "surpass interpolate --method similarity, OBJ of quads in, binary PLY out, solver "
           "tolerance 1e-2; a process of its own",
       .slow = true},
      side,
      [form, solver, tool](const Workload& w) {
        Run run{w.obj() + "." + form + "." + solver + ".obj", form, solver};
        write_obj(w.quads(), run.obj);
        return [run] {
          run_program(run.arguments());
          return run;
        };
      },
      judge);
}

}  // namespace

void add_similarity(Harness& harness, Index side) {
  constexpr Index kMostAssembled = 100;  // gigabytes beyond
  for (const char* form : {"vectors", "directions"}) {
    add_run(harness, side, form, "conjugate-gradient", "Surpass");
    if (side > kMostAssembled) continue;
    add_run(harness, side, form, "gauss-seidel", "Surpass, Gauss-Seidel");
  }
}

}  // namespace surpass::bench

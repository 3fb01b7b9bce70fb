// Interpolation by similarity on quads, from file to file as the paper's times are told, to its
// tolerance 1e-2 and to 1e-6: how it grows, what it holds in memory, and which solver is faster.
#include <surpass/io.hpp>
#include <surpass/quality.hpp>

#include <memory>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "contenders.hpp"
#include "program.hpp"

namespace surpass::bench {
namespace {

// The quads as a file, and what is made of it, as long as anybody needs them.
struct QuadFiles {
  std::string obj;
  QuadFiles(const Mesh& mesh, std::string path) : obj(std::move(path)) {
    if (const auto ok = write_mesh(mesh, obj); !ok) throw std::runtime_error(describe(ok.error()));
  }
  QuadFiles(const QuadFiles&) = delete;
  QuadFiles& operator=(const QuadFiles&) = delete;
  ~QuadFiles() {
    ::unlink(obj.c_str());
    ::unlink(control().c_str());
  }
  [[nodiscard]] std::string control() const { return obj + ".control.ply"; }
};

struct SimilarityRun {
  std::shared_ptr<const QuadFiles> files;
  std::string form;
  std::string solver;
  std::string tolerance;
  [[nodiscard]] std::vector<std::string> arguments() const {
    return {"interpolate",
            files->obj,
            "-o",
            files->control(),
            "--scheme",
            "catmull-clark",
            "--method",
            "similarity",
            "--similarity",
            form,
            "--solver",
            solver,
            "--solver-tolerance",
            tolerance};
  }
};

Verdict judge_similarity(const Workload& workload, const SimilarityRun& run) {
  const auto read = read_mesh(run.files->control());
  if (!read) throw std::runtime_error(describe(read.error()));
  const Mesh& given = workload.quads();
  const auto certificate = certify(read->mesh, given.points, {.scheme = Scheme::catmull_clark});
  if (!certificate) throw std::runtime_error(describe(certificate.error()));
  const auto report = report_of_program(run.arguments());
  return {.error = certificate->max,
          .sweeps = report.at("iterations").get<double>(),
          .peak = report.at("peak_memory_bytes").get<double>() /
                  static_cast<double>(given.points.size())};
}

constexpr char kLoose[] = "1e-2";

void add_run(Harness& harness, Index side, const std::string& form, const std::string& solver,
             const std::string& tolerance, const std::string& tool) {
  harness.add(
      {.step = "similarity, " + form + (tolerance == kLoose ? "" : ", to " + tolerance),
       .tool = tool,
       .counted =
           "surpass interpolate --method similarity, OBJ of quads in, binary PLY out, solver "
           "tolerance " +
           tolerance + "; a process of its own",
       .slow = tolerance != kLoose},
      side,
      [form, solver, tolerance](const Workload& w) {
        const std::string path = w.obj() + "." + form + "." + solver + "." + tolerance + ".obj";
        const SimilarityRun run{std::make_shared<const QuadFiles>(w.quads(), path), form, solver,
                                tolerance};
        return [run] {
          run_program(run.arguments());
          return run;
        };
      },
      judge_similarity);
}

}  // namespace

void add_similarity(Harness& harness, Index side) {
  constexpr Index kMostAssembled = 100;  // ten times as many faces take gigabytes
  for (const char* form : {"vectors", "directions"}) {
    for (const char* tolerance : {kLoose, "1e-6"}) {
      add_run(harness, side, form, "conjugate-gradient", tolerance, "Surpass");
      if (side > kMostAssembled) continue;
      add_run(harness, side, form, "gauss-seidel", tolerance, "Surpass, Gauss-Seidel");
    }
  }
}

}  // namespace surpass::bench

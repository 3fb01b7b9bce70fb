// Ours: one thread, as the rivals use, and where the library is threaded all cores as well.
#include <surpass/interpolate.hpp>
#include <surpass/io.hpp>
#include <surpass/refiner.hpp>
#include <surpass/topology.hpp>

#include <memory>
#include <stdexcept>

#include "contenders.hpp"
#include "judges.hpp"

namespace surpass::bench {
namespace {

struct Crew {
  const char* tool;
  Context context;
};

std::vector<Crew> crews() {
  return {{"Surpass", {.threads = 1}}, {"Surpass, all cores", {.threads = 0}}};
}

template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(describe(result.error()));
  return std::move(*result);
}

InterpolateOptions solve_options() { return {.tolerance = kTolerance}; }

struct Opened {
  Mesh mesh;
  Topology topology;
};

Opened open(const std::string& path) {
  Mesh mesh = value_of(read_mesh(path)).mesh;
  Topology topology = value_of(Topology::build(mesh));
  return {std::move(mesh), std::move(topology)};
}

Verdict judge_topology(const Workload& workload, const Topology& topology) {
  std::vector<Index> valences;
  for (Index v = 0; v < topology.vertex_count(); ++v) valences.push_back(topology.valence(v));
  return judge_valences(workload, valences);
}

Verdict judge_mesh(const Workload& workload, const Mesh& mesh) {
  return judge_file(workload, mesh.points, mesh.face_vertices, Precision::doubles);
}

Verdict judge_solved(const Workload& workload, std::span<const Point> control,
                     const SolveReport& report) {
  Verdict verdict = judge_control(workload, control);
  verdict.sweeps = report.iterations;
  return verdict;
}

void add_topology(Harness& harness, Index side) {
  harness.add(
      {.step = "topology",
       .tool = "Surpass",
       .counted = "Topology::build from a mesh, its checks for manifold, oriented faces "
                  "included"},
      side,
      [](const Workload& w) {
        return [&mesh = w.mesh()] { return value_of(Topology::build(mesh)); };
      },
      judge_topology);
}

void add_readers(Harness& harness, Index side) {
  const auto add = [&](const std::string& format, const std::string& (Workload::*path)() const) {
    harness.add(
        {.step = "read " + format,
         .tool = "Surpass",
         .counted = "read_mesh: double points and polygons, no connectivity"},
        side,
        [path](const Workload& w) {
          return [file = (w.*path)()] { return value_of(read_mesh(file)); };
        },
        [](const Workload& w, const LoadedMesh& read) { return judge_mesh(w, read.mesh); });
    harness.add(
        {.step = "read " + format + " to topology",
         .tool = "Surpass",
         .counted = "read_mesh and Topology::build"},
        side, [path](const Workload& w) { return [file = (w.*path)()] { return open(file); }; },
        [](const Workload& w, const Opened& opened) { return judge_mesh(w, opened.mesh); });
  };
  add("OBJ", &Workload::obj);
  add("PLY", &Workload::ply);
}

void add_limits(Harness& harness, Index side, const Crew& crew) {
  const auto judge = [](const Workload& w, const auto& limits) { return judge_limits(w, limits); };
  harness.add(
      {.step = "limit points from faces",
       .tool = crew.tool,
       .counted = "limit_positions from a mesh: topology, operator and one sweep"},
      side,
      [context = crew.context](const Workload& w) {
        return [&mesh = w.mesh(), context] {
          return value_of(limit_positions(mesh, Rules{}, context));
        };
      },
      judge);
  harness.add(
      {.step = "sweep",
       .tool = crew.tool,
       .counted = "Refiner::refine onto the limit at level 0, prepared, into a new array"},
      side,
      [context = crew.context](const Workload& w) {
        const auto limit = std::make_shared<const Refiner>(
            value_of(Refiner::create(w.mesh(), {.levels = 0, .limit = true}, context)));
        return [&mesh = w.mesh(), context, limit] {
          return value_of(limit->refine(mesh.points, context));
        };
      },
      judge);
}

void add_solve_from_faces(Harness& harness, Index side, const Crew& crew) {
  harness.add(
      {.step = "solve from faces",
       .tool = crew.tool,
       .counted = "interpolate: topology, operator, solve and the control mesh"},
      side,
      [context = crew.context](const Workload& w) {
        return [&mesh = w.mesh(), context] {
          return value_of(interpolate(mesh, solve_options(), context));
        };
      },
      [](const Workload& w, const Interpolated& solved) {
        return judge_solved(w, solved.control.points, solved.report);
      });
}

void add_again(Harness& harness, Index side, const Crew& crew) {
  harness.add(
      {.step = "solve again",
       .tool = crew.tool,
       .counted = "Interpolator::solve for the points, set-up kept"},
      side,
      [context = crew.context](const Workload& w) {
        auto solver = std::make_shared<const Interpolator>(
            value_of(Interpolator::create(w.mesh(), solve_options(), context)));
        return [&mesh = w.mesh(), solver, context] {
          return value_of(solver->solve(mesh.points, {}, context));
        };
      },
      [](const Workload& w, const Solution& solved) {
        return judge_solved(w, solved.points, solved.report);
      });
}

}  // namespace

void add_surpass(Harness& harness, Index side) {
  add_topology(harness, side);
  add_readers(harness, side);
  for (const Crew& crew : crews()) {
    add_limits(harness, side, crew);
    add_solve_from_faces(harness, side, crew);
    add_again(harness, side, crew);
  }
}

void add_solve_again(Harness& harness, Index side) {
  for (const Crew& crew : crews()) add_again(harness, side, crew);
}

}  // namespace surpass::bench

// surpass_bench [--benchmark_filter=...]: Surpass beside the libraries that do parts of its work,
// all in one process. Prints figures as they come; table.py makes the table from the JSON. Exits
// with 1 if any result, ours or a rival's, is not the one that all must reach.
#include <cstdio>
#include <exception>
#include <filesystem>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "contenders.hpp"
#include "machine.hpp"
#include "refinement.hpp"

namespace {

// In memory where that is to be had: the program flushes what it writes to the disk, and it is not
// the disk that is to be measured.
std::filesystem::path scratch_folder() {
  const std::filesystem::path memory = "/dev/shm";
  const bool there = std::filesystem::is_directory(memory);
  return (there ? memory : std::filesystem::temp_directory_path()) / "surpass_bench";
}

int run(int argc, char** argv) {
  using namespace surpass::bench;
  Workloads workloads(scratch_folder());
  Harness harness(workloads);
  for (const auto side : kSides) {
    for (const auto add :
         {add_surpass, add_command, add_schemes, add_anchors, add_opensubdiv, add_openmesh,
          add_cgal, add_tinyobjloader, add_assimp, add_cholmod, add_eigen, add_refinement,
          add_opensubdiv_refinement, add_openmesh_refinement, add_cgal_refinement}) {
      add(harness, side);
    }
  }
  add_triad(harness, kLargestSide, "solve again");
  add_solve_again(harness, kLargestSide);
  for (const auto side : kGrowingSides) add_similarity(harness, side);
  harness.schedule();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const auto& [key, value] : machine_facts()) benchmark::AddCustomContext(key, value);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  if (harness.failures() > 0) fmt::print(stderr, "{} results disagree\n", harness.failures());
  return harness.failures() > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "surpass_bench: {}\n", error.what());
    return 2;
  }
}

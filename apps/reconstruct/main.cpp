// surpass-reconstruct, which `surpass reconstruct` becomes.
#include "other_program.hpp"
#include "runner.hpp"

namespace surpass::cli {
std::unique_ptr<Command> make_reconstruct();
}  // namespace surpass::cli

int main(int argc, char** argv) {
  surpass::cli::CommandEntry entry = surpass::cli::kReconstruct;
  entry.make = surpass::cli::make_reconstruct;
  return surpass::cli::run_command(entry, {argv + 1, argv + argc});
}

// surpass-render, which `surpass render` becomes.
#include "other_program.hpp"
#include "runner.hpp"

namespace surpass::cli {
std::unique_ptr<Command> make_render();
}  // namespace surpass::cli

int main(int argc, char** argv) {
  surpass::cli::CommandEntry entry = surpass::cli::kRender;
  entry.make = surpass::cli::make_render;
  return surpass::cli::run_command(entry, {argv + 1, argv + argc});
}

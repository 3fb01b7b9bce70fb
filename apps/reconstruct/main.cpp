// surpass-reconstruct, which `surpass reconstruct` becomes.
#include "runner.hpp"

namespace surpass::cli {
std::unique_ptr<Command> make_reconstruct();
}  // namespace surpass::cli

int main(int argc, char** argv) {
  constexpr surpass::cli::CommandEntry kEntry = {
      "reconstruct", "from a cloud of points to a mesh, and a smooth surface through its vertices",
      surpass::cli::make_reconstruct};
  return surpass::cli::run_command(kEntry, {argv + 1, argv + argc});
}

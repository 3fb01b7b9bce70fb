#include "command.hpp"
#include "other_program.hpp"

namespace surpass::cli {

std::unique_ptr<Command> make_interpolate();
std::unique_ptr<Command> make_predict();
std::unique_ptr<Command> make_subdivide();
std::unique_ptr<Command> make_check();
std::unique_ptr<Command> make_inspect();
std::unique_ptr<Command> make_compare();
std::unique_ptr<Command> make_quality();
std::unique_ptr<Command> make_convert();
std::unique_ptr<Command> make_view();

std::span<const CommandEntry> commands() {
  static constexpr CommandEntry kCommands[] = {
      {"interpolate", "find the control mesh whose limit surface passes through every vertex",
       make_interpolate},
      {"predict", "how many sweeps an interpolation will need, by the proven bound", make_predict},
      kReconstruct,
      {"subdivide", "refine a control mesh, and move it onto its limit surface", make_subdivide},
      {"check", "does a control mesh's limit surface pass through the given vertices?", make_check},
      {"inspect", "counts, boundaries, valences, creases, and what would be refused", make_inspect},
      {"compare", "distances between two surfaces", make_compare},
      {"quality", "fairness of limit surfaces: energies, curvatures, normals against a reference",
       make_quality},
      {"convert", "read a mesh in one format and write it in another", make_convert},
      kRender,
      {"view", "show meshes in the browser, in one page that works offline", make_view},
  };
  return kCommands;
}

}  // namespace surpass::cli

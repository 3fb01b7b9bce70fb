#include "help.hpp"

#include <surpass/version.hpp>

#include <fmt/format.h>

#include "command.hpp"
#include "evaluator.hpp"
#include "other_program.hpp"

namespace surpass::cli {

std::string overview() {
  std::string text =
      "Interpolating subdivision surfaces: the control mesh whose limit surface passes through\n"
      "every vertex of a given mesh.\n\n"
      "Usage: surpass COMMAND INPUT... [-o OUTPUT] [OPTIONS]\n"
      "       surpass COMMAND --help\n\nCommands:\n";
  for (const CommandEntry& entry : commands()) {
    text += fmt::format("  {:13}{}\n", entry.name, entry.summary);
  }
  text +=
      "\nFiles: OBJ, PLY, OFF, STL, and XYZ for points; '-' is the standard input or output. Data "
      "goes to stdout or "
      "to\n"
      "files, everything else to stderr.\n\n"
      "Exit codes:\n"
      "  0    done\n"
      "  1    the command line asks for something that cannot be meant, or is not built in\n"
      "  2    a file cannot be read; the message names file, line and column, or the byte\n"
      "  3    the mesh does not suit the task; the message names the element\n"
      "  4    the tolerance was not reached\n"
      "  5    the output cannot be written\n"
      "  130  interrupted; nothing was written\n\n"
      "Example:\n"
      "  surpass interpolate given.obj -o control.obj --surface surface.ply --levels 3\n";
  return text;
}

std::string version_text() {
  std::string text = fmt::format("surpass {}\n  threads      {}\n  oracle       {}\n", kVersion,
                                 kThreads, oracle_version());
  for (const CommandEntry& entry : commands()) {
    if (entry.make != nullptr) continue;
    text += fmt::format(
        "  {:11}  {}\n", entry.name,
        has_other_program(entry) ? fmt::format("surpass-{}", entry.name) : "not built in");
  }
  return text;
}

}  // namespace surpass::cli

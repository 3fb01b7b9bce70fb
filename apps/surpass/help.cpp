#include "help.hpp"

#include <surpass/version.hpp>

#include "command.hpp"
#ifdef SURPASS_ORACLE
#include <surpass/oracle.hpp>
#endif

#include <sstream>

#include <fmt/format.h>

namespace surpass::cli {

namespace {

constexpr std::size_t kNameColumn = 32;
constexpr std::size_t kLineWidth = 98;

/// `text` broken into lines that start at kNameColumn; the first goes on where `head` ends.
std::string in_columns(std::string head, const std::string& text) {
  const std::string indent(kNameColumn, ' ');
  if (head.size() + 2 > kNameColumn) {
    head += "\n" + indent;
  } else {
    head.resize(kNameColumn, ' ');
  }
  std::istringstream words(text);
  std::size_t column = kNameColumn;
  for (std::string word; words >> word; column += word.size() + 1) {
    if (column + word.size() > kLineWidth) {
      head += "\n" + indent;
      column = kNameColumn;
    }
    head += (column == kNameColumn ? "" : " ") + word;
  }
  return head + "\n";
}

}  // namespace

std::string HelpFormatter::make_option(const CLI::Option* option, bool positional) const {
  std::string head = "  " + (positional ? option->get_name(true) : option->get_name(false, true));
  const std::string type = option->get_type_name();
  if (!positional && !type.empty()) head += " " + type;
  std::string text = option->get_description();
  if (!option->get_default_str().empty()) text += " [default: " + option->get_default_str() + "]";
  if (!positional && option->get_required()) text += " (required)";
  return in_columns(head, text);
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return app->get_name() + ": " + app->get_description() + "\n\n";
}

std::string HelpFormatter::make_footer(const CLI::App* app) const {
  return "\n" + app->get_footer();
}

std::string help_text(const CLI::App& app) {
  std::string text = app.help();
  // CLI11 puts two empty lines between groups.
  for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
  return text;
}

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
      "\nFiles: OBJ, PLY, OFF, STL; '-' is the standard input or output. Data goes to stdout or "
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
  std::string text = fmt::format("surpass {}\n  threads   {}\n", kVersion, kThreads);
#ifdef SURPASS_ORACLE
  text += fmt::format("  oracle    {}\n", opensubdiv_version());
#else
  text += "  oracle    not built in\n";
#endif
#ifdef SURPASS_RENDER
  text += "  renderer  Embree\n";
#else
  text += "  renderer  not built in\n";
#endif
  return text;
}

}  // namespace surpass::cli

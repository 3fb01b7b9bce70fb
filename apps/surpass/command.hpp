// What a subcommand is, and the list of them.
//
// To add one: write NAME.cpp with a class derived from Command and a make_NAME() at its end, then
// name it in commands.cpp and in CMakeLists.txt. Options common to all commands (--threads,
// --report, ...) are defined by main.cpp; those common to commands that read or write a mesh are
// members to include: MeshInput, MeshOutput, RulesOption.
#pragma once

#include <surpass/result.hpp>

#include <memory>
#include <span>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

class Command {
 public:
  Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  /// Declares arguments and options; parsing stores their values in members of the derived class.
  virtual void define(Options& options) = 0;

  /// Does the work. An error becomes a sentence on stderr, "failure" in the report, and an exit
  /// code; what was learnt before it stays in session.report.
  virtual Result<void> run(Session& session) = 0;
};

struct CommandEntry {
  const char* name;
  const char* summary;                 ///< one line for `surpass --help`
  std::unique_ptr<Command> (*make)();  ///< nullptr: the program surpass-NAME is the command
  const char* needs = "";              ///< what such a program is built with
};

/// Every subcommand, in the order of `surpass --help`.
[[nodiscard]] std::span<const CommandEntry> commands();

}  // namespace surpass::cli

// surpass: picks the command and runs it.
#include <fmt/format.h>

#include "command.hpp"
#include "evaluator.hpp"
#include "help.hpp"
#include "other_program.hpp"
#include "runner.hpp"
#include "spelling.hpp"

namespace surpass::cli {

namespace {

using Words = std::vector<std::string>;

int unknown_command(const std::string& word, Console& console) {
  Words names;
  for (const CommandEntry& entry : commands()) names.emplace_back(entry.name);
  const char* kind = word.starts_with('-') ? "option" : "command";
  if (word.starts_with('-')) names = {"--help", "--version"};
  const std::string sentence =
      fmt::format("there is no {} '{}'{}", kind, word, suggestion(word, names));
  console.error(pointing_to_help(sentence, "surpass"));
  return exit_status(ErrorCode::invalid_argument);
}

int run(Words words) {
  Console console;
  if (words.empty()) {
    console.error("name a command; see surpass --help");
    return exit_status(ErrorCode::invalid_argument);
  }
  if (const auto status = become_oracle_if_asked(words)) return *status;
  std::string first = words.front();
  words.erase(words.begin());
  if (first == "--version") return print_out(version_text(), console);
  if (first == "--help" || first == "-h" || first == "help") {
    if (words.empty()) return print_out(overview(), console);
    first = words.front();
    words = {"--help"};
  }
  for (const CommandEntry& entry : commands()) {
    if (first != entry.name) continue;
    return entry.make != nullptr ? run_command(entry, words) : run_other_program(entry, words);
  }
  return unknown_command(first, console);
}

}  // namespace

}  // namespace surpass::cli

int main(int argc, char** argv) { return surpass::cli::run({argv + 1, argv + argc}); }

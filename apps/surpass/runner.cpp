#include "runner.hpp"

#include <surpass/io.hpp>
#include <surpass/version.hpp>

#include <new>

#include <fmt/format.h>

#include "mesh_input.hpp"
#include "signals.hpp"

namespace surpass::cli {

namespace {

struct Wishes {
  bool quiet = false;
  bool verbose = false;
};

void define_common(Options& options, Wishes& wishes, Session& session) {
  options
      .add("--report", session.report_path,
           "Write what was found and done as JSON (docs/report.schema.json)")
      .type_name("FILE.json")
      .group("General");
  options
      .add("--threads", session.context.threads,
           "Number of threads, 0 for all cores; results do not depend on it")
      .in_range(0, 1024)
      .type_name("N")
      .default_text("0")
      .group("General");
  Option quiet =
      options.flag("--quiet,-q", wishes.quiet, "Say nothing but errors").group("General");
  options.flag("--verbose,-v", wishes.verbose, "Also say on stderr how long each stage took")
      .excludes(quiet)
      .group("General");
}

/// Adds what to try, if the command has the option for it and it was not tried.
Error with_remedy(Error error, const Options& options) {
  const std::string sentence = remedy(error);
  const bool offered = options.offers(sentence.substr(0, sentence.find(' ')));
  if (offered) error.message += "; " + sentence;
  return error;
}

Result<void> run_guarded(Command& command, Session& session) {
  try {
    return command.run(session);
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, "there is not enough memory for this mesh");
  }
}

/// Runs the command and reports its outcome; the exit code.
int execute(Command& command, const Options& options, Session& session) {
  Result<void> outcome = session.timed("total", [&] { return run_guarded(command, session); });
  if (!outcome && outcome.error().code == ErrorCode::cancelled) {
    // The report is not written either.
    session.console.error("interrupted; nothing was written");
    return exit_status(ErrorCode::cancelled);
  }
  if (!outcome) {
    outcome = tl::make_unexpected(with_remedy(outcome.error(), options));
    session.console.error(describe(outcome.error()));
  }
  session.tell_times();
  // Where it cannot go, or must not because an input is there, one sentence is enough.
  if (!outcome && session.reporting() && outcome.error().place.file == session.report_path) {
    return exit_status(outcome.error().code);
  }
  const Result<void> written = finish_report(session, outcome ? nullptr : &outcome.error());
  if (!written) session.console.error(describe(written.error()));
  if (!outcome) return exit_status(outcome.error().code);
  return written ? 0 : exit_status(written.error().code);
}

}  // namespace

int print_out(const std::string& text, Console& console) {
  const Result<void> written = write_file("-", text);
  if (written) return 0;
  console.error(describe(written.error()));
  return exit_status(written.error().code);
}

std::string pointing_to_help(const std::string& sentence, const std::string& name) {
  return fmt::format("{}{} {} --help", sentence, sentence.ends_with('?') ? " See" : "; see", name);
}

int run_command(const CommandEntry& entry, const std::vector<std::string>& words) {
  Session session;
  session.context.cancel = &catch_signals();
  session.context.progress = [&](const Progress& p) { session.console.progress(p); };
  session.report["surpass"] = kVersion;
  session.report["command"] = entry.name;

  const std::string name = fmt::format("surpass {}", entry.name);
  Options options(name, entry.summary);
  const std::unique_ptr<Command> command = entry.make();
  Wishes wishes;
  command->define(options);
  define_common(options, wishes, session);

  const Result<bool> help = options.parse(words);
  if (!help) {
    session.console.error(pointing_to_help(help.error().message, name));
    return exit_status(help.error().code);
  }
  if (*help) return print_out(options.help(), session.console);
  if (wishes.quiet) session.console.set_loudness(Loudness::quiet);
  if (wishes.verbose) session.console.set_loudness(Loudness::verbose);
  return execute(*command, options, session);
}

}  // namespace surpass::cli

// What the user sees on stderr. Data goes to files or to stdout, never through here.
#pragma once

#include <surpass/context.hpp>

#include <chrono>
#include <string>
#include <vector>

namespace surpass::cli {

enum class Loudness { quiet, normal, verbose };

class Console {
 public:
  void set_loudness(Loudness loudness) { loudness_ = loudness; }

  /// Why the run failed; printed at any loudness.
  void error(const std::string& sentence);
  /// Something the user should know; also kept for the report.
  void note(const std::string& sentence);
  void notes(const std::vector<std::string>& sentences);
  /// The summary of what was done.
  void say(const std::string& line);
  /// For --verbose only.
  void detail(const std::string& line);

  /// Redraws the progress line: on a terminal only, at most ten times a second.
  void progress(const Progress& progress);

  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  void print(const std::string& line);
  void clear_progress();

  Loudness loudness_ = Loudness::normal;
  std::vector<std::string> notes_;
  bool progress_drawn_ = false;
  std::chrono::steady_clock::time_point last_drawn_ = {};
};

}  // namespace surpass::cli

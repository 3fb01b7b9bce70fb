#include "console.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace surpass::cli {

namespace {

bool stderr_is_terminal() {
  static const bool is_terminal = isatty(STDERR_FILENO) != 0;
  return is_terminal;
}

}  // namespace

void Console::error(const std::string& sentence) { print("surpass: " + sentence); }

void Console::note(const std::string& sentence) {
  notes_.push_back(sentence);
  if (loudness_ != Loudness::quiet) print("note: " + sentence);
}

void Console::notes(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) note(sentence);
}

void Console::say(const std::string& line) {
  if (loudness_ != Loudness::quiet) print(line);
}

void Console::detail(const std::string& line) {
  if (loudness_ == Loudness::verbose) print(line);
}

void Console::progress(const Progress& progress) {
  using namespace std::chrono_literals;
  if (loudness_ == Loudness::quiet || !stderr_is_terminal()) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_drawn_ < 100ms) return;
  last_drawn_ = now;
  std::string line = fmt::format("\r\x1b[K{} {:3.0f} %", progress.stage, 100 * progress.fraction);
  if (progress.iteration > 0) {
    const bool exact = progress.residual > 0;
    line += fmt::format(", iteration {}, {} {:.2e}", progress.iteration,
                        exact ? "residual" : "error", exact ? progress.residual : progress.error);
  }
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  progress_drawn_ = true;
}

void Console::print(const std::string& line) {
  clear_progress();
  std::fputs((line + "\n").c_str(), stderr);
}

void Console::clear_progress() {
  if (progress_drawn_) std::fputs("\r\x1b[K", stderr);
  progress_drawn_ = false;
}

}  // namespace surpass::cli

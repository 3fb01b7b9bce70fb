// What one run of the program holds: how to speak, how to compute, and the report that grows.
#pragma once

#include <surpass/context.hpp>
#include <surpass/result.hpp>

#include <chrono>
#include <string>

#include <nlohmann/json.hpp>

#include "console.hpp"

namespace surpass::cli {

/// Reports list their keys in the order in which they came.
using Json = nlohmann::ordered_json;

struct Session {
  Console console;
  Context context;  ///< to pass to the library: threads, progress, cancellation by a signal
  Json report = Json::object();  ///< written to --report after the command, whatever its outcome
  std::string report_path = {};
  bool on_page = false;  ///< a page of HTML shows the report

  [[nodiscard]] bool reporting() const { return !report_path.empty(); }
  /// Whether anybody reads the report, so that what takes time to find out belongs into it.
  [[nodiscard]] bool is_read() const { return reporting() || on_page; }

  /// Prints what a command found on stdout; `--report -` puts the report in its place.
  [[nodiscard]] Result<void> print_result(const std::string& text) const;

  /// What the stages so far took together.
  [[nodiscard]] double seconds() const;

  /// With --verbose: a line for each stage that was timed.
  void tell_times();

  /// Runs `stage()` and adds its time to report["seconds"][name].
  template <class Stage>
  auto timed(const char* name, Stage&& stage) {
    const Timer timer(*this, name);
    return stage();
  }

 private:
  class Timer {
   public:
    Timer(Session& session, const char* name) : session_(session), name_(name) {}
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;
    ~Timer() {
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
      Json& entry = session_.report["seconds"][name_];
      entry = (entry.is_number() ? entry.get<double>() : 0.0) + seconds.count();
    }

   private:
    Session& session_;
    const char* name_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  };
};

/// The exit code for an error: 1 usage, 2 file, 3 mesh, 4 tolerance, 5 output, 130 interrupted.
[[nodiscard]] int exit_status(ErrorCode code);

/// Code, message and place of an error.
[[nodiscard]] Json error_json(const Error& error);

/// Adds what every report ends with (times, memory, the failure if there was one) and writes it.
[[nodiscard]] Result<void> finish_report(Session& session, const Error* failure);

}  // namespace surpass::cli

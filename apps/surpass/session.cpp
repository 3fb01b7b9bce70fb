#include "session.hpp"

#include <surpass/io.hpp>

#include <fstream>

#include <fmt/format.h>
#include <sys/resource.h>

#include "signals.hpp"

namespace surpass::cli {

int exit_status(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument:
    case ErrorCode::not_built_in: return 1;
    case ErrorCode::cannot_open:
    case ErrorCode::cannot_read:
    case ErrorCode::unknown_format:
    case ErrorCode::syntax:
    case ErrorCode::unexpected_end:
    case ErrorCode::bad_number:
    case ErrorCode::not_finite:
    case ErrorCode::index_out_of_range:
    case ErrorCode::unsupported: return 2;
    case ErrorCode::empty_mesh:
    case ErrorCode::non_manifold_edge:
    case ErrorCode::inconsistent_orientation:
    case ErrorCode::repeated_vertex:
    case ErrorCode::degenerate_face:
    case ErrorCode::duplicate_face:
    case ErrorCode::too_large:
    case ErrorCode::unsuitable_for_scheme:
    case ErrorCode::singular:
    case ErrorCode::contradictory:
    case ErrorCode::mismatch: return 3;
    case ErrorCode::not_converged: return 4;
    case ErrorCode::cannot_write: return 5;
    case ErrorCode::cancelled: return 130;
  }
  return 1;
}

namespace {

// Of this program alone: what getrusage knows begins with the peak of the process that started it,
// so it is asked only where there is no /proc.
std::uint64_t peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
  }
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

}  // namespace

Result<void> Session::print_result(const std::string& text) const {
  if (report_path == "-") return {};
  return write_file("-", text);
}

double Session::seconds() const {
  double sum = 0;
  for (const Json& stage : report.at("seconds")) sum += stage.get<double>();
  return sum;
}

void Session::tell_times() {
  for (const auto& [stage, seconds] : report["seconds"].items()) {
    console.detail(fmt::format("{:10}{:10.4f} s", stage, seconds.get<double>()));
  }
}

Json error_json(const Error& error) {
  Json json = {{"code", name_of(error.code)},
               {"exit_status", exit_status(error.code)},
               {"message", describe(error)}};
  const Place& place = error.place;
  if (!place.file.empty()) json["file"] = place.file;
  if (place.line) json["line"] = *place.line;
  if (place.column) json["column"] = *place.column;
  if (place.byte) json["byte"] = *place.byte;
  if (place.vertex) json["vertex"] = *place.vertex;
  if (place.face) json["face"] = *place.face;
  if (place.edge) json["edge"] = *place.edge;
  return json;
}

Result<void> finish_report(Session& session, const Error* failure) {
  if (!session.reporting()) return {};
  if (failure != nullptr) session.report["failure"] = error_json(*failure);
  session.report["notes"] = session.console.notes();
  session.report["peak_memory_bytes"] = peak_memory_bytes();
  // File names need not be UTF-8; JSON must be.
  const std::string text = session.report.dump(2, ' ', false, Json::error_handler_t::replace);
  const UnfinishedFile unfinished(session.report_path);
  return write_file(session.report_path, text + "\n");
}

}  // namespace surpass::cli

#include <surpass/result.hpp>

#include <fmt/format.h>

namespace surpass {

const char* name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument: return "invalid-argument";
    case ErrorCode::not_built_in: return "not-built-in";
    case ErrorCode::cannot_open: return "cannot-open";
    case ErrorCode::cannot_read: return "cannot-read";
    case ErrorCode::unknown_format: return "unknown-format";
    case ErrorCode::syntax: return "syntax";
    case ErrorCode::unexpected_end: return "unexpected-end";
    case ErrorCode::bad_number: return "bad-number";
    case ErrorCode::not_finite: return "not-finite";
    case ErrorCode::index_out_of_range: return "index-out-of-range";
    case ErrorCode::unsupported: return "unsupported";
    case ErrorCode::empty_mesh: return "empty-mesh";
    case ErrorCode::non_manifold_edge: return "non-manifold-edge";
    case ErrorCode::inconsistent_orientation: return "inconsistent-orientation";
    case ErrorCode::repeated_vertex: return "repeated-vertex";
    case ErrorCode::degenerate_face: return "degenerate-face";
    case ErrorCode::duplicate_face: return "duplicate-face";
    case ErrorCode::too_large: return "too-large";
    case ErrorCode::unsuitable_for_scheme: return "unsuitable-for-scheme";
    case ErrorCode::singular: return "singular";
    case ErrorCode::contradictory: return "contradictory";
    case ErrorCode::mismatch: return "mismatch";
    case ErrorCode::not_converged: return "not-converged";
    case ErrorCode::cancelled: return "cancelled";
    case ErrorCode::cannot_write: return "cannot-write";
  }
  return "unknown";
}

std::string describe(const Error& error) {
  const Place& place = error.place;
  std::string text;
  if (!place.file.empty()) {
    text += place.file;
    if (place.line) text += fmt::format(":{}", *place.line);
    if (place.line && place.column) text += fmt::format(":{}", *place.column);
    if (place.byte) text += fmt::format(":byte {}", *place.byte);
    text += ": ";
  }
  text += error.message;
  std::string element;
  const auto add = [&](const std::string& part) {
    element += (element.empty() ? "" : ", ") + part;
  };
  if (place.face) add(fmt::format("face {}", *place.face));
  if (place.edge) add(fmt::format("edge {}-{}", (*place.edge)[0], (*place.edge)[1]));
  if (place.vertex) add(fmt::format("vertex {}", *place.vertex));
  if (!element.empty()) text += fmt::format(" ({}, counted from 0)", element);
  return text;
}

}  // namespace surpass

// What the fuzzers ask of the readers and writers.
#pragma once

#include <surpass/io.hpp>

#include <string>
#include <string_view>

namespace surpass {

/// Parses any bytes. They are refused with a sentence and a place, or give a mesh whose numbers are
/// in range and which a PLY or OBJ file holds: written and read again, it is written as before.
/// Returns "" or what went wrong.
[[nodiscard]] std::string complaint_about(std::string_view bytes, Format format);

}  // namespace surpass

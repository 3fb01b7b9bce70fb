#include "vertex_list.hpp"

#include <surpass/io.hpp>

#include <algorithm>
#include <charconv>
#include <sstream>

#include <fmt/format.h>

namespace surpass::cli {

namespace {

/// Appends the numbers of one line.
Result<void> parse_line(std::string_view line, Index vertex_count, Place place,
                        std::vector<Index>& vertices) {
  constexpr char kSpace[] = " \t\r\v\f";
  line = line.substr(0, line.find('#'));
  for (std::size_t at = 0; (at = line.find_first_not_of(kSpace, at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
    const std::string_view word = line.substr(at, end - at);
    place.column = at + 1;
    Index vertex = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), vertex);
    if (error != std::errc() || stop != word.data() + word.size()) {
      return fail(ErrorCode::syntax, fmt::format("'{}' is not a vertex number", word), place);
    }
    if (vertex >= vertex_count) {
      return fail(ErrorCode::index_out_of_range,
                  fmt::format("there is no vertex {}: the mesh has {}, counted from 0", vertex,
                              vertex_count),
                  place);
    }
    vertices.push_back(vertex);
    at = end;
  }
  return {};
}

}  // namespace

Result<std::vector<Index>> read_vertex_list(const std::string& path, Index vertex_count) {
  Place place{.file = path};
  const Result<std::string> text = read_file(path);
  if (!text) return tl::make_unexpected(text.error());
  std::istringstream file(*text);
  std::vector<Index> vertices;
  std::uint64_t number = 0;
  for (std::string line; std::getline(file, line);) {
    place.line = ++number;
    const auto parsed = parse_line(line, vertex_count, place, vertices);
    if (!parsed) return tl::make_unexpected(parsed.error());
  }
  if (vertices.empty()) {
    return fail(ErrorCode::unexpected_end,
                "names no vertex; write the numbers of those to interpolate, counted from 0",
                Place{.file = path});
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace surpass::cli

#include "targets_file.hpp"

#include <surpass/io.hpp>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

namespace surpass::cli {

namespace {

struct Word {
  std::string text;
  Place place;
};

Result<std::vector<Word>> read_words(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return tl::make_unexpected(text.error());
  std::istringstream file(*text);
  constexpr char kSpace[] = " \t\r\v\f";
  std::vector<Word> words;
  std::uint64_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    line.resize(std::min(line.find('#'), line.size()));
    for (std::size_t at = 0; (at = line.find_first_not_of(kSpace, at)) != std::string::npos;) {
      const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
      words.push_back(
          {line.substr(at, end - at), Place{.file = path, .line = number, .column = at + 1}});
      at = end;
    }
  }
  return words;
}

Result<Index> vertex_of(const Word& word, Index vertex_count) {
  char* end = nullptr;
  const double number = std::strtod(word.text.c_str(), &end);
  if (*end != '\0' || !(number >= 0) || number != std::floor(number)) {
    return fail(ErrorCode::syntax, fmt::format("'{}' is not a vertex number", word.text),
                word.place);
  }
  if (number >= vertex_count) {
    return fail(ErrorCode::index_out_of_range,
                fmt::format("there is no vertex {}: the mesh has {}, counted from 0", word.text,
                            vertex_count),
                word.place);
  }
  return static_cast<Index>(number);
}

}  // namespace

Result<std::vector<LineTarget>> read_targets(const std::string& path, Index vertex_count) {
  const auto words = read_words(path);
  if (!words) return tl::make_unexpected(words.error());
  std::vector<LineTarget> targets;
  for (std::size_t i = 0; i < words->size(); i += 2) {
    const auto vertex = vertex_of((*words)[i], vertex_count);
    if (!vertex) return tl::make_unexpected(vertex.error());
    if (i + 1 == words->size()) {
      return fail(ErrorCode::unexpected_end,
                  fmt::format("vertex {} has no position along its line", *vertex),
                  (*words)[i].place);
    }
    const Word& position = (*words)[i + 1];
    char* end = nullptr;
    const double along = std::strtod(position.text.c_str(), &end);
    if (*end != '\0' || !std::isfinite(along)) {
      return fail(ErrorCode::bad_number, fmt::format("'{}' is not a number", position.text),
                  position.place);
    }
    targets.push_back({*vertex, along});
  }
  if (targets.empty()) {
    return fail(ErrorCode::unexpected_end,
                "names no target; write pairs of a vertex number, counted from 0, and a position "
                "along its line (0: the vertex, 1: the centroid of its neighbours)",
                Place{.file = path});
  }
  return targets;
}

}  // namespace surpass::cli

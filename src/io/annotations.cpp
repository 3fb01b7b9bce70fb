#include "io/annotations.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace surpass::io {
namespace {

constexpr std::string_view kMark = "surpass";
constexpr std::string_view kBlanks = " \t\r\n";

std::string_view next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  return word;
}

bool can_be_held(std::string_view text) {
  if (text.empty()) return false;
  for (const char c : text) {
    if (c <= ' ' || c == '=' || c == '#' || c == '\\') return false;
  }
  return true;
}

}  // namespace

bool read_annotations(std::string_view comment, Mesh& mesh) {
  if (next_word(comment) != kMark) return false;
  std::vector<std::pair<std::string_view, std::string_view>> found;
  for (std::string_view word = next_word(comment); !word.empty(); word = next_word(comment)) {
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos)
      return false;  // a sentence that happens to begin with our name
    found.emplace_back(word.substr(0, equals), word.substr(equals + 1));
  }
  for (const auto& [key, value] : found) mesh.annotate(key, value);
  return !found.empty();
}

std::string annotation_comment(const Mesh& mesh, std::vector<std::string>& notes) {
  std::string text;
  for (const auto& [key, value] : mesh.annotations) {
    if (can_be_held(key) && can_be_held(value)) {
      text += fmt::format(" {}={}", key, value);
    } else {
      notes.push_back(
          fmt::format("the annotation '{}' is left out: a comment cannot hold it", key));
    }
  }
  return text.empty() ? text : std::string(kMark) + text;
}

}  // namespace surpass::io

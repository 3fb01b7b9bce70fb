// Which format a file has: by its name, or by its first bytes.
#include "io/formats.hpp"

#include <algorithm>
#include <array>

#include "io/readers.hpp"

namespace surpass {
namespace {

struct FormatName {
  Format format;
  const char* name;
};
constexpr FormatName kNames[] = {{Format::automatic, "automatic"},
                                 {Format::obj, "obj"},
                                 {Format::ply, "ply"},
                                 {Format::off, "off"},
                                 {Format::stl, "stl"},
                                 {Format::xyz, "xyz"},
                                 {Format::xyz, "pwn"},
                                 {Format::xyz, "pts"}};

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

}  // namespace

const char* name_of(Format format) {
  for (const FormatName& known : kNames) {
    if (known.format == format) return known.name;
  }
  return "automatic";
}

Format format_named(std::string_view name) {
  const std::string wanted = lower_case(name);
  for (const FormatName& known : kNames) {
    if (wanted == known.name) return known.format;
  }
  return Format::automatic;
}

Format format_of_path(std::string_view path) {
  const std::string_view file = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = file.find_last_of('.');
  return dot == file.npos ? Format::automatic : format_named(file.substr(dot + 1));
}

namespace io {

Format format_of_bytes(std::string_view bytes) {
  Scanner scan(bytes, "", '#');
  scan.skip_space();
  const std::string_view word = scan.word();
  if (word == "ply") return Format::ply;
  if (is_binary_stl(bytes)) return Format::stl;
  const std::size_t off = word.substr(0, 8).find("OFF");
  if (off != word.npos && word.substr(0, off).find_first_not_of("STCN4n") == word.npos) {
    return Format::off;
  }
  if (lower_case(word) == "solid") return Format::stl;
  constexpr std::array kObjWords = {"v", "vt", "vn", "f", "g", "o", "mtllib", "usemtl"};
  const bool obj = std::find(kObjWords.begin(), kObjWords.end(), word) != kObjWords.end();
  return obj ? Format::obj : Format::automatic;
}

}  // namespace io
}  // namespace surpass

#include "io/obj_tags.hpp"

#include <fmt/format.h>

namespace surpass::io {
namespace {

struct Arguments {
  std::vector<std::uint64_t> ints;
  std::vector<float> floats;
};

// "2/1/0": how many arguments of each type follow.
bool read_counts(Scanner& scan, std::uint64_t (&counts)[3]) {
  const char* start = scan.at();
  for (int k = 0; k < 3; ++k) {
    if (!scan.digits(counts[k]) || (k < 2 && scan.peek() != '/')) {
      scan.move_to(start);
      return scan.fail(
          ErrorCode::syntax,
          fmt::format("expected the tag's argument counts, such as 2/1/0, but found {}",
                      quoted(scan.word())),
          start);
    }
    if (k < 2) scan.advance(1);
  }
  return true;
}

bool read_arguments(Scanner& scan, Numbered& named, Arguments& arguments) {
  std::uint64_t counts[3] = {};
  scan.skip_blanks();
  if (!read_counts(scan, counts)) return false;
  for (std::uint64_t k = 0; k < counts[0]; ++k) {
    scan.skip_blanks();
    const char* place = scan.at();
    std::uint64_t number = 0;
    if (!scan.whole(number, "the number of a vertex or face")) return false;
    named.name_it(number, place);
    arguments.ints.push_back(number);
  }
  for (std::uint64_t k = 0; k < counts[1]; ++k) {
    scan.skip_blanks();
    const char* place = scan.at();
    float sharpness = 0;
    if (!scan.number(sharpness, "a sharpness")) return false;
    if (sharpness < 0) {
      return scan.fail(ErrorCode::syntax,
                       "a sharpness is negative; give 0 for smooth, up to 10 for infinitely sharp",
                       place);
    }
    arguments.floats.push_back(sharpness);
  }
  return true;
}

// One sharpness for all, or one each.
bool sharpness_fits(Scanner& scan, const Arguments& arguments, std::size_t items,
                    const char* place) {
  if (arguments.floats.size() == 1 || arguments.floats.size() == items) return true;
  return scan.fail(ErrorCode::syntax,
                   fmt::format("the tag names {} edges or vertices and {} sharpnesses; give one "
                               "sharpness for all, or one each",
                               items, arguments.floats.size()),
                   place);
}

float sharpness_of(const Arguments& arguments, std::size_t item) {
  return arguments.floats.size() == 1 ? arguments.floats[0] : arguments.floats[item];
}

bool read_creases(Scanner& scan, Numbered& vertices, Mesh& mesh, const char* line) {
  Arguments arguments;
  if (!read_arguments(scan, vertices, arguments)) return false;
  if (arguments.ints.size() % 2 != 0) {
    return scan.fail(ErrorCode::syntax,
                     "a crease is named by pairs of vertices; one has no partner", line);
  }
  const std::size_t pairs = arguments.ints.size() / 2;
  if (!sharpness_fits(scan, arguments, pairs, line)) return false;
  for (std::size_t k = 0; k < pairs; ++k) {
    mesh.creases.push_back(
        {{static_cast<Index>(arguments.ints[2 * k]), static_cast<Index>(arguments.ints[2 * k + 1])},
         sharpness_of(arguments, k)});
  }
  return scan.end_line();
}

bool read_corners(Scanner& scan, Numbered& vertices, Mesh& mesh, const char* line) {
  Arguments arguments;
  if (!read_arguments(scan, vertices, arguments)) return false;
  if (!sharpness_fits(scan, arguments, arguments.ints.size(), line)) return false;
  for (std::size_t k = 0; k < arguments.ints.size(); ++k) {
    mesh.corners.push_back({static_cast<Index>(arguments.ints[k]), sharpness_of(arguments, k)});
  }
  return scan.end_line();
}

bool read_holes(Scanner& scan, Numbered& faces, Mesh& mesh) {
  Arguments arguments;
  if (!read_arguments(scan, faces, arguments)) return false;
  for (const std::uint64_t face : arguments.ints) {
    mesh.hole_faces.push_back(static_cast<Index>(face));
  }
  return scan.end_line();
}

}  // namespace

bool read_obj_tag(Scanner& scan, Numbered& vertices, Numbered& faces, Mesh& mesh,
                  std::vector<std::string>& notices) {
  const char* line = scan.at();
  scan.skip_blanks();
  const std::string_view name = scan.word();
  if (name == "crease") return read_creases(scan, vertices, mesh, line);
  if (name == "corner") return read_corners(scan, vertices, mesh, line);
  if (name == "hole") return read_holes(scan, faces, mesh);
  scan.move_to(line);
  const std::string text(scan.rest_of_line());
  if (name == "creasemethod" && text.find("chaikin") != std::string::npos) {
    notices.emplace_back("the crease method 'chaikin' is treated as uniform");
  }
  mesh.tags.push_back("t " + text);
  return scan.end_line();
}

}  // namespace surpass::io

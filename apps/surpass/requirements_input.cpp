#include "requirements_input.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "mesh_input.hpp"
#include "requirements_file.hpp"

namespace surpass::cli {

namespace {

constexpr const char* kGivenNormals = "given";

/// The normals that a file has for its vertices, or for their faces' corners where these agree at a
/// vertex; zeros at other vertices. Nothing if it has none at all.
std::optional<std::vector<Point>> vertex_normals(const Mesh& mesh) {
  std::vector<Point> normals(mesh.points.size());
  const auto is_normal = [](const auto& c) { return c.name == "normal"; };
  const auto channel = std::find_if(mesh.channels.begin(), mesh.channels.end(), is_normal);
  if (channel != mesh.channels.end() && channel->width() == 3) {
    std::copy(channel->values.begin(), channel->values.end(), flat(std::span(normals)).begin());
    return normals;
  }
  const auto& of_corners = mesh.corner_channels;
  const auto corners = std::find_if(of_corners.begin(), of_corners.end(), is_normal);
  if (corners == of_corners.end() || corners->width != 3) return std::nullopt;
  std::vector<unsigned char> seen(normals.size(), 0);
  for (Index c = 0; c < mesh.corner_count(); ++c) {
    const Index row = corners->indices[c];
    Point here = {};
    if (row != kNone) std::copy_n(&corners->values[std::size_t{3} * row], 3, here.begin());
    const Index v = mesh.face_vertices[c];
    if (std::exchange(seen[v], 1) == 0) {
      normals[v] = here;
    } else if (normals[v] != here) {
      normals[v] = {};
    }
  }
  return normals;
}

Result<std::vector<Point>> normals_for(const Mesh& given, const std::string& path,
                                       Session& session) {
  std::optional<LoadedMesh> other;
  if (path != kGivenNormals) {
    Result<LoadedMesh> loaded = load_mesh(path, Format::automatic, session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    other = std::move(*loaded);
  }
  auto normals = vertex_normals(other ? other->mesh : given);
  if (!normals || normals->size() != given.points.size()) {
    return fail(ErrorCode::mismatch,
                other ? fmt::format("{} has no normals for the {} vertices of the given mesh", path,
                                    given.points.size())
                      : "the given file has no normals");
  }
  return std::move(*normals);
}

void reverse(std::vector<Point>& normals) {
  for (double& c : flat(std::span(normals))) c = -c;
}

}  // namespace

void RequirementsInput::define(Options& options, const std::string& group,
                               const std::string& more) {
  options
      .add("--requirements", list_path_,
           "Normals, derivatives and points that the surface shall have, given vertices to move or "
           "to let go: JSON, as docs/requirements.schema.json says" +
               more)
      .type_name("FILE")
      .group(group);
  const Option normals =
      options
          .add("--normals", normals_path_,
               "The surface shall have the vertex normals of this mesh, vertex by vertex; or "
               "given: those of the given file")
          .type_name("MESH")
          .group(group);
  options
      .flag("--reverse-normals", reverse_normals_,
            "Take these normals with the opposite sign: for files that have them point inward")
      .needs(normals)
      .group(group);
}

std::vector<std::string> RequirementsInput::inputs() const {
  std::vector<std::string> paths;
  for (const std::string& path : {list_path_, normals_path_}) {
    if (!path.empty() && path != kGivenNormals) paths.push_back(path);
  }
  return paths;
}

Result<std::vector<Requirement>> RequirementsInput::load_list(const Mesh& given,
                                                              Session& session) const {
  auto read = read_requirements(list_path_);
  if (!read) return read;
  if (auto fit = check_requirements(given, *read); !fit) {
    // It is the file that is wrong, as where it is no list.
    return fail(ErrorCode::syntax, fit.error().message, Place{.file = list_path_});
  }
  if (session.report.contains("mended")) {
    session.console.note(
        fmt::format("vertices and faces in {} are counted in the mended mesh", list_path_));
  }
  return read;
}

Result<std::vector<Requirement>> RequirementsInput::load_normals(const Mesh& given,
                                                                 const Rules& rules,
                                                                 Session& session) const {
  auto normals = normals_for(given, normals_path_, session);
  if (!normals) return tl::make_unexpected(normals.error());
  if (reverse_normals_) reverse(*normals);
  auto everywhere = normals_everywhere(given, rules, *normals);
  if (!everywhere && everywhere.error().code == ErrorCode::mismatch) {
    everywhere.error().message += fmt::format(
        "; {}", reverse_normals_ ? "leave out --reverse-normals" : "try --reverse-normals");
  }
  if (everywhere && everywhere->size() < given.points.size()) {
    session.console.note(fmt::format(
        "a normal is required at {} of {} vertices; the others have none in the file, or the "
        "surface has none there: they are on creases, at corners or without faces",
        everywhere->size(), given.points.size()));
  }
  return everywhere;
}

Result<std::vector<Requirement>> RequirementsInput::load(const Mesh& given, const Rules& rules,
                                                         Session& session) const {
  std::vector<Requirement> requirements;
  if (lists()) {
    auto list = load_list(given, session);
    if (!list) return list;
    requirements = std::move(*list);
  }
  if (names_normals()) {
    const auto normals = load_normals(given, rules, session);
    if (!normals) return normals;
    if (lists()) {
      session.console.note(fmt::format("requirements from number {} on are those of --normals",
                                       requirements.size()));
    }
    requirements.insert(requirements.end(), normals->begin(), normals->end());
  }
  return requirements;
}

Json outcomes_json(const std::vector<Requirement>& requirements,
                   const std::vector<RequirementOutcome>& outcomes) {
  Json list = Json::array();
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    Json entry = {{"what", describe(requirements[i])}, {"error", outcomes[i].error}};
    const Requirement::Kind kind = requirements[i].kind;
    if (kind == Requirement::Kind::normal || kind == Requirement::Kind::direction) {
      entry["angle"] = outcomes[i].angle;
      entry["flipped"] = outcomes[i].flipped;
    }
    if (outcomes[i].length_chosen) entry["length_chosen"] = true;
    if (outcomes[i].without_plane) entry["without_plane"] = true;
    list.push_back(std::move(entry));
  }
  return list;
}

std::size_t worst_of(const std::vector<RequirementOutcome>& outcomes) {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < outcomes.size(); ++i) {
    if (!(outcomes[i].error <= outcomes[worst].error)) worst = i;
  }
  return worst;
}

std::string why_missed(const std::vector<Requirement>& requirements,
                       const std::vector<RequirementOutcome>& outcomes, double tolerance) {
  if (all_met(outcomes, tolerance)) return "";
  const auto flipped =
      std::find_if(outcomes.begin(), outcomes.end(), std::mem_fn(&RequirementOutcome::flipped));
  const bool turned = flipped != outcomes.end();
  const std::size_t i =
      turned ? static_cast<std::size_t>(flipped - outcomes.begin()) : worst_of(outcomes);
  const std::string what = fmt::format("requirement {} ({})", i, describe(requirements[i]));
  if (turned) {
    return what +
           " points the other way, and no surface was found where it does not; leave out "
           "some of those nearby";
  }
  return fmt::format(
      "{} is missed by {:.3g} of the box side, by rounding, which more iterations would not mend; "
      "ask for what the surface can do there, in numbers of the size of the mesh",
      what, outcomes[i].error);
}

}  // namespace surpass::cli

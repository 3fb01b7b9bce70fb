// surpass view FILE...
//
// A page of the meshes in a temporary file, opened in the browser where there is one.
#include <surpass/topology.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "command.hpp"
#include "html_report.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "rules_option.hpp"

namespace surpass::cli {

namespace {

namespace fs = std::filesystem;

Result<std::string> temporary_page(const std::string& input) {
  std::error_code failed;
  const fs::path folder = fs::temp_directory_path(failed);
  std::string pattern = ((failed ? fs::path("/tmp") : folder) / "surpass-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    return fail(ErrorCode::cannot_write, fmt::format("no folder can be made in '{}'",
                                                     fs::path(pattern).parent_path().string()));
  }
  const std::string stem = fs::path(input).stem().string();
  return pattern + "/" + (stem.empty() || stem == "-" ? "mesh" : stem) + ".html";
}

/// Whether a browser was started: only where there is a screen to see it on.
bool open_in_browser(const std::string& path) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return false;
  std::string program = "xdg-open";
  std::string argument = path;
  const std::array<char*, 3> arguments = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0) {
    return false;
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

class View : public Command {
 public:
  void define(Options& options) override {
    options.add("FILES", paths_, "Meshes, or points; of control meshes the limit surface, too")
        .required();
    rules_.define(options, {});
    options.add("--html", path_, "Write the page to this file; by default to a temporary one")
        .type_name("FILE")
        .group("Output");
    options.flag("--no-browser", no_browser_, "Only print where the page is").group("Output");
    options.examples(
        "The limit surface is shown of meshes that surpass wrote as control meshes, and of all "
        "with\n"
        "--scheme. Opens the page by xdg-open where there is a screen, and prints its path.\n\n"
        "Examples:\n"
        "  surpass view given.obj control.obj\n"
        "  surpass view cage.off --scheme catmull-clark --no-browser\n");
  }

  Result<void> run(Session& session) override {
    if (const auto checked = check_report_path(session, paths_); !checked) return checked;
    if (path_.empty()) {
      auto chosen = temporary_page(paths_.front());
      if (!chosen) return tl::make_unexpected(chosen.error());
      path_ = *chosen;
    }
    page_.set_path(path_);
    if (const auto ready = page_.prepare(session, paths_, {}); !ready) return ready;
    session.report["files"] = Json::array();
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (const auto added = add(i, session); !added) return added;
    }
    if (const auto written = page_.write(session); !written) return written;
    if (const auto printed = session.print_result(path_ + "\n"); !printed) return printed;
    if (!no_browser_) static_cast<void>(open_in_browser(path_));
    return {};
  }

 private:
  Result<void> add(std::size_t i, Session& session) {
    const std::string& path = paths_[i];
    const bool points = format_of_path(path) == Format::xyz;
    const Result<LoadedMesh> loaded = points ? load_points(path, Format::automatic, session)
                                             : load_mesh(path, Format::automatic, session);
    if (!loaded) return tl::make_unexpected(loaded.error());
    const Mesh& mesh = loaded->mesh;
    const std::string name = path == "-" ? "standard input" : fs::path(path).filename().string();
    session.report["files"].push_back(
        {{"path", path}, {"vertices", mesh.vertex_count()}, {"faces", mesh.face_count()}});
    const std::string id = fmt::format("file{}", i);
    if (mesh.face_count() == 0) {
      page_.add(id.c_str(), name, LayerKind::points, mesh);
      return {};
    }
    if (const auto topology = Topology::build(mesh); !topology) {
      session.console.note(
          fmt::format("{} is shown as it is: {}", path, describe(topology.error())));
      page_.add(id.c_str(), name, LayerKind::mesh, mesh);
      return {};
    }
    page_.add(id.c_str(), name, has_normals(mesh) ? LayerKind::surface : LayerKind::mesh, mesh);
    if (mesh.annotation("scheme").empty() && !rules_.names_scheme()) return {};
    Mesh control = mesh;
    control.channels.clear();
    const Rules rules = rules_.choose(mesh, session);
    return page_.add_limit((id + "-limit").c_str(), name + ", limit surface", control, rules,
                           session.context);
  }

  static bool has_normals(const Mesh& mesh) {
    return std::any_of(mesh.channels.begin(), mesh.channels.end(), [](const Channel& channel) {
      return channel.name == "normal" && channel.width() == 3;
    });
  }

  std::vector<std::string> paths_;
  std::string path_;
  RulesOption rules_;
  HtmlReport page_;
  bool no_browser_ = false;
};

}  // namespace

std::unique_ptr<Command> make_view() { return std::make_unique<View>(); }

}  // namespace surpass::cli

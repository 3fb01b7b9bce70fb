#include "mesh_output.hpp"

#include <algorithm>
#include <filesystem>
#include <span>

#include <fmt/format.h>
#include <unistd.h>

#include "mesh_input.hpp"
#include "signals.hpp"

namespace surpass::cli {

namespace {

namespace fs = std::filesystem;

// Where a file would be made that is not there yet: links lead on, even to nothing.
fs::path destination(const fs::path& path) {
  constexpr int kMostLinks = 40;  // as many as the system follows
  std::error_code ignored;
  fs::path at = fs::absolute(path, ignored);
  for (int k = 0; k < kMostLinks && fs::is_symlink(at, ignored); ++k) {
    at = at.parent_path() / fs::read_symlink(at, ignored);  // an absolute one takes its place
  }
  return fs::weakly_canonical(at, ignored);
}

bool same_file(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") return false;
  std::error_code ignored;
  if (fs::equivalent(a, b, ignored)) return fs::is_regular_file(a, ignored);
  return !fs::exists(a, ignored) && destination(a) == destination(b);
}

Result<void> check_folder(const std::string& path) {
  if (path == "-") return {};
  std::error_code ignored;
  const fs::path parent = fs::path(path).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  const Place place{.file = path};
  if (!fs::is_directory(folder, ignored)) {
    return fail(ErrorCode::cannot_write, "its folder does not exist; make it first", place);
  }
  if (fs::is_directory(path, ignored)) {
    return fail(ErrorCode::cannot_write, "is a folder; name a file in it", place);
  }
  if (!fs::exists(path, ignored) && access(folder.c_str(), W_OK) != 0) {
    return fail(ErrorCode::cannot_write, "its folder is not writable; choose another", place);
  }
  return {};
}

/// The formats that files can be written in, for messages.
constexpr char kEndings[] = ".obj, .ply, .off or .stl";
constexpr char kPointEndings[] = ".ply, .xyz, .obj or .off";

/// Files are written one by one: if one cannot be, the user is told which ones are there.
Error beside_what_is_written(Error error, const Session& session) {
  if (!session.report.contains("outputs")) return error;
  std::string names;
  for (const Json& output : session.report["outputs"]) {
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", output["path"].get<std::string>());
  }
  error.message += fmt::format(" (already written: {})", names);
  return error;
}

/// XYZ has no faces: a mesh is not meant to be written there.
Format format_for_meshes(const std::string& path) {
  const Format format = format_of_path(path);
  return format == Format::xyz ? Format::automatic : format;
}

}  // namespace

Result<void> check_paths(const std::vector<std::string>& inputs,
                         const std::vector<std::string>& outputs, bool force) {
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    return fail(ErrorCode::invalid_argument, "only one input can be '-', the standard input");
  }
  if (std::count(outputs.begin(), outputs.end(), "-") > 1) {
    return fail(ErrorCode::invalid_argument, "only one output can be '-', the standard output");
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (same_file(outputs[i], outputs[j])) {
        return fail(ErrorCode::invalid_argument,
                    fmt::format("is the same file as '{}'; give each output its own", outputs[j]),
                    {.file = outputs[i]});
      }
    }
    for (const std::string& input : inputs) {
      if (!force && same_file(outputs[i], input)) {
        return fail(ErrorCode::invalid_argument,
                    "is an input; write to another file, or add --force to replace it",
                    {.file = outputs[i]});
      }
    }
    if (const auto checked = check_folder(outputs[i]); !checked) return checked;
  }
  return {};
}

Result<void> check_report_path(const Session& session, const std::vector<std::string>& inputs) {
  if (!session.reporting()) return check_paths(inputs, {}, false);
  return check_paths(inputs, {session.report_path}, false);
}

Result<void> write_bytes(const std::string& path, std::string_view bytes, Session& session) {
  if (session.context.cancelled()) return fail(ErrorCode::cancelled, "interrupted");
  const UnfinishedFile unfinished(path);
  const auto done = session.timed("write", [&] { return write_file(path, bytes); });
  return done ? done : tl::make_unexpected(beside_what_is_written(done.error(), session));
}

void MeshOutput::define(Options& options, const std::string& name, const std::string& description) {
  options.add(name, path_, description + "; '-' is the standard output")
      .required()
      .type_name("FILE")
      .group(name.starts_with('-') ? "Output" : "Positionals");
  options
      .choice(
          "--to", options_.format, {Format::obj, Format::ply, Format::off, Format::stl},
          "Format of the output, for '-' or to overrule the file's ending; '-' without it takes "
          "the format of the input")
      .group("Output");
  Option ascii = options.flag("--ascii", ascii_, "PLY and STL as text").group("Output");
  options.flag("--binary", binary_, "PLY and STL as bytes, little-endian (the default)")
      .excludes(ascii)
      .group("Output");
  options
      .flag("--single", options_.single_precision,
            "PLY: 32-bit positions; half the size, about 7 digits")
      .group("Output");
  options.flag("--force", force_, "Allow the output to replace an input file").group("Output");
}

Result<void> MeshOutput::prepare(const Session& session, const std::vector<std::string>& inputs,
                                 const std::vector<std::string>& further_outputs,
                                 const std::vector<std::string>& point_outputs) {
  std::vector<std::string> outputs = {path_};
  outputs.insert(outputs.end(), further_outputs.begin(), further_outputs.end());
  outputs.insert(outputs.end(), point_outputs.begin(), point_outputs.end());
  if (session.reporting()) outputs.push_back(session.report_path);
  if (const auto checked = check_paths(inputs, outputs, force_); !checked) return checked;

  if (options_.format == Format::automatic) options_.format = format_for_meshes(path_);
  if (options_.format == Format::automatic && path_ != "-") {
    return fail(ErrorCode::invalid_argument,
                fmt::format("'{}' does not name a format; end it in {}, or say --to FORMAT", path_,
                            kEndings));
  }
  for (const std::string& path : further_outputs) {
    if (path != "-" && format_for_meshes(path) == Format::automatic) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("'{}' does not name a format; end it in {}", path, kEndings));
    }
  }
  for (const std::string& path : point_outputs) {
    const Format format = path == "-" ? options_.format : format_of_path(path);
    if (format == Format::automatic) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("'{}' does not name a format; end it in {}", path, kPointEndings));
    }
    if (format == Format::stl) {
      return fail(
          ErrorCode::invalid_argument,
          fmt::format("'{}' would be STL, which holds triangles only, no points; write them "
                      "to a file that ends in {}",
                      path, kPointEndings));
    }
  }
  if (ascii_) options_.encoding = Encoding::ascii;
  if (binary_) options_.encoding = Encoding::little_endian;
  return {};
}

void MeshOutput::default_format(Format format_of_input) {
  if (options_.format == Format::automatic) options_.format = format_of_input;
}

Result<void> MeshOutput::write(const Mesh& mesh, Session& session) const {
  return write(mesh, path_, session);
}

Format MeshOutput::format_at(const std::string& path) const {
  return path == path_ || path == "-" ? options_.format : format_of_path(path);
}

Result<void> MeshOutput::check(const Mesh& mesh, const std::string& path) const {
  auto fits = check_faces(mesh, format_at(path));
  if (!fits) fits.error().place.file = path;
  return fits;
}

Result<void> MeshOutput::check_as_read(const Mesh& mesh) const {
  auto fits = check(mesh, path_);
  if (!fits) fits.error().message += fmt::format("; {}", kCutPolygons);
  return fits;
}

Result<void> MeshOutput::check_refined(const Mesh& mesh, Scheme scheme, int levels,
                                       const std::string& path) const {
  if (levels == 0 || scheme == Scheme::loop) return check(mesh, path);
  if (format_at(path) != Format::stl) return {};
  return fail(
      ErrorCode::unsuitable_for_scheme,
      fmt::format("STL holds triangles only, and {} makes other faces; write another format",
                  name_of(scheme)),
      Place{.file = path});
}

Result<void> MeshOutput::write(const Mesh& mesh, const std::string& path, Session& session) const {
  if (session.context.cancelled()) return fail(ErrorCode::cancelled, "interrupted");
  WriteOptions options = options_;
  options.format = format_at(path);
  const UnfinishedFile unfinished(path);
  const auto lost = session.timed("write", [&] { return write_mesh(mesh, path, options); });
  if (!lost) return tl::make_unexpected(beside_what_is_written(lost.error(), session));
  session.console.notes(*lost);
  session.report["outputs"].push_back({{"path", path},
                                       {"format", name_of(options.format)},
                                       {"vertices", mesh.vertex_count()},
                                       {"faces", mesh.face_count()}});
  return {};
}

bool MeshOutput::rounds() const {
  return rounds_positions(options_.format, options_.single_precision);
}

std::vector<Point> MeshOutput::stored(std::span<const Point> points) const {
  return stored_positions(points, options_.format, options_.single_precision);
}

}  // namespace surpass::cli

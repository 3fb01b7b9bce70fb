#include "mesh_input.hpp"

#include <surpass/repair.hpp>
#include <surpass/topology.hpp>

namespace surpass::cli {

void Mending::define(Options& options) {
  options
      .flag("--repair", repair_,
            "Drop degenerate and repeated faces, turn faces so that neighbours agree, and split "
            "what is still non-manifold")
      .group("Mending");
  options
      .add("--weld", weld_,
           "First merge vertices closer than EPS times the largest side of the bounding box; "
           "0 merges equal coordinates only")
      .in_range(0.0, 1.0)
      .type_name("EPS")
      .group("Mending");
  options
      .flag("--triangulate", triangulate_, "Last cut polygons into triangles, without new vertices")
      .group("Mending");
}

Result<void> Mending::apply(Mesh& mesh, Session& session) const {
  const auto accept = [&](Mended mended) {
    for (const std::string& sentence : mended.done) {
      session.console.note(sentence);
      session.report["mended"].push_back(sentence);
    }
    mesh = std::move(mended.mesh);
  };
  if (weld_ >= 0) {
    Result<Mended> welded = weld(mesh, weld_ * bounding_box(mesh.points).side());
    if (!welded) return tl::make_unexpected(welded.error());
    accept(std::move(*welded));
  }
  if (repair_) accept(repair(mesh));
  if (triangulate_) accept(triangulate(mesh));
  return {};
}

void MeshInput::define(Options& options, const std::string& name, const std::string& description) {
  options.add(name, path_, description + "; '-' is the standard input").required();
  add_from(options, format_,
           "Format of the input, for '-' or to overrule the file's bytes and name");
  mending_.define(options);
}

Result<LoadedMesh> MeshInput::load(Session& session) const {
  Result<LoadedMesh> loaded = load_mesh(path_, format_, session);
  if (!loaded) return loaded;
  const Result<void> mended = mending_.apply(loaded->mesh, session);
  if (!mended) return tl::make_unexpected(mended.error());
  if (session.is_read()) session.report["input"] = mesh_json(path_, loaded->mesh);
  return loaded;
}

void add_from(Options& options, Format& format, const std::string& description) {
  options
      .choice("--from", format, {Format::obj, Format::ply, Format::off, Format::stl}, description)
      .group("Input");
}

void add_from_points(Options& options, Format& format, const std::string& description) {
  options
      .choice("--from", format, {Format::ply, Format::xyz, Format::obj, Format::off, Format::stl},
              description)
      .group("Input");
}

namespace {

Result<LoadedMesh> load(const std::string& path, Format format, Session& session,
                        Result<LoadedMesh> (*read)(const std::string&, Format)) {
  Result<LoadedMesh> loaded = session.timed("read", [&] { return read(path, format); });
  if (session.context.cancelled()) return fail(ErrorCode::cancelled, "interrupted");
  if (!loaded && loaded.error().code == ErrorCode::unknown_format) {
    loaded.error().message += "; name it with --from";
  }
  if (loaded) session.console.notes(loaded->notices);
  return loaded;
}

}  // namespace

Result<LoadedMesh> load_points(const std::string& path, Format format, Session& session) {
  return load(path, format, session, read_points);
}

Result<LoadedMesh> load_mesh(const std::string& path, Format format, Session& session) {
  return load(path, format, session, read_mesh);
}

Json mesh_json(const std::string& path, const Mesh& mesh) {
  Json json = {{"path", path}, {"vertices", mesh.vertex_count()}, {"faces", mesh.face_count()}};
  if (const Result<Topology> topology = Topology::build(mesh)) {
    json["components"] = find_components(*topology).count;
    json["boundary_loops"] = boundary_loops(*topology).size();
  }
  json["box_side"] = bounding_box(mesh.points).side();
  return json;
}

std::string remedy(const Error& error) {
  switch (error.code) {
    case ErrorCode::non_manifold_edge: return "--repair splits such edges";
    case ErrorCode::inconsistent_orientation: return "--repair turns such faces";
    case ErrorCode::repeated_vertex: return "--repair mends such faces";
    case ErrorCode::degenerate_face:
    case ErrorCode::duplicate_face: return "--repair drops such faces";
    case ErrorCode::unsuitable_for_scheme:
      // It cuts what is read: what is to be written may have polygons all the same.
      return error.place.face && error.place.file.empty() ? kCutPolygons : "";
    case ErrorCode::singular: return "--skip-component N leaves component N as it is";
    default: return {};
  }
}

}  // namespace surpass::cli

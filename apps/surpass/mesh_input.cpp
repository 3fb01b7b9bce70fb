#include "mesh_input.hpp"

#include "arguments.hpp"

#include <surpass/repair.hpp>
#include <surpass/topology.hpp>

namespace surpass::cli {

void add_from(CLI::App& app, Format& format) {
  add_choice(app, "--from", format, {Format::obj, Format::ply, Format::off, Format::stl},
             "Format of the input, for '-' or to overrule the file's own bytes and name")
      ->group("Input");
}

void MeshInput::define(CLI::App& app, const std::string& name, const std::string& description) {
  app.add_option(name, path_, description + "; '-' is the standard input")->required();
  add_from(app, format_);
  app.add_flag("--repair", repair_,
               "Drop degenerate and repeated faces, turn faces so that neighbours agree, and split "
               "what is still non-manifold")
      ->group("Input");
  app.add_option("--weld", weld_,
                 "Merge vertices closer than this, relative to the largest side of the bounding "
                 "box; 0 merges equal coordinates only")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("EPS")
      ->group("Input");
  app.add_flag("--triangulate", triangulate_, "Cut polygons into triangles, without new vertices")
      ->group("Input");
}

Result<LoadedMesh> MeshInput::load(Session& session) const {
  Result<LoadedMesh> loaded = load_mesh(path_, format_, session);
  if (!loaded) return loaded;
  Result<Mesh> mended = mend(std::move(loaded->mesh), session);
  if (!mended) return tl::make_unexpected(mended.error());
  loaded->mesh = std::move(*mended);
  session.report["input"] = mesh_json(path_, loaded->mesh);
  return loaded;
}

Result<Mesh> MeshInput::mend(Mesh mesh, Session& session) const {
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
  return mesh;
}

Result<LoadedMesh> load_mesh(const std::string& path, Format format, Session& session) {
  Result<LoadedMesh> loaded = session.timed("read", [&] { return read_mesh(path, format); });
  if (loaded) session.console.notes(loaded->notices);
  return loaded;
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

}  // namespace surpass::cli

// surpass reconstruct POINTS -o MESH
//
// Read, reconstruct, interpolate, measure, write. Everything is computed before anything is
// written.
#include "command.hpp"

#include <surpass/quality.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include <fmt/format.h>

#include "html_report.hpp"
#include "mesh_input.hpp"
#include "mesh_output.hpp"
#include "report.hpp"
#include "rules_option.hpp"
#include "surface_output.hpp"

namespace surpass::cli {

namespace {

class Reconstruct : public Command {
 public:
  void define(Options& options) override;
  Result<void> run(Session& session) override;

 private:
  void define_cleaning(Options& options);
  void define_simplification(Options& options);
  void define_surface(Options& options);
  void take_optional_values();
  Result<Interpolated> interpolate_mesh(const Mesh& mesh, Session& session) const;
  Result<void> write(const Mesh& mesh, const Interpolated& interpolated, const Mesh& unused,
                     Session& session) const;
  Result<void> write_page(const std::vector<Point>& points, const Mesh& mesh, const Mesh& control,
                          Session& session);
  [[nodiscard]] static Mesh unused_points(const Mesh& given, const Reconstruction& found);

  std::string path_;
  Format from_ = Format::automatic;
  MeshOutput output_;
  HtmlReport page_;
  std::string control_path_;
  std::string unused_path_;
  SurfaceOutput surface_;
  ReconstructOptions options_;
  Rules rules_ = {.scheme = Scheme::doo_sabin};
  double tolerance_ = 0;
  double perimeter_ = 0;
  double feature_angle_ = 0;
  Index vertices_ = 0;
  Option tolerance_option_;
  Option perimeter_option_;
  Option feature_option_;
  Option vertices_option_;
};

void Reconstruct::define(Options& options) {
  options
      .add("POINTS", path_,
           "The points: PLY, XYZ (also .pwn and .pts), vertices of OBJ, OFF or STL; '-' is the "
           "standard input")
      .required();
  add_from_points(options, from_, "Format of the input, for '-' or to overrule its name");
  output_.define(options, "-o,--output", "The triangle mesh whose vertices are points");
  page_.define(options);
  define_cleaning(options);
  define_simplification(options);
  define_surface(options);
  options.examples(
      "A spacing is the median of the points' mean distance to six neighbours. What is done\n"
      "automatically is done where measurements call for it, and said. Normals and colours of the\n"
      "points go with the vertices.\n\n"
      "Examples:\n"
      "  surpass reconstruct scan.ply -o mesh.ply --report found.json\n"
      "  surpass reconstruct part.xyz -o mesh.ply --tolerance 1e-4 --feature-angle 40 \\\n"
      "      --surface smooth.ply --levels 2\n"
      "  surpass reconstruct noisy.ply -o mesh.ply --smooth on --close all --unused left.ply\n");
}

void Reconstruct::define_cleaning(Options& options) {
  const std::initializer_list<Choice> choices = {Choice::automatic, Choice::on, Choice::off};
  options
      .choice("--outliers", options_.outliers, choices,
              "Leave out points that stand alone; auto: if some stand very far off, and fewer than "
              "a tenth would go")
      .default_text(name_of(options_.outliers))
      .group("Cleaning");
  options
      .choice("--smooth", options_.smoothing, choices,
              "Smooth the points before they are connected; auto: if they scatter by more than "
              "0.15 spacings")
      .default_text(name_of(options_.smoothing))
      .group("Cleaning");
  options
      .choice("--positions", options_.positions,
              {Positions::automatic, Positions::original, Positions::smoothed},
              "Vertices of smoothed points are the original points or the smoothed ones; auto: "
              "smoothed from a scatter of 0.3 spacings on")
      .default_text(name_of(options_.positions))
      .group("Cleaning");
  perimeter_option_ =
      options
          .add("--perimeter", perimeter_,
               "Largest perimeter of a triangle in spacings, 0 for any; 8 where outliers were "
               "found, else any")
          .in_range(0, 1e9)
          .type_name("X")
          .group("Cleaning");
  options
      .choice("--close", options_.close, {Closing::all, Closing::small, Closing::none},
              "Which holes are filled; small: of up to 30 edges, if that is few for their piece")
      .default_text(name_of(options_.close))
      .group("Cleaning");
  options.add("--unused", unused_path_, "Also write the points that the mesh does not use")
      .type_name("FILE")
      .group("Output");
}

void Reconstruct::define_simplification(Options& options) {
  tolerance_option_ =
      options
          .add("--tolerance", tolerance_,
               "Simplify, with every used point at most this far from the mesh, relative to the "
               "largest side of the points' bounding box")
          .in_range(1e-12, 1)
          .type_name("T")
          .group("Simplification");
  vertices_option_ = options
                         .add("--vertices", vertices_,
                              "Simplify to this many vertices; with --tolerance, to whichever is "
                              "reached first")
                         .in_range(4, 4294967294.0)
                         .type_name("N")
                         .group("Simplification");
  feature_option_ =
      options
          .add("--feature-angle", feature_angle_,
               "Make creases of the edges at which the surface turns by more than this many "
               "degrees, and keep them through simplification")
          .in_range(1, 179)
          .type_name("DEGREES")
          .group("Simplification");
}

void Reconstruct::define_surface(Options& options) {
  options
      .choice("--scheme", rules_.scheme, {Scheme::doo_sabin, Scheme::loop, Scheme::catmull_clark},
              "Subdivision scheme of the surface through the vertices")
      .default_text(name_of(rules_.scheme))
      .group("Surface");
  options
      .choice("--boundary", rules_.boundary, {Boundary::edge_only, Boundary::edge_and_corner},
              "Rule at the boundary of an open mesh")
      .default_text(name_of(rules_.boundary))
      .group("Surface");
  options.add("--control", control_path_, "Also write the control mesh of the surface")
      .type_name("FILE")
      .group("Surface");
  surface_.define(options);
}

void Reconstruct::take_optional_values() {
  if (tolerance_option_.given()) options_.tolerance = tolerance_;
  if (perimeter_option_.given()) options_.perimeter = perimeter_;
  if (feature_option_.given()) options_.feature_angle = feature_angle_;
  if (vertices_option_.given()) options_.vertices = vertices_;
}

Result<void> Reconstruct::run(Session& session) {
  take_optional_values();
  if (const auto fits = surface_.check_given(); !fits) return fits;
  std::vector<std::string> further;
  for (const std::string& path : {control_path_, surface_.path()}) {
    if (!path.empty()) further.push_back(path);
  }
  std::vector<std::string> of_points;
  if (!unused_path_.empty()) of_points.push_back(unused_path_);
  if (const auto ready = output_.prepare(session, {path_}, further, of_points); !ready)
    return ready;
  if (const auto ready = page_.prepare(
          session, {path_}, {output_.path(), control_path_, surface_.path(), unused_path_});
      !ready) {
    return ready;
  }
  const Result<LoadedMesh> loaded = load_points(path_, from_, session);
  if (!loaded) return tl::make_unexpected(loaded.error());
  const Mesh& given = loaded->mesh;
  output_.default_format(loaded->format == Format::xyz ? Format::ply : loaded->format);
  session.report["input"] = {{"path", path_}, {"points", given.vertex_count()}};
  session.report["scheme"] = name_of(rules_.scheme);
  session.report["boundary"] = name_of(rules_.boundary);

  const Result<Reconstruction> found = session.timed("reconstruct", [&] {
    return reconstruct(given.points, given.channels, options_, session.context);
  });
  if (!found) return tl::make_unexpected(found.error());
  session.report["reconstruction"] = reconstruction_json(found->report);
  session.report["mesh"] = mesh_json(output_.path(), found->mesh);
  session.console.say(summary(found->report, found->mesh));
  session.console.notes(found->report.warnings);
  if (const auto fits = surface_.check(found->mesh, rules_.scheme, output_); !fits) return fits;

  const Result<Interpolated> interpolated = interpolate_mesh(found->mesh, session);
  if (!interpolated) return tl::make_unexpected(interpolated.error());
  const bool are_points = !found->report.smoothed_positions;
  const Result<LimitDistances> distances = session.timed("verify", [&] {
    return limit_distances(given.points, are_points ? found->source : std::vector<Index>(),
                           found->unused, interpolated->control, rules_, session.context);
  });
  if (!distances) return tl::make_unexpected(distances.error());
  const double side = found->report.box_side;
  session.report["distance"] = limit_distances_json(*distances, side);
  session.console.say(summary(*distances, side));
  session.console.say(fmt::format("{:.3g} s", session.seconds()));
  if (const auto written = write(found->mesh, *interpolated, unused_points(given, *found), session);
      !written) {
    return written;
  }
  return write_page(given.points, found->mesh, interpolated->control, session);
}

Result<void> Reconstruct::write_page(const std::vector<Point>& points, const Mesh& mesh,
                                     const Mesh& control, Session& session) {
  if (!page_.wanted()) return {};
  Mesh cloud;
  for (const Point& p : points) {
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
      cloud.points.push_back(p);
  }
  page_.add("points", "Given points", LayerKind::points, cloud);
  page_.add("given", "Reconstructed mesh", LayerKind::mesh, mesh);
  page_.add("control", "Control mesh", LayerKind::cage, control);
  if (const auto added = page_.add_limit("surface", "Surface", control, rules_, session.context);
      !added) {
    return added;
  }
  return page_.write(session);
}

Result<Interpolated> Reconstruct::interpolate_mesh(const Mesh& mesh, Session& session) const {
  InterpolateOptions options;
  options.rules = rules_;
  options.tolerance = 1e-12;
  Result<Interpolated> found =
      session.timed("interpolate", [&] { return interpolate(mesh, options, session.context); });
  if (!found) return found;
  const SolveReport& solved = found->report;
  const Result<Certificate> proof = session.timed(
      "verify", [&] { return certify(found->control, mesh.points, rules_, session.context); });
  if (!proof) return tl::make_unexpected(proof.error());
  session.report["interpolation"] = {{"solver", solved.solver},
                                     {"tolerance", solved.tolerance},
                                     {"iterations", solved.iterations},
                                     {"boundary_iterations", solved.boundary_iterations},
                                     {"max", proof->max},
                                     {"mean", proof->mean}};
  session.console.notes(solved.notes);
  session.console.say(
      fmt::format("vertices to the {} surface: max {:.3g} of the box side after {} "
                  "iterations",
                  name_of(rules_.scheme), proof->max, solved.iterations));
  if (!solved.converged || proof->max > solved.tolerance) {
    return fail(ErrorCode::not_converged,
                fmt::format("the surface passes the vertices at {:.3g} of the box side, not within "
                            "{:.3g}",
                            proof->max, solved.tolerance));
  }
  record(rules_, found->control);
  return found;
}

// With the channels that the mesh has, too.
Mesh Reconstruct::unused_points(const Mesh& given, const Reconstruction& found) {
  Mesh points;
  for (const Index i : found.unused) points.points.push_back(given.points[i]);
  for (const Channel& channel : given.channels) {
    const bool is_carried =
        std::any_of(found.mesh.channels.begin(), found.mesh.channels.end(),
                    [&](const Channel& carried) { return carried.name == channel.name; });
    if (!is_carried) continue;
    points.channels.push_back({channel.name, channel.parts, {}, channel.storage});
    std::vector<double>& values = points.channels.back().values;
    for (const Index i : found.unused) {
      const double* row = channel.values.data() + i * channel.width();
      values.insert(values.end(), row, row + channel.width());
    }
  }
  return points;
}

Result<void> Reconstruct::write(const Mesh& mesh, const Interpolated& interpolated,
                                const Mesh& unused, Session& session) const {
  const auto surface = surface_.make(interpolated.control, rules_, session);
  if (!surface) return tl::make_unexpected(surface.error());
  if (const auto done = output_.write(mesh, session); !done) return done;
  if (!control_path_.empty()) {
    if (const auto done = output_.write(interpolated.control, control_path_, session); !done) {
      return done;
    }
  }
  if (const auto done = surface_.write(*surface, output_, session); !done) return done;
  if (unused_path_.empty()) return {};
  return output_.write(unused, unused_path_, session);
}

}  // namespace

std::unique_ptr<Command> make_reconstruct() { return std::make_unique<Reconstruct>(); }

}  // namespace surpass::cli

// The core as the page's worker sees it: one mesh at a time, read, interpolated, shown and written.
// Every method returns an object; where something went wrong it is {error: {code, message, ...}}.
#include <surpass/fairness.hpp>
#include <surpass/io.hpp>
#include <surpass/repair.hpp>
#include <surpass/topology.hpp>
#include <surpass/version.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <emscripten/bind.h>
#include <emscripten/emscripten.h>

#include "nonstationary.hpp"
#include "to_js.hpp"
#include "wishes.hpp"

namespace surpass::wasm {

namespace {

struct Found {
  Mesh control;
  SolveReport report;
};

Context telling(const val& progress) {
  Context context;
  if (progress.isNull() || progress.isUndefined()) return context;
  context.progress = [progress](const Progress& p) {
    progress(std::string(p.stage), p.fraction, static_cast<double>(p.iteration), p.error);
  };
  return context;
}

Result<Found> find_control(const Mesh& given, const Wishes& wishes, const Context& context) {
  if (wishes.method == "progressive") {
    auto found = interpolate(given, wishes.progressive, context);
    if (!found) return tl::make_unexpected(found.error());
    return Found{std::move(found->control), std::move(found->report)};
  }
  auto found = interpolate_similar(given, wishes.similar, context);
  if (!found) return tl::make_unexpected(found.error());
  SolveReport report = std::move(found->report.solve);
  // What falls here is the solver's residual; the surface interpolates from the first iteration on.
  for (std::size_t i = 0; i < found->report.residuals.size(); ++i) {
    const double residual = found->report.residuals[i];
    report.history.push_back({static_cast<unsigned>(i + 1), residual, residual});
  }
  return Found{std::move(found->control), std::move(report)};
}

void set_channel(Mesh& mesh, const char* name, std::vector<double> values) {
  mesh.channels.push_back({name, {name}, std::move(values)});
}

// Only what is shown, so that refining carries nothing along in vain.
Mesh bare(const Mesh& mesh) {
  Mesh shape = mesh;
  shape.channels.clear();
  shape.corner_channels.clear();
  shape.face_channels.clear();
  shape.face_sets.clear();
  return shape;
}

// Curvature is that of the mesh in its frame: 1 is the curvature of a ball of radius one box side.
Result<val> curved(Result<Mesh> limit, const Frame& frame, const Context& context) {
  if (!limit) return tl::make_unexpected(limit.error());
  const auto curvatures = vertex_curvatures(*limit, context);
  if (!curvatures) return tl::make_unexpected(curvatures.error());
  std::vector<double> mean;
  std::vector<double> gauss;
  for (const VertexCurvature& k : *curvatures) {
    mean.push_back(k.mean * frame.side);
    gauss.push_back(k.gauss * frame.side * frame.side);
  }
  set_channel(*limit, "mean", std::move(mean));
  set_channel(*limit, "gauss", std::move(gauss));
  return display(*limit, frame);
}

Result<val> surface(const Mesh& control, const Rules& rules, int levels, const Frame& frame,
                    const Context& context) {
  return curved(limit_mesh(control, rules, std::max(levels, 0), context), frame, context);
}

val to_js(const SolveReport& report) {
  val told = val::object();
  told.set("converged", report.converged);
  told.set("solver", report.solver);
  told.set("tolerance", report.tolerance);
  told.set("iterations", report.iterations);
  told.set("boundaryIterations", report.boundary_iterations);
  told.set("history", history(report.history));
  told.set("boundaryHistory", history(report.boundary_history));
  told.set("notes", strings(report.notes));
  return told;
}

// Of milliseconds.
val seconds(double solve, double verify, double surfaces) {
  val told = val::object();
  told.set("solve", solve / 1000);
  told.set("verify", verify / 1000);
  told.set("surfaces", surfaces / 1000);
  return told;
}

// Distances of the limit points of the first vertices to the given points, relative to the box
// side.
Result<std::vector<double>> distances(const Mesh& control, const std::vector<Point>& given,
                                      const Rules& rules, double side, const Context& context) {
  const auto limit = limit_positions(control, rules, context);
  if (!limit) return tl::make_unexpected(limit.error());
  std::vector<double> found;
  found.reserve(given.size());
  for (std::size_t v = 0; v < given.size(); ++v) {
    const auto off = [&](std::size_t c) { return ((*limit)[v][c] - given[v][c]) / side; };
    found.push_back(std::hypot(off(0), off(1), off(2)));
  }
  return found;
}

}  // namespace

class Core {
 public:
  /// `mend` is {repair?, triangulate?}. Tells what the file holds and the given mesh or points.
  val load(const std::string& file, const std::string& name, const val& mend);
  /// Control mesh, both surfaces, certificate, and how the solver went. The plain surface and the
  /// points' errors are left out where they are as the last time, the control mesh where the
  /// scheme needs none.
  val solve(const val& options, const val& progress);
  /// {richardson, chebyshev, boundaryRichardson, ...}: histories, for the plot.
  val rivals(const val& options, const val& progress) const;
  /// The bytes of a file: `what` is "control" or "surface" as last solved, or "given".
  [[nodiscard]] val written(const std::string& what, const std::string& format) const;

 private:
  Result<LoadedMesh> parse(const std::string& file, const std::string& name) const;
  Result<val> show(const Wishes& wishes, const Context& context);
  Result<val> show_by_itself(const Wishes& wishes, const Context& context);
  Result<void> show_plain(const Rules& rules, int levels, val& shown, const Context& context);
  [[nodiscard]] Result<Mesh> solved_surface() const;

  Mesh given_;
  Mesh control_;
  Rules rules_;
  std::optional<NonstationaryOptions> by_itself_;  ///< in the place of control mesh and rules
  int levels_ = 2;
  Frame frame_;
  std::optional<std::pair<Rules, int>> plain_shown_;
};

Result<LoadedMesh> Core::parse(const std::string& file, const std::string& name) const {
  const Format format = format_of_path(name);
  if (format == Format::xyz) return parse_points(file, format, name);
  auto loaded = parse_mesh(file, Format::automatic, name);
  // A file of points in a format of meshes.
  if (loaded && loaded->mesh.face_count() == 0) return parse_points(file, loaded->format, name);
  return loaded;
}

val Core::load(const std::string& file, const std::string& name, const val& mend) {
  auto loaded = parse(file, name);
  if (!loaded) return failure(loaded.error());
  std::vector<std::string> notices = std::move(loaded->notices);
  const auto take = [&](Mended mended) {
    loaded->mesh = std::move(mended.mesh);
    notices.insert(notices.end(), mended.done.begin(), mended.done.end());
  };
  const auto wanted = [&](const char* what) { return mend[what].isTrue(); };
  if (wanted("repair")) take(repair(loaded->mesh));
  if (wanted("triangulate")) take(triangulate(loaded->mesh));
  val told = val::object();
  const bool points_only = loaded->mesh.face_count() == 0;
  if (points_only && loaded->mesh.points.empty()) {
    return failure({.code = ErrorCode::empty_mesh,
                    .message = "there are no points in this file",
                    .place = {.file = name}});
  }
  if (!points_only) {
    const auto topology = Topology::build(loaded->mesh);
    if (!topology) {
      Error error = topology.error();
      error.place.file = name;
      return failure(error);
    }
    told.set("shapes", shapes_of(loaded->mesh, *topology));
  }
  given_ = std::move(loaded->mesh);
  control_ = {};
  by_itself_.reset();
  plain_shown_.reset();
  frame_ = frame_of(given_.points);
  told.set("kind", std::string(points_only ? "points" : "mesh"));
  told.set("format", std::string(name_of(loaded->format)));
  told.set("notices", strings(notices));
  told.set("vertices", given_.vertex_count());
  told.set("faces", given_.face_count());
  told.set("triangles", all_triangles(given_));
  const auto recorded = scheme_named(given_.annotation("scheme"));
  told.set("scheme", std::string(name_of(recorded ? *recorded : suggested_scheme(given_))));
  told.set("boxSide", frame_.side);
  told.set("given", display(bare(given_), frame_));
  return told;
}

val Core::solve(const val& options, const val& progress) {
  const auto wishes = read_wishes(options);
  if (!wishes) return failure(wishes.error());
  const Context context = telling(progress);
  auto shown = wishes->nonstationary ? show_by_itself(*wishes, context) : show(*wishes, context);
  return shown ? *shown : failure(shown.error());
}

Result<val> Core::show(const Wishes& wishes, const Context& context) {
  const Rules rules = wishes.progressive.rules;
  const double start = emscripten_get_now();
  auto found = find_control(given_, wishes, context);
  if (!found) return tl::make_unexpected(found.error());
  const double solved = emscripten_get_now();
  const auto certificate = certify(found->control, given_, rules, context);
  if (!certificate) return tl::make_unexpected(certificate.error());
  const double verified = emscripten_get_now();

  const bool refined = found->control.annotation("refined") == "1";
  const int levels = std::max(0, wishes.levels - (refined ? 1 : 0));
  val shown = val::object();
  if (const auto added = show_plain(rules, wishes.levels, shown, context); !added) {
    return tl::make_unexpected(added.error());
  }
  const auto fitted = surface(bare(found->control), rules, levels, frame_, context);
  if (!fitted) return tl::make_unexpected(fitted.error());
  shown.set("surface", *fitted);
  shown.set("control", display(bare(found->control), frame_));
  shown.set("certificate", wasm::to_js(*certificate));
  shown.set("report", to_js(found->report));
  shown.set("seconds", seconds(solved - start, verified - solved, emscripten_get_now() - verified));
  control_ = std::move(found->control);
  by_itself_.reset();
  rules_ = rules;
  levels_ = levels;
  plain_shown_ = {rules, wishes.levels};
  return shown;
}

// The given mesh's own surface. What it is held to is computed from what is shown, every time.
Result<val> Core::show_by_itself(const Wishes& wishes, const Context& context) {
  const double start = emscripten_get_now();
  const auto own = refined_by_itself(bare(given_), *wishes.nonstationary, wishes.levels, context);
  if (!own) return tl::make_unexpected(own.error());
  auto limit = own->limit_mesh(context);
  if (!limit) return tl::make_unexpected(limit.error());
  const double refined = emscripten_get_now();
  const auto certificate =
      compare_points(std::span(limit->points).first(given_.points.size()), own->aims(), "surpass");
  if (!certificate) return tl::make_unexpected(certificate.error());
  const double verified = emscripten_get_now();

  SolveReport report;
  report.tolerance = floored_tolerance(wishes.progressive.tolerance,
                                       flat(std::as_const(given_.points)), frame_.side);
  report.converged = certificate->max <= report.tolerance;
  report.notes = own->notes();
  val shown = val::object();
  const Rules& rules = wishes.progressive.rules;
  if (const auto added = show_plain(rules, wishes.levels, shown, context); !added) {
    return tl::make_unexpected(added.error());
  }
  const auto fitted = curved(std::move(limit), frame_, context);
  if (!fitted) return tl::make_unexpected(fitted.error());
  shown.set("surface", *fitted);
  shown.set("certificate", wasm::to_js(*certificate));
  shown.set("report", to_js(report));
  const double surfaces = refined - start + emscripten_get_now() - verified;
  shown.set("seconds", seconds(0, verified - refined, surfaces));
  by_itself_ = wishes.nonstationary;
  levels_ = wishes.levels;
  plain_shown_ = {rules, wishes.levels};
  return shown;
}

// The page keeps what it was given; sliders hardly ever change it.
Result<void> Core::show_plain(const Rules& rules, int levels, val& shown, const Context& context) {
  if (plain_shown_ == std::pair(rules, levels)) return {};
  Mesh plain = bare(given_);
  auto errors = distances(plain, given_.points, rules, frame_.side, context);
  if (!errors) return tl::make_unexpected(errors.error());
  shown.set("pointErrors", floats(*errors));
  set_channel(plain, "error", std::move(*errors));
  const auto made = surface(plain, rules, levels, frame_, context);
  if (!made) return tl::make_unexpected(made.error());
  shown.set("plain", *made);
  return {};
}

val Core::rivals(const val& options, const val& progress) const {
  auto wishes = read_wishes(options);
  if (!wishes) return failure(wishes.error());
  val found = val::object();
  for (const Solver solver : {Solver::richardson, Solver::chebyshev}) {
    InterpolateOptions& rival = wishes->progressive;
    rival.solver = solver;
    rival.full_history = true;
    const auto solved = interpolate(given_, rival, telling(progress));
    if (!solved) continue;  // not for this mesh, and the plot goes without
    val curve = val::object();
    curve.set("history", history(solved->report.history));
    curve.set("boundaryHistory", history(solved->report.boundary_history));
    found.set(name_of(solver), curve);
  }
  return found;
}

// To be written, with all that the given mesh carries.
Result<Mesh> Core::solved_surface() const {
  if (!by_itself_) return limit_mesh(control_, rules_, levels_);
  const auto own = refined_by_itself(given_, *by_itself_, levels_, {});
  if (!own) return tl::make_unexpected(own.error());
  return own->limit_mesh();
}

val Core::written(const std::string& what, const std::string& format) const {
  WriteOptions options;
  options.format = format_named(format);
  std::string text;
  Mesh refined;
  if (what == "control" && by_itself_) {
    return failure({.code = ErrorCode::invalid_argument,
                    .message = "there is no other control mesh than the given one"});
  }
  if (what == "surface") {
    auto limit = solved_surface();
    if (!limit) return failure(limit.error());
    refined = std::move(*limit);
  }
  const Mesh& mesh = what == "surface" ? refined : what == "control" ? control_ : given_;
  const auto lost = format_mesh(mesh, options, text);
  if (!lost) return failure(lost.error());
  val file = val::object();
  file.set("bytes", bytes(text));
  file.set("notices", strings(*lost));
  return file;
}

static std::string version() { return kVersion; }

}  // namespace surpass::wasm

// Names are JavaScript's from here on.
EMSCRIPTEN_BINDINGS(surpass) {
  using surpass::wasm::Core;
  emscripten::class_<Core>("Core")
      .constructor<>()
      .function("load", &Core::load)
      .function("solve", &Core::solve)
      .function("rivals", &Core::rivals)
      .function("written", &Core::written);
  emscripten::function("version", &surpass::wasm::version);
}

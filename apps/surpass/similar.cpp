#include "similar.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "mesh_input.hpp"

namespace surpass::cli {

namespace {

/// Faces from their smallest vertex on, in order: equal where meshes differ in how they list them.
std::vector<std::vector<Index>> turned_faces(const Mesh& mesh) {
  std::vector<std::vector<Index>> faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    auto& turned = faces.emplace_back(face.begin(), face.end());
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

const char* name_of(Method method) {
  switch (method) {
    case Method::progressive: return "progressive";
    case Method::similarity: return "similarity";
    case Method::fair: return "fair";
  }
  return "unknown";
}

void Similar::define(Options& options) {
  const auto grouped = [](const Option& option) { return option.group("Similarity and fairing"); };
  grouped(options.choice(
      "--similarity", form_, {Similarity::vectors, Similarity::directions},
      "What the surface has in common with the reference: vectors, its derivatives in direction "
      "and length (ours, the default of the method similarity); directions, in direction alone "
      "(the paper)"));
  grouped(options.choice(
      "--scaling", scaling_, {Scaling::none, Scaling::per_axis, Scaling::isotropic},
      "How the refined given mesh is stretched to the given box before it is the reference; by "
      "default per-axis (the paper), and none with --reference"));
  grouped(options.choice(
      "--open", open_, {OpenMeshes::boundary_rules, OpenMeshes::dummy_ring},
      "Open meshes: boundary-rules, as --boundary says; dummy-ring, inside a ring of free faces "
      "that are not drawn (the paper; catmull-clark); by default boundary-rules, and dummy-ring "
      "where normals or derivatives are required on the boundary"));
  grouped(options
              .add("--reference", reference_path_,
                   "Another reference: a mesh with the faces of the given one, or of that refined "
                   "once, whose surface is the one to resemble; under the method fair iterations "
                   "start there")
              .type_name("MESH"));
  grouped(options
              .add("--write-reference", reference_output_,
                   "Also write the reference, refined and stretched: a control mesh with the faces "
                   "of the output, whose surface the interpolating one resembles or, under the "
                   "method fair, starts from")
              .type_name("FILE"));
  requirements_input_.define(options, "Similarity and fairing",
                             "; surpass check with the same options verifies them from the file");
  samples_ = grouped(options
                         .add("--samples", options_.samples,
                              "Derivatives are sampled at this many points along the side of a "
                              "patch: 3 (the paper), 5, 9 or 17")
                         .in_range(3, 17)
                         .type_name("N")
                         .default_text(std::to_string(options_.samples)));
  thin_plate_ = grouped(options
                            .add("--thin-plate", options_.thin_plate,
                                 "Weight of second derivatives under the method fair")
                            .in_range(0.0, 1e6)
                            .type_name("W")
                            .default_text(fmt::format("{}", options_.thin_plate)));
  membrane_ = grouped(
      options
          .add("--membrane", options_.membrane, "Weight of first derivatives under the method fair")
          .in_range(0.0, 1e6)
          .type_name("W")
          .default_text(fmt::format("{}", options_.membrane)));
  solver_tolerance_ =
      grouped(options
                  .add("--solver-tolerance", options_.solver_tolerance,
                       "The solver ends when the residual is this part of what it was at the "
                       "start; the surface interpolates whatever it is")
                  .in_range(1e-15, 0.999)
                  .type_name("T")
                  .default_text(fmt::format("{}", options_.solver_tolerance)));
}

std::vector<std::string> Similar::inputs() const {
  std::vector<std::string> paths = requirements_input_.inputs();
  if (!reference_path_.empty()) paths.push_back(reference_path_);
  return paths;
}

std::vector<std::string> Similar::outputs() const {
  if (reference_output_.empty()) return {};
  return {reference_output_};
}

Result<void> Similar::check(Method method, const RulesOption& rules) const {
  struct Use {
    const char* name;
    bool given;
    bool similarity;
    bool fair;
  };
  const std::string weights =
      fmt::format("--weights {}", name_of(rules.row_weights().value_or(RowWeights{})));
  const std::array uses = {
      Use{"--similarity", form_.has_value(), true, false},
      Use{weights.c_str(), rules.row_weights().has_value(), true, false},
      Use{"--scaling", scaling_.has_value(), true, true},
      Use{"--open", open_.has_value(), true, true},
      Use{"--reference", !reference_path_.empty(), true, true},
      Use{"--write-reference", !reference_output_.empty(), true, true},
      Use{"--requirements", requirements_input_.lists(), true, true},
      Use{"--normals", requirements_input_.names_normals(), true, true},
      Use{"--samples", samples_.given(), true, true},
      Use{"--thin-plate", thin_plate_.given(), false, true},
      Use{"--membrane", membrane_.given(), false, true},
      Use{"--solver-tolerance", solver_tolerance_.given(), true, true},
  };
  for (const Use& use : uses) {
    const bool fits =
        (method == Method::similarity && use.similarity) || (method == Method::fair && use.fair);
    if (!use.given || fits) continue;
    const char* methods = !use.similarity ? "fair" : use.fair ? "similarity or fair" : "similarity";
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} says nothing of the method {}; it is for --method {}", use.name,
                            name_of(method), methods));
  }
  if (rules.row_weights() && form_ != Similarity::directions) {
    return fail(ErrorCode::invalid_argument,
                weights + " is for --similarity directions; vectors have no weights");
  }
  return {};
}

void Similar::note_ring(Session& session) const {
  session.console.note(fmt::format(
      "a normal or derivative is required on the boundary, where boundary rules would bulge, so "
      "the mesh is in a ring of dummy faces, which are not drawn: the last {} of the control "
      "mesh, hole faces. Choose by --open",
      ring_faces_));
}

void Similar::note_drawn_ring(const MeshOutput& output, Session& session) const {
  const bool drawn = output.format() == Format::off || output.format() == Format::stl;
  if (ring_faces_ == 0 || !drawn) return;
  session.console.note(
      fmt::format("the ring of {} dummy faces is drawn like the surface in '{}'; write OBJ or "
                  "PLY, or take --open boundary-rules",
                  ring_faces_, output.path()));
}

Result<void> Similar::load_reference(const Mesh& given, Session& session) {
  if (reference_path_.empty()) return {};
  Result<LoadedMesh> loaded = load_mesh(reference_path_, Format::automatic, session);
  if (!loaded) return tl::make_unexpected(loaded.error());
  const Mesh& mesh = loaded->mesh;
  const auto faces = turned_faces(mesh);
  const bool same = mesh.points.size() == given.points.size() && faces == turned_faces(given);
  if (!same && faces != turned_faces(solver_->refined())) {
    return fail(ErrorCode::mismatch,
                fmt::format("{} has neither the faces of the given mesh nor those of that mesh "
                            "refined once, vertex by vertex",
                            reference_path_));
  }
  if ((!mesh.creases.empty() || !mesh.corners.empty()) &&
      (mesh.creases != given.creases || mesh.corners != given.corners)) {
    session.console.note(
        fmt::format("creases and corners of {} are not used; those of the given "
                    "mesh hold for its surface, too",
                    reference_path_));
  }
  reference_ = std::move(loaded->mesh.points);
  return {};
}

Result<void> Similar::make_reference(const Mesh& given, Session& session) {
  if (reference_output_.empty()) return {};
  auto points = session.timed("reference", [&] {
    return solver_->reference(given.points, reference_, requirements_, session.context);
  });
  if (!points) return tl::make_unexpected(points.error());
  resembled_ = solver_->refined();
  resembled_->points = std::move(*points);
  record(options_.rules, *resembled_);
  return {};
}

Result<void> Similar::check_reference(const MeshOutput& output) const {
  return resembled_ ? output.check(*resembled_, reference_output_) : Result<void>();
}

Result<void> Similar::write_reference(const MeshOutput& output, Session& session) const {
  return resembled_ ? output.write(*resembled_, reference_output_, session) : Result<void>();
}

Result<void> Similar::prepare(Method method, const InterpolateOptions& common,
                              const RulesOption& rules, const Mesh& given, Session& session) {
  options_.rules = common.rules;
  options_.tolerance = common.tolerance;
  options_.max_iterations = common.max_iterations;
  if (common.solver == Solver::gauss_seidel) options_.solver = SimilaritySolver::gauss_seidel;
  options_.similarity =
      method == Method::fair ? Similarity::fair : form_.value_or(Similarity::vectors);
  options_.row_weights = rules.row_weights().value_or(options_.row_weights);
  options_.scaling = scaling_.value_or(reference_path_.empty() ? Scaling::per_axis : Scaling::none);
  session.report["solver"] = name_of(options_.solver);
  auto loaded = requirements_input_.load(given, options_.rules, session);
  if (!loaded) return tl::make_unexpected(loaded.error());
  requirements_ = std::move(*loaded);
  const bool better_around = options_.rules.scheme == Scheme::catmull_clark &&
                             prescribes_at_boundary(given, requirements_);
  options_.open = open_.value_or(better_around ? OpenMeshes::dummy_ring : options_.open);
  auto solver = session.timed(
      "topology", [&] { return SimilarityInterpolator::create(given, options_, session.context); });
  if (!solver) return tl::make_unexpected(solver.error());
  solver_ = std::move(*solver);
  if (options_.open == OpenMeshes::dummy_ring) {
    ring_faces_ = solver_->refined().face_count() - given.corner_count();
  }
  if (better_around && !open_) note_ring(session);
  if (auto read = load_reference(given, session); !read) return read;
  return make_reference(given, session);
}

Json Similar::report_of(const SimilarityReport& report) const {
  Json similarity = {{"form", name_of(options_.similarity)},
                     {"scaling", name_of(options_.scaling)},
                     {"scale", report.scale},
                     {"open", name_of(options_.open)},
                     {"samples", options_.samples},
                     {"free_vertices", report.free_vertices},
                     {"derivatives", report.derivatives},
                     {"solver_tolerance", options_.solver_tolerance},
                     {"residual", report.residual},
                     {"residuals", report.residuals}};
  if (options_.similarity == Similarity::directions) {
    similarity["row_weights"] = name_of(options_.row_weights);
  }
  if (options_.similarity == Similarity::fair) {
    similarity["thin_plate"] = options_.thin_plate;
    similarity["membrane"] = options_.membrane;
  }
  if (!requirements_.empty()) {
    Json& entries = similarity["requirements"];
    entries = outcomes_json(requirements_, report.requirements);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      entries[i]["redundant"] = report.requirements[i].redundant;
    }
  }
  return similarity;
}

void Similar::note_size(double side, std::span<const Point> control, Session& session) const {
  constexpr double kFarOut = 100;
  constexpr double kShrunk = 1e-3;
  const double size = bounding_box(control).side();
  if (requirements_.empty() || !(side > 0)) return;
  if (size > kFarOut * side) {
    session.console.note(
        fmt::format("the control mesh is {:.3g} times as large as the given one: a requirement "
                    "asks for something that the surface can hardly do",
                    size / side));
  } else if (size < kShrunk * side) {
    session.console.note(
        fmt::format("the control mesh has shrunk to {:.3g} of the given one: only next to nothing "
                    "of a surface does what is required",
                    size / side));
  }
}

std::string Similar::summary_of_requirements() const {
  if (outcomes_.empty()) return "";
  const std::size_t worst = worst_of(outcomes_);
  return fmt::format("requirements at most {:.3g} of the box side at {} ({}), {} of them",
                     outcomes_[worst].error, worst, describe(requirements_[worst]),
                     outcomes_.size());
}

std::string Similar::missed_requirement() const {
  return why_missed(requirements_, outcomes_, kRequirementTolerance);
}

Result<SolveReport> Similar::solve(Mesh& mesh, std::vector<Point>& given, Session& session) {
  auto solution = session.timed("solve", [&] {
    return solver_->solve_required(requirements_, mesh.points, reference_, mesh.channels,
                                   session.context);
  });
  if (!solution) return tl::make_unexpected(solution.error());
  session.report["similarity"] = report_of(solution->report);
  outcomes_ = std::move(solution->report.requirements);
  given = std::move(solution->targets);
  note_size(solution->report.solve.box_side, solution->points, session);
  mesh = solver_->refined();
  mesh.points = std::move(solution->points);
  mesh.channels = std::move(solution->channels);
  const std::string where =
      options_.rules.scheme == Scheme::doo_sabin
          ? std::string("with a face for each vertex of the given mesh inside")
          : fmt::format("of which the first {} are those of the given mesh", given.size());
  solution->report.solve.notes.push_back(
      fmt::format("the control mesh is the given mesh refined once: {} vertices, {}",
                  mesh.vertex_count(), where));
  return std::move(solution->report.solve);
}

}  // namespace surpass::cli

#include "nonstationary.hpp"

#include <surpass/topology.hpp>

#include <cmath>
#include <cstdlib>
#include <map>

#include <fmt/format.h>

#include "targets_file.hpp"
#include "wording.hpp"

namespace surpass::cli {

namespace {

constexpr char kAuto[] = "auto";

std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(number)) return std::nullopt;
  return number;
}

double shape_of(ShapePreset preset) {
  switch (preset) {
    case ShapePreset::round: return kRoundShape;
    case ShapePreset::flat: return kFlatShape;
    case ShapePreset::standard: break;
  }
  return kDefaultShape;
}

/// A parameter for each valence that smooth interior vertices have, of the first such vertex.
Json parameters_json(const NonstationaryLoop& surface) {
  std::map<Index, double> by_valence;
  const auto topology = Topology::build(surface.mesh());
  for (Index v = 0; topology && v < topology->vertex_count(); ++v) {
    if (topology->is_isolated(v) || topology->is_boundary(v)) continue;
    by_valence.emplace(topology->valence(v), surface.vertex_parameters()[v]);
  }
  Json list = Json::array();
  for (const auto& [valence, parameter] : by_valence) {
    list.push_back({{"valence", valence}, {"parameter", parameter}});
  }
  return list;
}

}  // namespace

const char* name_of(ShapePreset preset) {
  switch (preset) {
    case ShapePreset::round: return "round";
    case ShapePreset::standard: return "default";
    case ShapePreset::flat: return "flat";
  }
  return "unknown";
}

void Nonstationary::define(Options& options, bool measured) {
  const auto grouped = [](const Option& option) { return option.group("Non-stationary Loop"); };
  grouped(options
              .add("--shape", shape_,
                   "Shape parameter: the smaller, the rounder (-3.99 to 3.99, or to 1.99 if an "
                   "interior vertex has three neighbours; outside, the end of the range is taken). "
                   "auto: the one whose limit surface has the least bending without its sharpest "
                   "hundredth, as `surpass quality` prints it")
              .type_name("B|auto")
              .default_text(fmt::format("{}", kDefaultShape)));
  grouped(options.choice("--preset", preset_,
                         {ShapePreset::round, ShapePreset::standard, ShapePreset::flat},
                         fmt::format("A shape parameter by name: round is {}, default {}, flat {}",
                                     kRoundShape, kDefaultShape, kFlatShape)));
  uniform_option_ = grouped(
      options
          .add("--uniform", uniform_,
               "The uniform scheme, which does not interpolate: every parameter is V at first; 1 "
               "is Loop subdivision")
          .in_range(-3.99, 3.99)
          .type_name("V")
          .default_text(""));
  const Option rule = grouped(options.choice(
      "--rule", rule_,
      {NonstationaryRule::interpolating, NonstationaryRule::quadratic, NonstationaryRule::mean},
      std::string("interpolating: the paper's (default); quadratic: ours, without a shape "
                  "parameter, a wider first step that reproduces quadratic functions on regular "
                  "meshes") +
          (measured ? ""
                    : "; mean: edges take the mean of their ends' parameters, for comparison, it "
                      "does not interpolate")));
  // The third is understood all the same, to be refused with the reason.
  if (measured) rule.type_name("interpolating|quadratic");
  grouped(options.choice(
      "--iteration", iteration_, {ParameterIteration::geometric, ParameterIteration::exponential},
      "How parameters go on from level to level: geometric (default), or exponential, for "
      "comparison under --uniform: it cannot interpolate"));
  grouped(options
              .add("--targets", targets_path_,
                   "Points to pass through in the place of vertices: a file of vertex numbers from "
                   "0, each with a position on the line from the vertex (0) through the centroid "
                   "of its neighbours (1)")
              .type_name("FILE"));
  grouped(options.flag(
      "--keep-folds", keep_folds_,
      "Keep boundaries and creases smooth where they turn the surface over; otherwise such a "
      "vertex becomes a corner, and a note names it"));
}

std::vector<std::string> Nonstationary::inputs() const {
  return targets_path_.empty() ? std::vector<std::string>() : std::vector{targets_path_};
}

Result<void> Nonstationary::check(const RulesOption& rules) const {
  const auto refuse = [](std::string sentence) {
    return fail(ErrorCode::invalid_argument, std::move(sentence));
  };
  const bool uniform = uniform_option_.given();
  const bool quadratic = rule_ == NonstationaryRule::quadratic;
  const char* name = !shape_.empty()          ? "--shape"
                     : preset_                ? "--preset"
                     : uniform                ? "--uniform"
                     : rule_                  ? "--rule"
                     : iteration_             ? "--iteration"
                     : !targets_path_.empty() ? "--targets"
                     : keep_folds_            ? "--keep-folds"
                     : rules.loop_weights()   ? "--weights warren and classic"
                                              : nullptr;
  if (!rules.nonstationary()) {
    if (name == nullptr) return {};
    return refuse(fmt::format("{}: only for --scheme {}", name, kNonstationaryLoop));
  }
  if (rules.other_weights()) {
    return refuse(
        "--weights averaging and cosine are for doo-sabin; nonstationary-loop has warren "
        "and classic");
  }
  if (!shape_.empty() && shape_ != kAuto && !number_in(shape_)) {
    return refuse(fmt::format("--shape: '{}' is neither a number nor auto", shape_));
  }
  if (!shape_.empty() && preset_) return refuse("--shape and --preset name the same number");
  if ((!shape_.empty() || preset_) && (uniform || quadratic)) {
    return refuse(fmt::format("{} has no shape parameter; leave out --shape and --preset",
                              uniform ? "--uniform" : "--rule quadratic"));
  }
  if (uniform && rule_) return refuse("--uniform is a rule of its own; leave out --rule");
  if (!targets_path_.empty() && (uniform || (rule_ && rule_ != NonstationaryRule::interpolating))) {
    return refuse("--targets needs parameters that are solved for: --rule interpolating");
  }
  if (iteration_ == ParameterIteration::exponential && !uniform) {
    return refuse("--iteration exponential cannot interpolate; it is for --uniform");
  }
  return {};
}

Result<NonstationaryOptions> Nonstationary::choose(const Mesh& mesh, const RulesOption& rules,
                                                   int steps, Session& session,
                                                   const FairnessOptions& measure) const {
  NonstationaryOptions options;
  options.boundary = rules.choose(mesh, session).boundary;
  options.weights = rules.loop_weights().value_or(options.weights);
  options.iteration = iteration_.value_or(options.iteration);
  options.steps = steps;
  options.corners_at_folds = !keep_folds_;
  options.rule =
      uniform_option_.given() ? NonstationaryRule::uniform : rule_.value_or(options.rule);
  if (!targets_path_.empty()) {
    auto targets = read_targets(targets_path_, mesh.vertex_count());
    if (!targets) return tl::make_unexpected(targets.error());
    options.targets = std::move(*targets);
  }
  Json& report = session.report["nonstationary"];
  report = {{"rule", name_of(options.rule)},
            {"loop_weights", name_of(options.weights)},
            {"iteration", name_of(options.iteration)},
            {"steps", steps}};
  if (!options.targets.empty()) report["targets"] = options.targets.size();
  const auto found = shape(mesh, options, measure, session);
  if (!found) return tl::make_unexpected(found.error());
  options.shape = *found;
  return options;
}

Result<double> Nonstationary::shape(const Mesh& mesh, const NonstationaryOptions& options,
                                    const FairnessOptions& measure, Session& session) const {
  if (uniform_option_.given()) return uniform_;
  if (preset_) return shape_of(*preset_);
  if (shape_ != kAuto) return number_in(shape_).value_or(kDefaultShape);
  return fairest(mesh, options, measure, session);
}

Result<double> Nonstationary::fairest(const Mesh& mesh, const NonstationaryOptions& options,
                                      const FairnessOptions& measure, Session& session) const {
  const auto found = session.timed(
      "shape", [&] { return fairest_shape(mesh, options, measure, session.context); });
  if (!found) return tl::make_unexpected(found.error());
  const auto [levels, rings] = found->measure;
  session.report["nonstationary"]["fairest"] = {
      {"trimmed_bending", found->trimmed_bending}, {"levels", levels}, {"rings", rings}};
  if (rings < measure.rings) {
    session.console.note(fmt::format(
        "nothing of the surface is left to measure after {} without {} around its "
        "extraordinary vertices, so the shape parameter is that of `surpass quality --rings {}`",
        counted(levels, "level", "levels"), counted(measure.rings, "ring", "rings"), rings));
  }
  session.console.say(
      fmt::format("shape parameter {:.6g}: least bending without the sharpest hundredth, {:.6g} "
                  "after {}",
                  found->shape, found->trimmed_bending, counted(levels, "level", "levels")));
  return found->shape;
}

std::string Nonstationary::summary(const NonstationaryLoop& surface) const {
  if (uniform_option_.given()) return fmt::format("uniform parameter {:.6g}", surface.shape());
  if (rule_ == NonstationaryRule::quadratic) return "quadratic rule";
  return fmt::format("shape parameter {:.6g}", surface.shape());
}

Result<NonstationaryLoop> Nonstationary::create(const Mesh& mesh, const RulesOption& rules,
                                                int steps, Session& session) const {
  const auto options = choose(mesh, rules, steps, session);
  if (!options) return tl::make_unexpected(options.error());
  auto surface = session.timed(
      "solve", [&] { return NonstationaryLoop::create(mesh, *options, session.context); });
  if (!surface) return surface;
  Json& report = session.report["nonstationary"];
  if (options->rule != NonstationaryRule::quadratic) report["shape"] = surface->shape();
  report["parameters"] = parameters_json(*surface);
  session.console.notes(surface->notes());
  return surface;
}

Result<NonstationaryLoop> Nonstationary::refined(const Mesh& mesh, const RulesOption& rules,
                                                 int steps, int levels, Session& session) const {
  auto surface = create(mesh, rules, steps, session);
  if (!surface) return surface;
  if (const auto done = refine(*surface, levels, session); !done) {
    return tl::make_unexpected(done.error());
  }
  return surface;
}

Result<void> Nonstationary::refine(NonstationaryLoop& surface, int levels, Session& session) {
  while (surface.level() < levels) {
    session.context.report(
        {.stage = "subdivide", .fraction = static_cast<double>(surface.level()) / levels});
    const auto done = session.timed("refine", [&] { return surface.refine(session.context); });
    if (!done) return done;
  }
  return {};
}

}  // namespace surpass::cli

#include "style.hpp"

#include <surpass/fairness.hpp>
#include <surpass/interpolate.hpp>
#include <surpass/quality.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "spelling.hpp"

namespace surpass::cli {

namespace {

Result<std::vector<double>> curvatures(RenderStyle style, const Mesh& drawn,
                                       const Context& context) {
  const auto found = vertex_curvatures(drawn, context);
  if (!found) return tl::make_unexpected(found.error());
  std::vector<double> numbers;
  for (const VertexCurvature& k : *found) {
    numbers.push_back(style == RenderStyle::curvature ? k.mean : k.gauss);
  }
  return numbers;
}

// The surface through the given vertices, with the vertices of what is drawn.
Result<std::vector<Point>> interpolating(const DrawnSurface& surface, const Rules& rules,
                                         const Context& context) {
  if (surface.levels == 0) return surface.given.points;
  const auto solved = interpolate(surface.given, {.rules = rules, .tolerance = 1e-12}, context);
  if (!solved) return tl::make_unexpected(solved.error());
  auto refined = limit_mesh(solved->control, rules, surface.levels, context);
  if (!refined) return tl::make_unexpected(refined.error());
  return std::move(refined->points);
}

// Where the mesh itself is drawn, its vertices show how far their own limit is.
Result<std::vector<double>> errors(const DrawnSurface& surface, const Context& context) {
  const Rules rules = *surface.rules;
  std::vector<Point> limit = surface.drawn.points;
  if (surface.levels == 0) {
    auto at_vertices = limit_positions(surface.given, rules, context);
    if (!at_vertices) return tl::make_unexpected(at_vertices.error());
    limit = std::move(*at_vertices);
  }
  const auto through = interpolating(surface, rules, context);
  if (!through) return tl::make_unexpected(through.error());
  std::vector<double> numbers;
  for (std::size_t v = 0; v < limit.size(); ++v) {
    const Point& a = limit[v];
    const Point& b = (*through)[v];
    numbers.push_back(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  return numbers;
}

// The next of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 times a power of ten.
double round_up(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (x <= step * power * (1 + 1e-12)) return step * power;
  }
  return 10 * power;
}

}  // namespace

const char* name_of(RenderStyle style) {
  switch (style) {
    case RenderStyle::matte: return "matte";
    case RenderStyle::reflection: return "reflection";
    case RenderStyle::wireframe: return "wireframe";
    case RenderStyle::curvature: return "curvature";
    case RenderStyle::gaussian: return "gaussian";
    case RenderStyle::error: return "error";
  }
  return "unknown";
}

const std::vector<RenderStyle>& all_render_styles() {
  static const std::vector<RenderStyle> styles = {RenderStyle::matte,     RenderStyle::reflection,
                                                  RenderStyle::wireframe, RenderStyle::curvature,
                                                  RenderStyle::gaussian,  RenderStyle::error};
  return styles;
}

Result<RenderStyle> render_style_named(const std::string& name) {
  std::vector<std::string> names;
  for (const RenderStyle style : all_render_styles()) {
    if (name == name_of(style)) return style;
    names.emplace_back(name_of(style));
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("--style knows no '{}'{} (styles: {})", name, suggestion(name, names),
                          fmt::join(names, ", ")));
}

bool has_scale(RenderStyle style) {
  return style == RenderStyle::curvature || style == RenderStyle::gaussian ||
         style == RenderStyle::error;
}

Result<std::vector<double>> numbers_of(RenderStyle style, const DrawnSurface& surface,
                                       const Mesh* against, Session& session) {
  return session.timed("measure", [&]() -> Result<std::vector<double>> {
    if (style != RenderStyle::error) return curvatures(style, surface.drawn, session.context);
    auto found = against != nullptr ? distances_to(surface.drawn.points, *against, session.context)
                                    : errors(surface, session.context);
    if (!found) return found;
    const double side = bounding_box(surface.given.points).side();
    for (double& x : *found) x /= side > 0 ? side : 1;
    return found;
  });
}

Range scale_for(RenderStyle style, const std::vector<std::vector<double>>& numbers) {
  constexpr double kShown = 0.97;
  constexpr double kLeast = 1e-15;  // what is less is rounding
  std::vector<double> sizes;
  for (const auto& list : numbers) {
    for (const double x : list) {
      if (std::isfinite(x)) sizes.push_back(std::abs(x));
    }
  }
  if (sizes.empty()) return {0, 1};
  std::sort(sizes.begin(), sizes.end());
  const bool signs = style != RenderStyle::error;
  const auto last = static_cast<double>(sizes.size() - 1);
  const double large = sizes[static_cast<std::size_t>(signs ? kShown * last : last)];
  const double end = round_up(std::max(large, kLeast));
  return {signs ? -end : 0, end};
}

}  // namespace surpass::cli

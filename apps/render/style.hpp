// The styles of `surpass render`, and the numbers that some of them show.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>

#include <optional>
#include <string>
#include <vector>

#include "session.hpp"

namespace surpass::cli {

enum class RenderStyle { matte, reflection, wireframe, curvature, gaussian, error };

[[nodiscard]] const char* name_of(RenderStyle style);
[[nodiscard]] const std::vector<RenderStyle>& all_render_styles();
[[nodiscard]] Result<RenderStyle> render_style_named(const std::string& name);

/// Whether the style shows numbers, with a scale.
[[nodiscard]] bool has_scale(RenderStyle style);

/// The ends of a scale.
struct Range {
  double low = 0;
  double high = 0;
};

/// One of the surfaces to draw, and where it comes from.
struct DrawnSurface {
  std::string path;
  Mesh given;                  ///< as read and mended
  std::optional<Rules> rules;  ///< of the limit surface; none if the mesh itself is drawn
  int levels = 0;              ///< of refinement, if the limit surface is drawn
  Mesh drawn;
};

/// The style's number at each vertex of what is drawn: the mean or the Gaussian curvature, in the
/// units of the file; or the distance, relative to the largest side of the given mesh's box, of the
/// vertex from the nearest point of the mesh `against`. Without that: how far the limit surface of
/// the given mesh is from the surface that passes through the given vertices, point by point at
/// the same parameters - at the given vertices this is their distance to the limit surface.
[[nodiscard]] Result<std::vector<double>> numbers_of(RenderStyle style, const DrawnSurface& surface,
                                                     const Mesh* against, Session& session);

/// A scale for all of these numbers with round ends: from 0 to the largest error; for curvatures
/// from -X to X, beyond which are at most three in a hundred.
[[nodiscard]] Range scale_for(RenderStyle style, const std::vector<std::vector<double>>& numbers);

}  // namespace surpass::cli

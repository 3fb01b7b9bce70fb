// The pictures of `surpass render`, joined into one.
#pragma once

#include "style.hpp"

namespace surpass::cli {

/// What the options say, as text where they are several numbers.
struct PictureWishes {
  std::string size = "1024x768";
  std::string camera = "30,20";
  std::string range;
  char up = 'y';
  bool edges = false;
  bool flat = false;
  double point_radius = 0;
  int columns = 0;
};

/// What is drawn, and how.
struct PictureContent {
  std::vector<DrawnSurface> surfaces;
  std::vector<RenderStyle> styles;
  std::vector<Mesh> left;  ///< as facets with their edges, before all others
  std::optional<Mesh> against;
  std::vector<Point> marks;
  std::vector<Point> frame;  ///< what is fitted into the view; empty: what is drawn
};

/// The bytes of a PNG file: what is to the left, then every surface in every style, in rows. The
/// report gets its size and what is where. Fails where options are no numbers.
[[nodiscard]] Result<std::string> draw_picture(const PictureContent& scene,
                                               const PictureWishes& wishes, Session& session);

}  // namespace surpass::cli

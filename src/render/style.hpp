// A style of shading is one function from a place on the surface to light.
#pragma once

#include "render/camera.hpp"

namespace surpass::picture {

/// A place on the surface, as the viewer sees it.
struct SurfacePlace {
  Vec3 position;
  Vec3 normal;                    ///< to shade with; unit, turned to the viewer
  Vec3 facet;                     ///< the triangle's or the ball's own; unit, turned to the viewer
  Vec3 to_eye;                    ///< unit
  bool back = false;              ///< the back of a face is seen
  bool ball = false;              ///< a marked point, not the mesh
  Colour paint = Colour::Zero();  ///< what a field says here
};

/// Light that reaches the viewer. `sky` is what comes from wide lights if nothing stands before
/// them; folds of the surface get less of it.
struct Light {
  Colour direct = Colour::Zero();
  Colour sky = Colour::Zero();
};

using Style = Light (*)(const SurfacePlace&, const Camera&);

/// Clay under a soft key light with a fill and a sky.
[[nodiscard]] Light matte(const SurfacePlace& place, const Camera& camera);

/// Bands of the lamps that a mirror would show; balls stay matte.
[[nodiscard]] Light reflection(const SurfacePlace& place, const Camera& camera);

/// The place's own paint, little shaded; balls stay matte.
[[nodiscard]] Light painted(const SurfacePlace& place, const Camera& camera);

/// White paper to draw edges on.
[[nodiscard]] Light paper(const SurfacePlace& place, const Camera& camera);

}  // namespace surpass::picture

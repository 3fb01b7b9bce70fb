// Weights of one place over the points of a patch's neighbourhood, on their way to control points.
#pragma once

#include <array>

#include "scheme/settle.hpp"

namespace surpass {

/// As in SurfaceStencil, over all points; empty where there is none.
struct PlaceRows {
  Mask position, du, dv, duu, duv, dvv, tangent_u, tangent_v;
  bool has_plane = true;

  [[nodiscard]] std::array<Mask*, 8> all() {
    return {&position, &du, &dv, &duu, &duv, &dvv, &tangent_u, &tangent_v};
  }
};

}  // namespace surpass

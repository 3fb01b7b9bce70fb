// The quarters of the unit square: a face's, where refinement cuts it into a quad at each corner.
#pragma once

#include <surpass/evaluate.hpp>

namespace surpass {

/// The quarter that holds (u, v), which become its parameters. Its corner 0 is that of the square,
/// so quarter k is turned by k right angles.
[[nodiscard]] inline Index enter_quarter(double& u, double& v) {
  const bool right = u > 0.5;
  const bool upper = v > 0.5;
  const double du = 2 * (right ? 1 - u : u);
  const double dv = 2 * (upper ? 1 - v : v);
  const Index k = upper ? (right ? 2 : 3) : (right ? 1 : 0);
  u = k % 2 == 0 ? du : dv;
  v = k % 2 == 0 ? dv : du;
  return k;
}

/// The same place on the mesh refined once, whose faces are one per corner of the mesh's. A
/// direction of derivatives goes along: a du + b dv is that of the same numbers a, b there.
[[nodiscard]] inline SurfacePlace refined_place(const Mesh& mesh, SurfacePlace place,
                                                std::array<double, 2>& along) {
  Index corner = place.corner;
  if (corner == kNone) {
    corner = enter_quarter(place.u, place.v);
    const auto [a, b] = along;
    switch (corner) {
      case 0: along = {2 * a, 2 * b}; break;
      case 1: along = {2 * b, -2 * a}; break;
      case 2: along = {-2 * a, -2 * b}; break;
      default: along = {-2 * b, 2 * a}; break;
    }
  }
  return {mesh.face_offsets[place.face] + corner, place.u, place.v};
}

}  // namespace surpass

// Vectors of the renderer: single precision, in a frame that is about one unit large.
#pragma once

#include <surpass/mesh.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace surpass::picture {

using Vec2 = Eigen::Vector2f;
using Vec3 = Eigen::Vector3f;

/// Linear red, green, blue.
using Colour = Eigen::Array3f;

[[nodiscard]] inline Eigen::Vector3d to_vector(const Point& p) { return {p[0], p[1], p[2]}; }

}  // namespace surpass::picture

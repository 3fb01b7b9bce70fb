#pragma once

#include <surpass/mesh.hpp>

#include <Eigen/Core>

namespace surpass::reconstruction {

[[nodiscard]] inline Eigen::Vector3d as_vector(const Point& p) { return {p[0], p[1], p[2]}; }

}  // namespace surpass::reconstruction

// Patches that are bicubic B-splines, by the rules of boundaries along their sharp edges.
#pragma once

#include "scheme/catmull_clark_neighbourhood.hpp"

namespace surpass::catmull_clark {

/// At (u, v) in [0,1]^2 on the face of a regular neighbourhood.
[[nodiscard]] PlaceRows spline_patch_rows(const Neighbourhood& patch, double u, double v);

}  // namespace surpass::catmull_clark

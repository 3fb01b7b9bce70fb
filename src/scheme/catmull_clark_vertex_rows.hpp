// The surface at a vertex that stays irregular, as seen from one of its faces.
#pragma once

#include "scheme/catmull_clark_neighbourhood.hpp"

namespace surpass::catmull_clark {

/// At the corner of a face with RingPlace `corner`, whose ring is over `points` points; du along
/// the edge that leaves the corner, dv along the one before, as SurfaceSample describes.
[[nodiscard]] PlaceRows vertex_rows(const RingPlace& corner, std::size_t points);

}  // namespace surpass::catmull_clark

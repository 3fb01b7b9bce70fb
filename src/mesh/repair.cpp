#include "mesh/repair_steps.hpp"

namespace surpass {

Mended repair(const Mesh& mesh) {
  Mended mended{mesh, {}};
  repair_step::drop_degenerate_faces(mended);
  repair_step::drop_repeated_faces(mended);
  repair_step::separate_repeated_corners(mended);
  repair_step::orient_consistently(mended);
  repair_step::split_non_manifold(mended);
  repair_step::turn_outward(mended);
  return mended;
}

}  // namespace surpass

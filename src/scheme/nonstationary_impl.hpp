// The inside of NonstationaryLoop.
#pragma once

#include "scheme/nonstationary_state.hpp"

namespace surpass {

struct NonstationaryLoop::Impl {
  Mesh mesh;
  nonstationary::State state;
  std::vector<std::string> notes;
  std::vector<Point> aims;
  /// Limits at level 0 are taken from level 1.
  bool first_step_is_its_own = false;
  std::vector<Point> normals;  ///< of what at_limit() gives only

  struct Neighbourhood {
    Topology topology;
    Sharpness sharpness;
  };
  [[nodiscard]] Result<Neighbourhood> neighbourhood() const;
  Result<void> refine(const Context& context);

  /// Positions and channels of `values`, the mesh or its positions alone, in the limit; and the
  /// normals there.
  [[nodiscard]] Result<Impl> at_limit(const Mesh& values, bool with_normals,
                                      const Context& context) const;

  /// Vertices on smooth curves where the normal at level 0 is on the other side than the faces'.
  [[nodiscard]] Result<std::vector<Index>> folds(const Neighbourhood& around,
                                                 const Context& context) const;
  /// `around` is the mesh's; its sharp vertices are then those with the new corners.
  Result<void> make_corners_at_folds(Neighbourhood& around, const Context& context);
};

}  // namespace surpass

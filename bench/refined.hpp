// What one refinement step must give, from formulas without our library's code, and the comparison
// of meshes that number their new vertices in whatever way.
#pragma once

#include <surpass/scheme.hpp>

#include <memory>
#include <span>
#include <vector>

#include "harness.hpp"

namespace surpass::bench {

/// The mesh that is refined under a scheme: triangles for Loop, else quads.
[[nodiscard]] const Mesh& given(const Workload& workload, Scheme scheme);

/// A refined mesh as anybody may hold it: the given vertices come first and in order, then the
/// others in any; all faces have `size` corners, which start anywhere.
struct RefinedFaces {
  std::vector<Point> points = {};
  std::vector<Index> corners = {};
  Index size = 3;
};

/// Largest distance of a point from where the formulas put it. Doubles must agree to 1e-14 of the
/// box side; OpenMesh's weights went through floats, which is allowed for.
enum class Agreement { doubles, float_weights };
[[nodiscard]] Verdict judge_refined(const Workload& workload, Scheme scheme,
                                    const RefinedFaces& refined, Agreement agreement);

}  // namespace surpass::bench

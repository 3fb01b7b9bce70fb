#include "quality/curvature_variation.hpp"

#include <cmath>

#include <Eigen/Dense>

namespace surpass {
namespace {

// The gradient of the linear function on the triangle, by the metric of its two edges from a.
CurvatureVariation on_triangle(const SampledSurface& surface, Index a, Index b, Index c) {
  const std::vector<LimitJet>& jets = surface.samples.jets;
  Eigen::Matrix<double, 3, 2> edges;
  edges << jets[b].position - jets[a].position, jets[c].position - jets[a].position;
  const double h = surface.curvature[a].mean();
  const Eigen::Vector2d rise(surface.curvature[b].mean() - h, surface.curvature[c].mean() - h);
  const double area = edges.col(0).cross(edges.col(1)).norm() / 2;
  if (!(area > 0)) return {};
  // |grad|^2 = rise' (edges' edges)^-1 rise, whose determinant is 4 area^2.
  const Eigen::Vector3d across = rise[0] * edges.col(1) - rise[1] * edges.col(0);
  const double slope = across.norm() / (2 * area);
  return {slope * slope * area, slope * area};
}

}  // namespace

CurvatureVariation curvature_variation(const SampledSurface& surface, const MeasuredPart& part,
                                       const Context& context) {
  const Mesh& mesh = surface.samples.mesh;
  std::vector<unsigned char> is_hole(mesh.face_count(), 0);
  for (const Index f : mesh.hole_faces) is_hole[f] = 1;
  const auto on_face = [&](Index f) {
    CurvatureVariation sum;
    const auto face = mesh.face(f);
    const auto measured = [&](Index v) { return part.measure[v] > 0; };
    if (is_hole[f] != 0 || !std::all_of(face.begin(), face.end(), measured)) return sum;
    // Every corner with its two neighbours: each triangle of a cut comes up equally often.
    const std::size_t n = face.size();
    const double share = static_cast<double>(n - 2) / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto part_of = on_triangle(surface, face[i], face[(i + 1) % n], face[(i + n - 1) % n]);
      sum.square += share * part_of.square;
      sum.total += share * part_of.total;
    }
    return sum;
  };
  const auto add = [](const CurvatureVariation& a, const CurvatureVariation& b) {
    return CurvatureVariation{a.square + b.square, a.total + b.total};
  };
  return parallel::reduce(
      context, mesh.face_count(), CurvatureVariation{},
      [&](std::size_t begin, std::size_t end) {
        CurvatureVariation sum;
        for (std::size_t f = begin; f < end; ++f) sum = add(sum, on_face(static_cast<Index>(f)));
        return sum;
      },
      add);
}

}  // namespace surpass

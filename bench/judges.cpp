#include "judges.hpp"

#include <algorithm>
#include <limits>

namespace surpass::bench {

Verdict judge_valences(const Workload& workload, std::span<const Index> valences) {
  // In a closed mesh a vertex has as many edges as faces.
  std::vector<Index> expected(workload.mesh().points.size(), 0);
  for (const Index v : workload.mesh().face_vertices) ++expected[v];
  if (valences.size() != expected.size()) return {.difference = 1};
  std::size_t wrong = 0;
  for (std::size_t v = 0; v < expected.size(); ++v) wrong += expected[v] != valences[v] ? 1U : 0U;
  return {.difference = static_cast<double>(wrong) / static_cast<double>(expected.size())};
}

Verdict judge_limits(const Workload& workload, std::span<const Point> limits) {
  return {.difference = workload.difference(limits, workload.limits()), .allowed = 1e-12};
}

Verdict judge_control(const Workload& workload, std::span<const Point> control) {
  return {.difference = workload.difference(control, workload.control()),
          .allowed = 1e-9,
          .error = workload.interpolation_error(control)};
}

Verdict judge_file(const Workload& workload, std::span<const Point> points,
                   std::span<const Index> corners, Precision precision) {
  const auto& expected = workload.mesh().face_vertices;
  const double allowed = precision == Precision::doubles ? 0 : 1e-7;
  if (!std::equal(corners.begin(), corners.end(), expected.begin(), expected.end())) {
    return {.difference = std::numeric_limits<double>::infinity(), .allowed = allowed};
  }
  return {.difference = workload.difference(points, workload.mesh().points), .allowed = allowed};
}

}  // namespace surpass::bench

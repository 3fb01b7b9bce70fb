// What a result is compared with, the same for every contender of a step.
#pragma once

#include <span>
#include <vector>

#include "harness.hpp"

namespace surpass::bench {

/// Share of the vertices whose number of edges is not the mesh's; none is allowed.
[[nodiscard]] Verdict judge_valences(const Workload& workload, std::span<const Index> valences);

/// Limit points of the mesh, to 1e-12 of the box side.
[[nodiscard]] Verdict judge_limits(const Workload& workload, std::span<const Point> limits);

/// Control points: to 1e-9 those that the library finds at a far smaller tolerance, and within
/// the tolerance of the given points when a matrix that is not the library's evaluates them.
[[nodiscard]] Verdict judge_control(const Workload& workload, std::span<const Point> control);

/// A mesh read from a file: the same corners, and the same points, bit for bit unless the reader
/// holds floats.
enum class Precision { doubles, floats };
[[nodiscard]] Verdict judge_file(const Workload& workload, std::span<const Point> points,
                                 std::span<const Index> corners, Precision precision);

}  // namespace surpass::bench

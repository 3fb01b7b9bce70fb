// Points in the files of reference values.
#pragma once

#include <surpass/mesh.hpp>

#include <vector>

#include <nlohmann/json.hpp>

namespace surpass {

inline std::vector<Point> points_of(const nlohmann::json& rows) {
  std::vector<Point> points;
  for (const auto& row : rows) points.push_back({row[0], row[1], row[2]});
  return points;
}

}  // namespace surpass

#include <surpass/mesh.hpp>

#include <algorithm>

namespace surpass {

std::string Mesh::annotation(std::string_view key) const {
  for (const auto& [name, value] : annotations) {
    if (name == key) return value;
  }
  return {};
}

void Mesh::annotate(std::string_view key, std::string_view value) {
  for (auto& [name, old] : annotations) {
    if (name == key) {
      old = value;
      return;
    }
  }
  annotations.emplace_back(key, value);
}

void Mesh::forget(std::string_view key) {
  std::erase_if(annotations, [key](const auto& annotation) { return annotation.first == key; });
}

bool all_triangles(const Mesh& mesh) {
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face_offsets[f + 1] - mesh.face_offsets[f] != 3) return false;
  }
  return true;
}

double Box::side() const {
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

Box bounding_box(std::span<const Point> points) {
  if (points.empty()) return {};
  Box box{points.front(), points.front()};
  for (const Point& p : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  }
  return box;
}

}  // namespace surpass

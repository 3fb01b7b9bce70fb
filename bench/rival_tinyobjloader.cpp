// tinyobjloader, in the build that holds doubles.
#include <tiny_obj_loader.h>

#include "contenders.hpp"
#include "judges.hpp"

namespace surpass::bench {
namespace {

// The reader holds its arrays behind an interface that cannot be copied.
std::unique_ptr<tinyobj::ObjReader> read(const std::string& path) {
  auto reader = std::make_unique<tinyobj::ObjReader>();
  tinyobj::ObjReaderConfig config;
  config.triangulate = false;
  reader->ParseFromFile(path, config);
  return reader;
}

Verdict judge(const Workload& workload, const std::unique_ptr<tinyobj::ObjReader>& reader) {
  const auto& numbers = reader->GetAttrib().vertices;
  std::vector<Point> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  std::vector<Index> corners;
  for (const auto& shape : reader->GetShapes()) {
    for (const auto& index : shape.mesh.indices) {
      corners.push_back(static_cast<Index>(index.vertex_index));
    }
  }
  return judge_file(workload, points, corners, Precision::floats);
}

}  // namespace

void add_tinyobjloader(Harness& harness, Index side) {
  for (const char* step : {"read OBJ", "whole command"}) {
    harness.add(
        {.step = step,
         .tool = "tinyobjloader",
         .counted = "ObjReader::ParseFromFile without triangulation, double build; nothing else"},
        side, [](const Workload& w) { return [path = w.obj()] { return read(path); }; }, judge);
  }
}

}  // namespace surpass::bench

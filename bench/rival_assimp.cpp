// Assimp without any post-processing. From OBJ it gives every face corner a vertex of its own, so
// corners are compared by position there.
#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include "contenders.hpp"
#include "judges.hpp"

namespace surpass::bench {
namespace {

using Scene = std::unique_ptr<Assimp::Importer>;  // owns what it has read

Scene read(const std::string& path) {
  auto importer = std::make_unique<Assimp::Importer>();
  importer->ReadFile(path, 0);
  return importer;
}

std::vector<Point> points_of(const aiMesh& mesh) {
  std::vector<Point> points;
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D& p = mesh.mVertices[v];
    points.push_back({p.x, p.y, p.z});
  }
  return points;
}

std::vector<Index> corners_of(const aiMesh& mesh) {
  std::vector<Index> corners;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    corners.insert(corners.end(), face.mIndices, face.mIndices + face.mNumIndices);
  }
  return corners;
}

const aiMesh* only_mesh(const Scene& scene) {
  const aiScene* read = scene->GetScene();
  return read != nullptr && read->mNumMeshes == 1 ? read->mMeshes[0] : nullptr;
}

Verdict judge_shared(const Workload& workload, const Scene& scene) {
  const aiMesh* mesh = only_mesh(scene);
  if (mesh == nullptr) return {.difference = 1};
  return judge_file(workload, points_of(*mesh), corners_of(*mesh), Precision::floats);
}

Verdict judge_split(const Workload& workload, const Scene& scene) {
  const aiMesh* mesh = only_mesh(scene);
  if (mesh == nullptr) return {.difference = 1};
  const auto points = points_of(*mesh);
  std::vector<Point> got;
  for (const Index v : corners_of(*mesh)) got.push_back(points[v]);
  std::vector<Point> expected;
  for (const Index v : workload.mesh().face_vertices) expected.push_back(workload.mesh().points[v]);
  return {.difference = workload.difference(got, expected), .allowed = 1e-7};
}

}  // namespace

void add_assimp(Harness& harness, Index side) {
  harness.add(
      {.step = "read OBJ",
       .tool = "Assimp",
       .counted = "Importer::ReadFile, no post-processing; corners are not shared"},
      side, [](const Workload& w) { return [path = w.obj()] { return read(path); }; }, judge_split);
  harness.add(
      {.step = "read PLY", .tool = "Assimp", .counted = "Importer::ReadFile, no post-processing"},
      side, [](const Workload& w) { return [path = w.ply()] { return read(path); }; },
      judge_shared);
}

}  // namespace surpass::bench

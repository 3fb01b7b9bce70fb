// Angle weights: Thuermer and Wuethrich, Computing vertex normals from polygonal facets, 1998.
#include "render/corner_normals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "parallel/parallel.hpp"

namespace surpass::picture {
namespace {

using Eigen::Vector3d;

// A value for each of `n` faces, corners or edges.
template <class T, class Value>
std::vector<T> for_each_index(std::size_t n, const Context& context, const Value& value) {
  std::vector<T> values(n);
  parallel::for_ranges(context, n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) values[i] = value(static_cast<Index>(i));
  });
  return values;
}

Vector3d face_normal(const Mesh& mesh, Index f) {
  const auto face = mesh.face(f);
  const Vector3d first = to_vector(mesh.points[face[0]]);
  Vector3d area = Vector3d::Zero();
  for (std::size_t k = 2; k < face.size(); ++k) {
    area += (to_vector(mesh.points[face[k - 1]]) - first)
                .cross(to_vector(mesh.points[face[k]]) - first);
  }
  return area.stableNormalized();
}

std::vector<Vector3d> face_normals(const Mesh& mesh, const Context& context) {
  return for_each_index<Vector3d>(mesh.face_count(), context,
                                  [&](Index f) { return face_normal(mesh, f); });
}

const Channel* normal_channel(const Mesh& mesh) {
  for (const Channel& channel : mesh.channels) {
    if (channel.name == "normal" && channel.width() == 3) return &channel;
  }
  return nullptr;
}

class Smoother {
 public:
  Smoother(const Mesh& mesh, const Topology& topology, double crease_angle, const Context& context)
      : mesh_(mesh),
        topology_(topology),
        given_(normal_channel(mesh)),
        faces_(face_normals(mesh, context)),
        angles_(for_each_index<double>(topology.corner_count(), context,
                                       [this](Index h) { return corner_angle(h); })) {
    find_hard_edges(given_ != nullptr ? 180 : crease_angle);
  }

  std::vector<Vec3> run() {
    normals_.assign(topology_.corner_count(), Vec3::Zero());
    done_.assign(topology_.corner_count(), false);
    // Sectors that begin at a hard edge first, then the vertices that have none.
    for (Index h = 0; h < topology_.corner_count(); ++h) {
      if (hard_[topology_.edge(h)]) shade_sector(h);
    }
    for (Index h = 0; h < topology_.corner_count(); ++h) {
      if (!done_[h]) shade_sector(h);
    }
    return std::move(normals_);
  }

 private:
  void find_hard_edges(double crease_angle) {
    const double least_cosine = std::cos(crease_angle * std::numbers::pi / 180);
    hard_.assign(topology_.edge_count(), false);
    for (Index e = 0; e < topology_.edge_count(); ++e) {
      const Index h = topology_.edge_halfedge(e);
      const Index o = topology_.opposite(h);
      hard_[e] =
          o == kNone || faces_[topology_.face(h)].dot(faces_[topology_.face(o)]) < least_cosine;
    }
    for (const Crease& crease : mesh_.creases) {
      const Index e = topology_.find_edge(crease.vertices[0], crease.vertices[1]);
      if (e != kNone && crease.sharpness > 0) hard_[e] = true;
    }
  }

  // The corners from half-edge `start` counterclockwise to the next hard edge.
  void shade_sector(Index start) {
    Vector3d sum = Vector3d::Zero();
    Index h = start;
    do {
      sum += angles_[h] * faces_[topology_.face(h)];
      h = topology_.rotate(h);
    } while (h != kNone && h != start && !hard_[topology_.edge(h)]);
    const bool whole = h == start || (h == kNone && topology_.opposite(start) == kNone);
    const Vec3 normal = sector_normal(topology_.tail(start), whole, sum);
    for (Index k = start; k != kNone && !done_[k]; k = topology_.rotate(k)) {
      if (k != start && hard_[topology_.edge(k)]) break;
      normals_[k] = normal;
      done_[k] = true;
    }
  }

  [[nodiscard]] Vec3 sector_normal(Index v, bool whole, const Vector3d& sum) const {
    if (given_ != nullptr && whole && !topology_.is_bowtie(v)) {
      const double* n = &given_->values[std::size_t{3} * v];
      const Vector3d given(n[0], n[1], n[2]);
      if (given.allFinite() && !given.isZero(0)) return given.stableNormalized().cast<float>();
    }
    return sum.stableNormalized().cast<float>();
  }

  [[nodiscard]] double corner_angle(Index h) const {
    const Vector3d at = to_vector(mesh_.points[topology_.tail(h)]);
    const Vector3d a = (to_vector(mesh_.points[topology_.head(h)]) - at).stableNormalized();
    const Index last = topology_.tail(topology_.previous(h));
    const Vector3d b = (to_vector(mesh_.points[last]) - at).stableNormalized();
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  const Mesh& mesh_;
  const Topology& topology_;
  const Channel* given_;
  std::vector<Vector3d> faces_;
  std::vector<double> angles_;  // of the faces at their corners
  std::vector<bool> hard_;
  std::vector<bool> done_;
  std::vector<Vec3> normals_;
};

}  // namespace

std::vector<Vec3> facet_normals(const Mesh& mesh, const Context& context) {
  const std::vector<Vector3d> faces = face_normals(mesh, context);
  std::vector<Vec3> normals;
  normals.reserve(mesh.corner_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    normals.insert(normals.end(), mesh.face(f).size(), faces[f].cast<float>());
  }
  return normals;
}

std::vector<Vec3> smooth_normals(const Mesh& mesh, const Topology& topology, double crease_angle,
                                 const Context& context) {
  return Smoother(mesh, topology, crease_angle, context).run();
}

}  // namespace surpass::picture

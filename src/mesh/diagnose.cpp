// A sound mesh is recognised by building its topology; only where that fails are the refusals
// collected one by one.
#include <surpass/repair.hpp>
#include <surpass/topology.hpp>

#include <cmath>
#include <map>

#include "mesh/corner_faces.hpp"
#include "mesh/edge_buckets.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/refusals.hpp"
#include "mesh/remarks.hpp"
#include "mesh/repeated_faces.hpp"

namespace surpass {
namespace {

class Examiner {
 public:
  Examiner(const Mesh& mesh, std::size_t limit)
      : mesh_(mesh), limit_(limit), skip_(mesh.face_count(), 0) {}

  Diagnosis run() {
    if (mesh_.face_vertices.size() > kMostCorners || mesh_.points.size() > kMostCorners) {
      refuse(ErrorCode::too_large, [] { return refusal::too_large(); });
      return std::move(diagnosis_);
    }
    const auto topology = Topology::build(mesh_);
    if (!topology) {
      examine_faces();
      examine_edges();
    }
    examine_points();
    diagnosis_.remarks = remarks_on(mesh_, topology ? &*topology : nullptr, skip_, limit_);
    return std::move(diagnosis_);
  }

 private:
  template <class Make>
  void refuse(ErrorCode code, Make&& make) {
    ++diagnosis_.refusal_count;
    if (++count_[code] <= limit_) diagnosis_.refusals.push_back(make());
  }

  // Faces that are wrong by themselves, and repeats of a face.
  void examine_faces() {
    refusal::FaceCheck check(mesh_);
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      auto error = check(f);
      if (!error) continue;
      skip_[f] = 1;
      refuse(error->code, [&] { return *error; });
    }
    edges_ = EdgeTable(mesh_, skip_);
    for (const RepeatedFace& repeat : find_repeated_faces(mesh_, skip_)) {
      if (is_back_to_back(mesh_, edges_, repeat.face)) continue;
      refuse(ErrorCode::duplicate_face,
             [&] { return refusal::duplicate_face(repeat.face, repeat.first); });
    }
  }

  void examine_edges() {
    const auto face_of = corner_faces(mesh_);
    for (Index e = 0; e < edges_.edge_count(); ++e) {
      const auto sides = edges_.halfedges(e);
      if (sides.size() < 2 || edges_.is_regular(e)) continue;
      const Index face = face_of[sides[0]];
      if (sides.size() > 2) {
        refuse(ErrorCode::non_manifold_edge, [&] {
          return refusal::non_manifold_edge(face, edges_.vertices(e),
                                            static_cast<Index>(sides.size()));
        });
      } else {
        refuse(ErrorCode::inconsistent_orientation,
               [&] { return refusal::inconsistent_orientation(face, edges_.vertices(e)); });
      }
    }
  }

  void examine_points() {
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      const Point& p = mesh_.points[v];
      if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) continue;
      refuse(ErrorCode::not_finite, [&] { return refusal::not_finite(v, p); });
    }
  }

  const Mesh& mesh_;
  std::size_t limit_;
  std::vector<unsigned char> skip_;
  EdgeTable edges_{Mesh{}};
  Diagnosis diagnosis_;
  std::map<ErrorCode, std::size_t> count_;
};

}  // namespace

Diagnosis diagnose(const Mesh& mesh, std::size_t limit) { return Examiner(mesh, limit).run(); }

}  // namespace surpass

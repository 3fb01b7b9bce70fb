// Some faces of a mesh, whose vertices have numbers of their own.
#pragma once

#include <surpass/topology.hpp>

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

namespace surpass {

/// Vertices are numbered in the order in which they come, so that faces joined alike are equal,
/// whatever their numbers in the mesh.
class NumberedFaces {
 public:
  void clear() {
    vertices_.clear();
    corners_.clear();
  }
  Index number(Index v) {
    const auto at = std::find(vertices_.begin(), vertices_.end(), v) - vertices_.begin();
    if (at == std::ssize(vertices_)) vertices_.push_back(v);
    return static_cast<Index>(at);
  }
  /// The face of half-edge h, from the tail of h on.
  void add(const Topology& topology, Index h) {
    corners_.push_back(topology.face_degree(topology.face(h)));
    Index k = h;
    do {
      corners_.push_back(number(topology.tail(k)));
      k = topology.next(k);
    } while (k != h);
  }
  void add(std::initializer_list<Index> vertices) {
    corners_.push_back(static_cast<Index>(vertices.size()));
    for (const Index v : vertices) corners_.push_back(number(v));
  }

  /// By number, the mesh's vertices.
  [[nodiscard]] const std::vector<Index>& vertices() const { return vertices_; }
  /// Calls use(numbers of its vertices) for each face.
  template <class Use>
  void for_each(Use&& use) const {
    for (std::size_t k = 0; k < corners_.size(); k += corners_[k] + 1) {
      use(std::span(corners_).subspan(k + 1, corners_[k]));
    }
  }
  /// The same bytes for faces joined alike.
  [[nodiscard]] std::string_view key() const {
    return {reinterpret_cast<const char*>(corners_.data()), corners_.size() * sizeof(Index)};
  }
  /// As a mesh, without positions.
  [[nodiscard]] Mesh mesh() const {
    Mesh mesh;
    mesh.points.resize(vertices_.size());
    for_each([&](std::span<const Index> face) { mesh.add_face(face); });
    return mesh;
  }

 private:
  std::vector<Index> vertices_;
  std::vector<Index> corners_;  // of each face: how many, and their numbers
};

}  // namespace surpass

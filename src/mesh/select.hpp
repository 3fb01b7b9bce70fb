// Building a mesh from pieces of another, with everything that hangs on them.
#pragma once

#include <surpass/mesh.hpp>

#include <vector>

namespace surpass {

/// Where the elements of a new mesh come from in an old one.
struct Selection {
  std::vector<Index> vertex_image;   ///< #V old: the new vertex that it becomes, or kNone
  std::vector<Index> vertex_source;  ///< #V new: the old vertex whose point and channels it takes
  std::vector<Index> face_source;    ///< #F new: old faces, ascending; one may give several
  std::vector<Index> face_offsets = {0};  ///< #F new + 1
  std::vector<Index> corner_source;       ///< #C new: the old corner whose channel rows it takes
  std::vector<Index> face_vertices;       ///< #C new: a new vertex per corner

  /// Every vertex of the mesh as it is; no faces yet.
  [[nodiscard]] static Selection of_all_vertices(const Mesh& mesh);

  /// The vertices marked 1 in `used` (#V); no faces yet.
  [[nodiscard]] static Selection of_vertices(const std::vector<unsigned char>& used);

  /// Another vertex where old vertex v is: a copy. Returns its number.
  Index add_copy(Index v);
  /// A corner of the face that is being built, on the image of the old corner's vertex.
  void add_corner(const Mesh& mesh, Index corner) {
    add_corner(corner, vertex_image[mesh.face_vertices[corner]]);
  }
  void add_corner(Index corner, Index vertex) {
    corner_source.push_back(corner);
    face_vertices.push_back(vertex);
  }
  /// Ends the face that is being built; it comes from old face f.
  void end_face(Index f) {
    face_source.push_back(f);
    face_offsets.push_back(static_cast<Index>(face_vertices.size()));
  }
  /// Face f with all its corners.
  void add_face(const Mesh& mesh, Index f) {
    for (Index c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c) add_corner(mesh, c);
    end_face(f);
  }
};

/// The new mesh. Channels, face sets, holes, creases and corners follow their elements: a crease or
/// corner goes to the images of its vertices and, where vertices were copied, to the copies along
/// which the faces at the edge now lie. O(#corners + #copies log #copies) and the size of the rest.
[[nodiscard]] Mesh select(const Mesh& mesh, Selection selection);

/// Without hole faces and the vertices that only they use; the first `kept` vertices, or those that
/// are marked in `kept` (#V or fewer), stay in any case.
[[nodiscard]] Selection visible_part(const Mesh& mesh, Index kept);
[[nodiscard]] Selection visible_part(const Mesh& mesh, std::vector<unsigned char> kept);

}  // namespace surpass

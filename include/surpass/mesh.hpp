// A polygon mesh as a plain value. It knows no subdivision scheme and no file format.
#pragma once

#include <surpass/result.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace surpass {

/// A position or a vector: x, y, z.
using Point = std::array<double, 3>;

/// Sharpness is OpenSubdiv's: 0 is smooth, 10 and more is infinitely sharp, in between the rules
/// stay sharp for that many refinement steps. 32-bit as there, so that blended weights agree.
inline constexpr float kInfinitelySharp = 10.0F;

/// A sharp edge, named by its end vertices.
struct Crease {
  std::array<Index, 2> vertices = {};
  float sharpness = kInfinitelySharp;
  bool operator==(const Crease&) const = default;
};

/// A sharp vertex.
struct Corner {
  Index vertex = 0;
  float sharpness = kInfinitelySharp;
  bool operator==(const Corner&) const = default;
};

/// How a file stored a channel's numbers. Writers return to it where every value still fits.
enum class Storage { float64, float32, int8, uint8, int16, uint16, int32, uint32 };

/// Numbers per vertex: colours, weights, anything. Interpolation carries them along.
struct Channel {
  std::string name;                ///< "color", "texture", "normal", or the file's own name
  std::vector<std::string> parts;  ///< a name per column, such as {"red","green","blue"}
  std::vector<double> values;      ///< #V by parts.size(), row after row
  Storage storage = Storage::float64;
  [[nodiscard]] std::size_t width() const { return parts.size(); }
  bool operator==(const Channel&) const = default;
};

/// Numbers per face corner, with seams: a table of values and, at each corner, the row to use.
/// Interpolation leaves them as they are; refinement interpolates them linearly inside faces.
struct CornerChannel {
  std::string name;            ///< "texture" or "normal"
  std::size_t width = 2;       ///< columns of `values`
  std::vector<double> values;  ///< #rows by width
  std::vector<Index> indices;  ///< a row per face corner, parallel to Mesh::face_vertices; or kNone
  bool operator==(const CornerChannel&) const = default;
};

/// Numbers per face (a file's own colours or labels), carried through and inherited by refined
/// faces.
struct FaceChannel {
  std::string name;
  std::vector<std::string> parts;
  std::vector<double> values;  ///< #F by parts.size()
  Storage storage = Storage::float64;
  bool operator==(const FaceChannel&) const = default;
};

/// Named sets of faces: an OBJ file's groups, objects, materials and smoothing groups.
struct FaceSet {
  enum class Kind { group, object, material, smoothing };
  Kind kind = Kind::group;
  std::string name;
  std::vector<Index> faces;  ///< ascending
  bool operator==(const FaceSet&) const = default;
};

/// A polygon mesh. Vertex order and the order of corners in a face survive every operation and
/// file. An empty default value is a valid mesh with no vertices.
struct Mesh {
  std::vector<Point> points;  ///< #V positions
  std::vector<Index> face_offsets = {
      0};                            ///< #F + 1: corners of face f are offsets[f]..offsets[f+1]
  std::vector<Index> face_vertices;  ///< a vertex per corner; counterclockwise seen from outside

  std::vector<Crease> creases;    ///< sharp edges; the last of several for one edge holds
  std::vector<Corner> corners;    ///< sharp vertices
  std::vector<Index> hole_faces;  ///< faces kept in the mesh, not drawn; ascending

  std::vector<Channel> channels;
  std::vector<CornerChannel> corner_channels;
  std::vector<FaceChannel> face_channels;
  std::vector<FaceSet> face_sets;
  std::vector<std::string> material_libraries;  ///< file names, as in OBJ's mtllib
  std::vector<std::string> tags;                ///< OpenSubdiv's further `t` lines
  std::vector<std::pair<std::string, std::string>>
      annotations;  ///< "scheme" and "boundary" of a control mesh

  [[nodiscard]] Index vertex_count() const { return static_cast<Index>(points.size()); }
  [[nodiscard]] Index face_count() const { return static_cast<Index>(face_offsets.size() - 1); }
  [[nodiscard]] Index corner_count() const { return static_cast<Index>(face_vertices.size()); }
  [[nodiscard]] std::span<const Index> face(Index f) const {
    return std::span(face_vertices).subspan(face_offsets[f], face_offsets[f + 1] - face_offsets[f]);
  }
  void add_face(std::span<const Index> vertices) {
    face_vertices.insert(face_vertices.end(), vertices.begin(), vertices.end());
    face_offsets.push_back(static_cast<Index>(face_vertices.size()));
  }
  /// The value of an annotation, or "" where there is none.
  [[nodiscard]] std::string annotation(std::string_view key) const;
  void annotate(std::string_view key, std::string_view value);
  /// Takes an annotation away, if there is one.
  void forget(std::string_view key);

  bool operator==(const Mesh&) const = default;
};

/// True if every face is a triangle.
[[nodiscard]] bool all_triangles(const Mesh& mesh);

/// Axis-parallel bounding box.
struct Box {
  Point low = {};
  Point high = {};
  /// Length of the largest side; 0 for a single point. Tolerances are relative to it.
  [[nodiscard]] double side() const;
};

/// Box of the points; all zero where there are none. O(#points).
[[nodiscard]] Box bounding_box(std::span<const Point> points);

/// The flat view of points that kernels work on: 3 numbers a point.
[[nodiscard]] inline std::span<const double> flat(std::span<const Point> points) {
  return {points.empty() ? nullptr : points.front().data(), 3 * points.size()};
}
[[nodiscard]] inline std::span<double> flat(std::span<Point> points) {
  return {points.empty() ? nullptr : points.front().data(), 3 * points.size()};
}

}  // namespace surpass

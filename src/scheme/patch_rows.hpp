// Derivatives of a limit surface, sampled on every patch, as rows of weights over control points.
//
// A patch is the part of the surface that belongs to a face of the control mesh, or, on Doo-Sabin
// surfaces, to a vertex. Its derivatives depend on the vertices of the faces that touch it, and
// their weights on nothing but how these faces are joined and how sharp they are: most patches of a
// mesh are of few kinds.
#pragma once

#include <surpass/topology.hpp>

#include <cstddef>
#include <span>
#include <vector>

#include "scheme/subdivision_scheme.hpp"

namespace surpass {

/// The derivatives of every patch of a control mesh.
class PatchRows {
 public:
  /// With more faces at a vertex, or corners of a Doo-Sabin face, and so around each of their
  /// patches, what depends on all of them is left out: memory and time would grow with the square
  /// of their number.
  static constexpr Index kMostAround = 256;

  [[nodiscard]] std::size_t patch_count() const { return kind_of_.size(); }
  [[nodiscard]] const PatchKind& kind(std::size_t patch) const { return kinds_[kind_of_[patch]]; }
  [[nodiscard]] Index kind_number(std::size_t patch) const { return kind_of_[patch]; }
  [[nodiscard]] const std::vector<PatchKind>& kinds() const { return kinds_; }
  [[nodiscard]] std::size_t column_count() const { return columns_.size(); }
  /// The control vertices that the kind's columns stand for.
  [[nodiscard]] std::span<const Index> columns(std::size_t patch) const {
    return std::span(columns_).subspan(offsets_[patch], offsets_[patch + 1] - offsets_[patch]);
  }

  /// The vertex that each patch belongs to, ascending; empty where patches belong to faces.
  [[nodiscard]] std::span<const Index> vertices() const { return vertices_; }
  /// The patch of each face, kNone where it has none; empty where patches belong to vertices.
  [[nodiscard]] std::span<const Index> patches_of_faces() const { return patch_of_; }

  /// A patch for every face with `sampled` != 0 (#F; empty: all), in order, but those that are
  /// joined come first; or for every vertex where anything is known, whatever `sampled` says.
  /// `level` refinements lead to the samples: 2^level + 1 along a side. Fails where
  /// Sharpness::build does, with `too_large`, or when cancelled. O(#faces).
  static Result<PatchRows> build(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                 int level, std::span<const unsigned char> sampled,
                                 const Context& context, Sides sides = Sides::each);

  // For the schemes, which build it.
  Index add_kind(PatchKind kind) {
    kinds_.push_back(std::move(kind));
    return static_cast<Index>(kinds_.size() - 1);
  }
  void add_patch(std::span<const Index> columns, Index kind) {
    columns_.insert(columns_.end(), columns.begin(), columns.end());
    offsets_.push_back(static_cast<Index>(columns_.size()));
    kind_of_.push_back(kind);
  }
  /// What a mesh's size decides, for whoever keeps its own way from patches to vertices.
  void forget_columns() {
    // Not {}: that is a list to a vector, which keeps its memory.
    columns_ = std::vector<Index>();
    offsets_ = std::vector<Index>();
    patch_of_ = std::vector<Index>();
  }
  /// The patch that was added last belongs to the face.
  void own_face(Index f, Index face_count) {
    patch_of_.resize(face_count, kNone);
    patch_of_[f] = static_cast<Index>(kind_of_.size() - 1);
  }
  void add_vertex_patch(Index v, std::span<const Index> columns, Index kind) {
    vertices_.push_back(v);
    add_patch(columns, kind);
  }
  void reserve(std::size_t patches, std::size_t columns) {
    offsets_.reserve(patches + 1);
    kind_of_.reserve(patches);
    columns_.reserve(columns);
  }

 private:
  std::vector<Index> offsets_ = {0};
  std::vector<Index> columns_;
  std::vector<Index> kind_of_;
  std::vector<Index> vertices_;
  std::vector<Index> patch_of_;
  std::vector<PatchKind> kinds_;
};

}  // namespace surpass

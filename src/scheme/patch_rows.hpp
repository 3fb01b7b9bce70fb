// Derivatives of a limit surface, sampled on every patch, as rows of weights over control points.
//
// A patch is the part of the surface that belongs to a face of the control mesh. Its derivatives
// depend on the vertices of the faces that touch it, and their weights on nothing but how these
// faces are joined and how sharp they are: most patches of a mesh are of few kinds.
#pragma once

#include <surpass/topology.hpp>

#include <cstddef>
#include <span>
#include <vector>

#include "scheme/subdivision_scheme.hpp"

namespace surpass {

/// Neighbouring patches have the samples on a side between them in common.
enum class Sides {
  each,    ///< every patch has the rows of all its samples
  shared,  ///< one patch has those on a side for both, with twice their count and area, where the
           ///< surface is smooth and the side's numbers in the two faces differ: half the work
};

/// The derivatives of every patch of a control mesh.
class PatchRows {
 public:
  [[nodiscard]] std::size_t patch_count() const { return kind_of_.size(); }
  [[nodiscard]] const PatchKind& kind(std::size_t patch) const { return kinds_[kind_of_[patch]]; }
  [[nodiscard]] Index kind_number(std::size_t patch) const { return kind_of_[patch]; }
  [[nodiscard]] const std::vector<PatchKind>& kinds() const { return kinds_; }
  /// Where the columns of a patch start among those of all.
  [[nodiscard]] std::size_t columns_start(std::size_t patch) const { return offsets_[patch]; }
  [[nodiscard]] std::size_t column_count() const { return columns_.size(); }
  /// The control vertices that the kind's columns stand for.
  [[nodiscard]] std::span<const Index> columns(std::size_t patch) const {
    return std::span(columns_).subspan(offsets_[patch], offsets_[patch + 1] - offsets_[patch]);
  }

  /// A patch for every face with `sampled` != 0 (#F; empty: all), in order. `level` refinements
  /// lead from a face to its samples: 2^level + 1 along a side. Fails where Sharpness::build does,
  /// with `too_large` at valences of thousands, or when cancelled. O(#faces).
  static Result<PatchRows> build(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                 int level, std::span<const unsigned char> sampled,
                                 const Context& context, Sides sides = Sides::each);

 private:
  std::vector<Index> offsets_ = {0};
  std::vector<Index> columns_;
  std::vector<Index> kind_of_;
  std::vector<PatchKind> kinds_;
};

}  // namespace surpass

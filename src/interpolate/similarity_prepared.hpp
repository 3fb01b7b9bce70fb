// What similarity interpolation keeps of a topology, and the steps of a solve.
#pragma once

#include <surpass/similarity.hpp>

#include <memory>
#include <vector>

#include "interpolate/elimination.hpp"
#include "interpolate/free_system.hpp"
#include "interpolate/patch_energy.hpp"
#include "scheme/tiled_rows.hpp"

namespace surpass {

struct SimilarityPrepared {
  SimilarityOptions options;
  Mesh refined;                         ///< the given mesh after one step, annotated
  TiledRows stencil;                    ///< refined vertices over the given ones and the dummies
  std::vector<Index> dummies;           ///< #dummies: the given vertices where they start
  std::vector<Index> kept;              ///< #control: their rows of the stencil; empty: all
  std::vector<unsigned char> isolated;  ///< #given: no face, so not part of the surface
  Mesh given;                           ///< its faces, creases and corners, without points
  Elimination elimination;
  std::unique_ptr<const PatchLayout> layout;
  /// Of the vectors or the fair form; directions depend on the points as well, and use this for
  /// channels.
  std::unique_ptr<const PatchEnergy> scalar;

  [[nodiscard]] std::size_t given_count() const { return isolated.size(); }
  [[nodiscard]] std::size_t control_count() const { return elimination.control_count(); }
};

/// #control by width: the reference that the given numbers (#given by width) refine to.
[[nodiscard]] std::vector<double> refine_given(const SimilarityPrepared& prepared,
                                               std::size_t width, std::span<const double> given,
                                               const Context& context);

[[nodiscard]] Result<SimilarityPrepared> prepare_similarity(const Mesh& mesh,
                                                            const SimilarityOptions& options,
                                                            const Context& context);

/// Stretches a reference (#control by width) about the centre of its box, each column by its own
/// factor, as Scaling says; returns the factors. Boxes are those of the limits of the given
/// vertices that belong to the surface, and of the points (#given by width) that these shall be.
std::vector<double> scale_reference(const SimilarityPrepared& prepared, Scaling scaling,
                                    std::size_t width, std::span<const double> given,
                                    const Context& context, std::span<double> reference);

}  // namespace surpass

// What a non-stationary surface is refused for, and its parameters.
#pragma once

#include "scheme/nonstationary_state.hpp"

namespace surpass::nonstationary {

[[nodiscard]] Result<void> check_options(const NonstationaryOptions& options, Index vertices);

/// Faces, valences, creases and corners.
[[nodiscard]] Result<void> check_mesh(const Mesh& mesh, const Topology& topology,
                                      const Sharpness& sharpness,
                                      const NonstationaryOptions& options);

/// The shape moved into its range; a note if it was not there.
[[nodiscard]] double allowed_shape(const NonstationaryOptions& options, const Topology& topology,
                                   const Sharpness& sharpness, std::vector<std::string>& notes);

/// #V first parameters. `options` have their allowed shape.
[[nodiscard]] Result<std::vector<double>> first_parameters(const NonstationaryOptions& options,
                                                           const Topology& topology,
                                                           const Sharpness& sharpness);

}  // namespace surpass::nonstationary

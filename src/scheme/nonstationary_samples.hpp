// A non-stationary surface with its derivatives, as fairness measures it.
#pragma once

#include <surpass/nonstationary.hpp>

#include "scheme/limit_samples.hpp"

namespace surpass {

/// The surface after so many refinements: a patch a face, its samples at its vertices. Errors as
/// NonstationaryLoop.
[[nodiscard]] Result<LimitSamples> nonstationary_samples(const Mesh& control,
                                                         const NonstationaryOptions& options,
                                                         int levels, const Context& context);

}  // namespace surpass

// An order of the patches in which those that are near each other on the surface come together.
#pragma once

#include <cstddef>
#include <vector>

#include "scheme/patch_rows.hpp"

namespace surpass {

/// The patches of `rows` in groups that grow around a patch each, over its neighbours and theirs,
/// as far as these are still free, until they have as many `columns`. O(#faces).
[[nodiscard]] std::vector<Index> patches_by_neighbourhood(const Topology& topology,
                                                          const PatchRows& rows,
                                                          std::size_t columns);

}  // namespace surpass

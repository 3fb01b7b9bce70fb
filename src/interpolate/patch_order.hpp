// An order of the patches in which those that are near each other on the surface come together.
#pragma once

#include <surpass/topology.hpp>

#include <span>
#include <vector>

namespace surpass {

/// The patches (numbers of the sampled faces, #F; empty: all) in groups of `size` that grow around
/// a face each, over its neighbours and theirs, as far as these are still free. O(#faces).
[[nodiscard]] std::vector<Index> patches_by_neighbourhood(const Topology& topology,
                                                          std::span<const unsigned char> sampled,
                                                          std::size_t size);

}  // namespace surpass

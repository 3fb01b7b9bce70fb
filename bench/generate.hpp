// Irregular closed triangle meshes for measuring, the same on every machine.
#pragma once

#include <surpass/mesh.hpp>

#include <cstdint>

namespace surpass::bench {

/// How the vertices of a generated mesh are numbered.
enum class Order {
  natural,  ///< row by row, as generated
  mild,  ///< shuffled within runs of a few hundred, as in files that have been through some tools
};

/// A bumpy torus of rows x columns vertices (each at least 4) with valences 4 to 9: a jittered grid
/// whose edges were flipped at random. Coordinates are multiples of 1e-7, so that text with seven
/// decimals and binary doubles hold the same numbers.
[[nodiscard]] Mesh generate_torus(Index rows, Index columns, Order order, std::uint64_t seed = 1);

}  // namespace surpass::bench

// Irregular closed meshes for measuring, the same on every machine.
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

/// The same torus of quads with valences 3 to 6: in a quarter of the pairs of cells side by side
/// the edge between them was turned. `columns` is even. Order::mild.
[[nodiscard]] Mesh generate_quad_torus(Index rows, Index columns, std::uint64_t seed = 1);

}  // namespace surpass::bench

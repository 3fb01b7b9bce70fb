// What the advancing front leaves to be done: small pieces, holes, orientation.
#pragma once

#include <surpass/context.hpp>
#include <surpass/reconstruct.hpp>

#include <vector>

namespace surpass::reconstruction {

/// Removes the faces of pieces that have fewer than `share` of all faces, except of the largest
/// piece. Returns their number. Vertices stay.
std::size_t drop_small_pieces(Mesh& mesh, double share);

struct Holes {
  std::size_t filled = 0;
  std::size_t left = 0;
};

/// Fills boundary loops by triangles between their vertices. A triangle mesh that is manifold and
/// oriented stays so: a loop for which no triangles without repeated edges are found is left open.
/// Error: cancelled.
[[nodiscard]] Result<Holes> fill_holes(Mesh& mesh, Closing closing, const Context& context);

/// Turns pieces (joined along edges) so that their volume is positive. Open pieces follow their
/// points' normals where there are such (#V, else empty), else the volume between the piece and its
/// centre; flat ones look along the positive side of the axis nearest to their normal.
void orient_pieces(Mesh& mesh, std::span<const Point> normals);

}  // namespace surpass::reconstruction

// The steps of `repair`, in their order. Each changes the mesh only where something is wrong and
// adds a sentence for what it did.
#pragma once

#include <surpass/repair.hpp>

namespace surpass::repair_step {

/// Drops corners on the same vertex as the corner before, then faces with fewer than three
/// different vertices and faces that name a vertex which does not exist.
void drop_degenerate_faces(Mended& mended);

/// Drops repeats of a face, except one that lies back to back with it as a closed surface.
void drop_repeated_faces(Mended& mended);

/// Gives every further corner of a face on one vertex a copy of it: polygons with a bridge to a
/// hole become slit along the bridge.
void separate_repeated_corners(Mended& mended);

/// Turns faces so that the two at an edge agree. Of each piece the majority stays as it is; pieces
/// that have no consistent orientation keep edges at which faces disagree.
void orient_consistently(Mended& mended);

/// Copies vertices so that every edge has at most two faces and these agree.
void split_non_manifold(Mended& mended);

/// Turns closed pieces of negative volume inside out. The mesh must be manifold and oriented.
void turn_outward(Mended& mended);

}  // namespace surpass::repair_step

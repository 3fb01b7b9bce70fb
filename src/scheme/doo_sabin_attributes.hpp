// What a Doo-Sabin refined mesh inherits besides positions and vertex channels.
#pragma once

#include <surpass/mesh.hpp>

#include "scheme/doo_sabin_faces.hpp"
#include "scheme/doo_sabin_weights.hpp"

namespace surpass::doo_sabin {

/// Sharp edges and corners of the refined mesh, file annotations.
void inherit_creases(const Mesh& mesh, const Layout& layout, const NewMesh& fresh, Mesh& refined);

/// Face sets, holes and face channels. A new face is in a set, or a hole, if all faces that it came
/// from are; where their channel values differ, it has the first face's.
void inherit_face_attributes(const Mesh& mesh, const Topology& topology, const NewFaces& faces,
                             Mesh& refined);

/// Corner channels by the face rule. New faces across an edge or around a vertex have values where
/// the given ones are continuous there, and none on seams.
void refine_corner_channels(const Mesh& mesh, const Topology& topology, const WeightTable& table,
                            const NewFaces& faces, Mesh& refined);

/// Faces of `faces` all of whose corners came out of hole faces, ascending.
[[nodiscard]] std::vector<Index> inherited_holes(const Mesh& mesh, const Topology& topology,
                                                 const NewFaces& faces);

}  // namespace surpass::doo_sabin

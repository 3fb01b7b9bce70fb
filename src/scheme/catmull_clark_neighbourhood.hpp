// A face with the faces that touch it, cut out of a mesh, and its quarters likewise after each
// refinement: all that the surface over the face depends on.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "scheme/catmull_clark_masks.hpp"
#include "scheme/kept_rows.hpp"
#include "scheme/place_rows.hpp"

namespace surpass::catmull_clark {

/// A corner of a face in the ring of its vertex: the face is ring.faces[face], between the spokes
/// `face` and `face` + 1.
struct RingPlace {
  FaceRing ring;
  std::size_t face = 0;

  [[nodiscard]] std::size_t next_spoke() const { return (face + 1) % ring.size(); }
  /// No refinement will make the surface at this corner of this face a B-spline patch or change its
  /// masks; false while faces are no quads or sharpness fades.
  [[nodiscard]] bool stays_irregular() const { return is_settled(ring) && !is_regular(); }
  /// The corner is as in a B-spline patch, at sharp edges of one with mirrored points beyond.
  [[nodiscard]] bool is_regular() const;
};

class Neighbourhood {
 public:
  /// Of a face of a mesh; `vertices` receives the mesh's vertex of each point here.
  static Result<std::unique_ptr<Neighbourhood>> around(const Topology& topology,
                                                       const Sharpness& sharpness, Index face,
                                                       std::vector<Index>& vertices);

  /// The face itself is face 0 here, its corner k half-edge k.
  [[nodiscard]] const Topology& topology() const { return topology_; }
  [[nodiscard]] const Sharpness& sharpness() const { return sharpness_; }
  [[nodiscard]] Index point_count() const { return mesh_.vertex_count(); }
  [[nodiscard]] bool is_regular() const { return regular_; }
  [[nodiscard]] RingPlace corner(Index k) const;

  /// The quarter at corner k of the face: a quad from the corner's vertex over the point of the
  /// edge that leaves it and the face's point to that of the edge before.
  struct Quarter {
    const Neighbourhood* parent = nullptr;
    Neighbourhood* patch = nullptr;  ///< maybe the parent: then all further ones are the same
    std::vector<Index> vertices;     ///< the parent's refined vertex of each of its points
    std::unique_ptr<Neighbourhood> owned = {};

    /// Rows over its points become rows over the parent's.
    void lift(PlaceRows& rows) const;
  };
  Result<const Quarter*> quarter(Index k);

 private:
  struct Refined {
    KeptRows stencil;
    Topology topology;
    Sharpness sharpness;
  };

  static Result<std::unique_ptr<Neighbourhood>> create(Mesh mesh);
  [[nodiscard]] bool has_regular_corners() const;
  Result<void> refine();

  Mesh mesh_;  // its points are not set
  Topology topology_;
  Sharpness sharpness_;
  bool regular_ = false;
  std::optional<Refined> refined_;
  std::vector<Quarter> quarters_;
};

}  // namespace surpass::catmull_clark

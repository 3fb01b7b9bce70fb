// Refinement prepared for one topology: the frames of an animation, further channels.
#pragma once

#include <surpass/context.hpp>
#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace surpass {

struct RefinerOptions {
  Rules rules = {};
  int levels = 1;      ///< 0 or more
  bool limit = false;  ///< onto the limit surface, as `limit_mesh`; else as `refine`
};

/// Many point sets refined on one topology, one set-up.
///
///     const auto refiner = Refiner::create(control, {.levels = 2});
///     for (const auto& frame : frames) auto refined = refiner->refine(frame);
///
/// The results have the bits of `refine` and `limit_mesh`. The weights of every level are kept and
/// applied level by level: fewer operations than with weights over the control points, whose rows
/// are longer at every level. Memory: about 4 bytes for each entry of a row (4 to 7 a vertex) and 2
/// a vertex, on each level, besides the refined mesh.
///
/// Movable, immutable after creation; `refine` may be called from several threads.
class Refiner {
 public:
  /// Takes up to about twice as long as `refine` or `limit_mesh`: the weights are sorted.
  /// Fails where these do.
  [[nodiscard]] static Result<Refiner> create(const Mesh& control,
                                              const RefinerOptions& options = {},
                                              const Context& context = {});
  Refiner(const Refiner&) = delete;
  Refiner& operator=(const Refiner&) = delete;
  Refiner(Refiner&&) noexcept;
  Refiner& operator=(Refiner&&) noexcept;
  ~Refiner();

  /// The refined mesh of the given control mesh, as `refine` or `limit_mesh` gives it: the faces,
  /// and what else does not depend on where the control points are. Its points and channels (limit
  /// normals among them) are those of the given points.
  [[nodiscard]] const Mesh& mesh() const;

  /// Refined points, one for each vertex of mesh(), of these control points (#V). O(#V of mesh()).
  /// Error: wrong size.
  [[nodiscard]] Result<std::vector<Point>> refine(std::span<const Point> points,
                                                  const Context& context = {}) const;

  /// The same for any values, such as a channel's: #V by `width`, row after row, into memory of the
  /// caller's, #V of mesh() by `width`. Memory that has been used before is faster than new one.
  /// Errors: wrong sizes.
  Result<void> refine(std::size_t width, std::span<const double> values, std::span<double> refined,
                      const Context& context = {}) const;

  struct Impl;

 private:
  explicit Refiner(std::unique_ptr<const Impl> impl);
  std::unique_ptr<const Impl> impl_;
};

}  // namespace surpass

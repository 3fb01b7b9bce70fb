// What LimitSurface needs of a scheme.
#pragma once

#include <surpass/evaluate.hpp>

#include <memory>

namespace surpass {

/// Stencils on one face. Keeps what further places on it can use, so it is for one thread.
class FaceEvaluator {
 public:
  FaceEvaluator() = default;
  FaceEvaluator(const FaceEvaluator&) = delete;
  FaceEvaluator& operator=(const FaceEvaluator&) = delete;
  virtual ~FaceEvaluator() = default;

  /// The place has been checked, and lies on this face.
  virtual Result<SurfaceStencil> stencil(const SurfacePlace& place) = 0;
};

/// Refers to the mesh's topology, which must stay.
class SurfaceEvaluator {
 public:
  SurfaceEvaluator() = default;
  SurfaceEvaluator(const SurfaceEvaluator&) = delete;
  SurfaceEvaluator& operator=(const SurfaceEvaluator&) = delete;
  virtual ~SurfaceEvaluator() = default;

  [[nodiscard]] virtual Result<std::unique_ptr<FaceEvaluator>> on_face(Index face) const = 0;
};

}  // namespace surpass

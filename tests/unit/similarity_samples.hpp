// Meshes that the tests of similarity share.
#pragma once

#include <random>
#include <utility>

#include "support/polygons.hpp"

namespace surpass::test {

/// Every point moved at random by a little, the same each time.
inline Mesh jittered(Mesh mesh) {
  std::mt19937_64 random(8);
  return jitter(std::move(mesh), random, 0.15);
}

}  // namespace surpass::test

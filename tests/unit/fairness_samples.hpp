// A torus as a control mesh, and what is known of tori.
#pragma once

#include <cmath>

#include "support/polygons.hpp"

namespace surpass::test {

struct Torus {
  double R = 3;
  double r = 1;
  [[nodiscard]] double area() const { return 4 * M_PI * M_PI * R * r; }
  /// Willmore's energy, the integral of H^2, is pi^2 c^2 / sqrt(c^2 - 1) with c = R / r, and as the
  /// integral of K is 0, that of k1^2 + k2^2 is 4 times as much.
  [[nodiscard]] double bending() const {
    const double c = R / r;
    return 4 * M_PI * M_PI * c * c / std::sqrt(c * c - 1);
  }
  /// H = (R + 2 r cos p) / (2 r (R + r cos p)) falls from the outside to the inside.
  [[nodiscard]] double slope(double p) const {
    const double w = R + r * std::cos(p);
    return -std::sin(p) * R / (2 * w * w) / r;  // along an arc of length r dp
  }
  /// The integral of |slope|^power over the surface; periodic, so that the sum is nearly exact.
  [[nodiscard]] double variation(int power) const {
    constexpr int kSteps = 100000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double p = 2 * M_PI * (i + 0.5) / kSteps;
      sum += std::pow(std::abs(slope(p)), power) * r * (R + r * std::cos(p));
    }
    return sum / kSteps * 4 * M_PI * M_PI;
  }
  /// n vertices around the axis by m around the tube, on the torus.
  [[nodiscard]] Mesh mesh(Scheme scheme, Index n, Index m) const {
    Mesh mesh;
    for (Index j = 0; j < m; ++j) {
      for (Index i = 0; i < n; ++i) {
        const double t = 2 * M_PI * i / n;
        const double p = 2 * M_PI * j / m;
        const double w = R + r * std::cos(p);
        mesh.points.push_back({w * std::cos(t), w * std::sin(t), r * std::sin(p)});
      }
    }
    for (Index j = 0; j < m; ++j) {
      for (Index i = 0; i < n; ++i) {
        const Index a = j * n + i;
        const Index b = j * n + (i + 1) % n;
        const Index c = (j + 1) % m * n + (i + 1) % n;
        const Index d = (j + 1) % m * n + i;
        if (scheme == Scheme::loop) {
          mesh.add_face(std::vector<Index>{a, b, d});
          mesh.add_face(std::vector<Index>{b, c, d});
        } else {
          mesh.add_face(std::vector<Index>{a, b, c, d});
        }
      }
    }
    return mesh;
  }
};

}  // namespace surpass::test

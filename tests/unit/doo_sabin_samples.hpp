// What the tests of Doo-Sabin surfaces share: every sample under every choice of rules.
#pragma once

#include <array>

#include <gtest/gtest.h>

#include "scheme/doo_sabin_step.hpp"
#include "support/polygons.hpp"

namespace surpass::test {

inline std::vector<Rules> doo_sabin_rules() {
  std::vector<Rules> all;
  for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
    for (const Weights weights : {Weights::averaging, Weights::cosine}) {
      all.push_back({Scheme::doo_sabin, boundary, weights});
    }
  }
  return all;
}

inline doo_sabin::Level refined_level(const Mesh& mesh, const Rules& rules, int levels) {
  Steps steps;
  return doo_sabin::refined_level(mesh, rules, levels, {}, steps).value();
}

/// Calls law(mesh, rules) for every sample, with a trace that names it.
template <class Law>
void for_every_sample(Law&& law) {
  for (const Sample& sample : polygon_samples()) {
    for (const Rules& rules : doo_sabin_rules()) {
      SCOPED_TRACE(sample.name + ", " + name_of(rules.boundary) + ", " + name_of(rules.weights));
      law(sample, rules);
    }
  }
}

/// Levels until there are 100 000 face corners.
inline int affordable_levels(const Mesh& mesh, int most) {
  double corners = mesh.corner_count();
  int levels = 0;
  while (levels < most && corners < 30000) {
    corners *= 4;
    ++levels;
  }
  return levels;
}

/// The refined vertices that close in on a site.
inline std::vector<Point> points_at(const doo_sabin::Level& level, const doo_sabin::Site& site) {
  const Topology& t = *level.topology;
  std::vector<Point> points;
  const auto put = [&](Index v) { points.push_back(level.mesh.points[v]); };
  switch (site.kind) {
    case doo_sabin::Site::Kind::vertex: put(site.at); break;
    case doo_sabin::Site::Kind::face:
      for (Index h = t.face_begin(site.at); h < t.face_end(site.at); ++h) put(t.tail(h));
      break;
    case doo_sabin::Site::Kind::edge:
      put(t.tail(site.at));
      put(t.head(site.at));
      break;
  }
  return points;
}

inline Point mean(const std::vector<Point>& points) {
  Point sum = {};
  for (const Point& p : points) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += p[c] / static_cast<double>(points.size());
  }
  return sum;
}

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point unit(const Point& p) {
  const double length = std::sqrt(dot(p, p));
  return {p[0] / length, p[1] / length, p[2] / length};
}

/// Unit normal by Newell's formula.
inline Point face_normal(const Mesh& mesh, Index f) {
  Point n = {};
  const auto face = mesh.face(f);
  const Point& o = mesh.points[face[0]];
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Point& p = mesh.points[face[i]];
    const Point& q = mesh.points[face[(i + 1) % face.size()]];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t a = (c + 1) % 3;
      const std::size_t b = (c + 2) % 3;
      n[c] += (p[a] - o[a]) * (q[b] - o[b]) - (p[b] - o[b]) * (q[a] - o[a]);
    }
  }
  return unit(n);
}

}  // namespace surpass::test

#include "scheme/catmull_clark_masks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scheme/crease_masks.hpp"

namespace surpass::catmull_clark {
namespace {

void add_centroid(Mask& mask, const std::vector<std::size_t>& face, double weight) {
  for (const std::size_t i : face) mask[i] += weight / static_cast<double>(face.size());
}

Mask plain_mask(const FaceRing& ring, const PlainRow& row) {
  Mask mask(ring.point_count(), 0.0);
  mask[0] = row.center;
  for (std::size_t j = 0; j < ring.size(); ++j) mask[1 + j] = row.spoke;
  for (const auto& face : ring.faces) add_centroid(mask, face, row.face);
  for (double& w : mask) w /= row.sum;
  return mask;
}

// The new point on spoke j.
Mask spoke_mask(const FaceRing& ring, std::size_t j) {
  const std::size_t n = ring.size();
  const double crease = std::min(1.0, static_cast<double>(ring.spoke_sharpness[j]));
  const double end = crease / 2 + (1 - crease) / 4;
  Mask mask(ring.point_count(), 0.0);
  mask[0] = mask[1 + j] = end;
  if (crease < 1) {
    add_centroid(mask, ring.faces[j], (1 - crease) / 4);
    add_centroid(mask, ring.faces[(j + n - 1) % n], (1 - crease) / 4);
  }
  return mask;
}

// The exact limit at the end of a crease among quads, by invariance under refinement. OpenSubdiv
// uses the smooth mask there, to which its own refined points do not converge.
Mask dart_limit_mask(const FaceRing& ring) {
  const std::size_t n = ring.size();
  const auto count = static_cast<double>(n);
  const std::size_t end = ring.sharp_spokes().front();
  const double r = (7 - std::sqrt(45.0)) / 2;
  const auto power = [&](std::size_t j) { return std::pow(r, static_cast<double>(j)); };
  std::vector<double> spoke(n + 1, 0.0);  // counted from the crease, whose own stays 0 here
  for (std::size_t j = 1; j < n; ++j) {
    spoke[j] = 4 / (count * count) * (1 - (power(j) + power(n - j)) / (1 + power(n)));
  }
  Mask mask(ring.point_count(), 0.0);
  mask[0] = 1;
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t at = (end + j) % n;
    mask[1 + at] = j == 0 ? 10 / (3 * count * count) + spoke[1] / 3 : spoke[j];
    const std::size_t corner = ring.faces[at][2];
    mask[corner] += 1 / (3 * count * count) + (spoke[j] + spoke[j + 1]) / 12;
  }
  const double sum = std::accumulate(mask.begin(), mask.end(), 0.0);
  for (double& w : mask) w /= sum;
  return mask;
}

// The rules at the center stay as they are, or end in one that the limit masks know.
bool has_limit_mask(const FaceRing& ring) {
  if (is_infinite(ring.sharpness)) return true;
  if (ring.is_semi_sharp()) return false;
  return ring.rule() != VertexRule::dart || ring.all_quads();
}

Mask settled_limit_mask(const FaceRing& ring) {
  switch (ring.rule()) {
    case VertexRule::corner: return corner_mask(ring.point_count());
    case VertexRule::crease: return curve_mask(ring, ring.point_count(), 2.0 / 3);
    case VertexRule::dart: return dart_limit_mask(ring);
    default: return plain_mask(ring, limit_row(ring.size()));
  }
}

}  // namespace

PlainRow refined_row(std::size_t valence) {
  const auto n = static_cast<double>(valence);
  return {n * (n - 2), 1, 1, n * n};
}

PlainRow limit_row(std::size_t valence) {
  const auto n = static_cast<double>(valence);
  return {n * (n - 1), 2, 4, n * (n + 5)};
}

FaceRing FaceRing::around(const Topology& topology, const Sharpness& sharpness, Index v) {
  FaceRing ring;
  static_cast<Ring&>(ring) = Ring::around(topology, sharpness, v);
  ring.columns.reserve(1 + 2 * ring.size());  // where faces are quads
  ring.columns.push_back(v);
  ring.columns.insert(ring.columns.end(), ring.spokes.begin(), ring.spokes.end());
  ring.faces.reserve(topology.faces_at(v));
  topology.for_each_outgoing(v, [&](Index h) {
    const std::size_t j = ring.faces.size();
    std::vector<std::size_t>& face = ring.faces.emplace_back();
    face.reserve(topology.face_degree(topology.face(h)));
    face.push_back(0);
    face.push_back(1 + j);
    const Index last = topology.previous(h);
    for (Index k = topology.next(topology.next(h)); k != last; k = topology.next(k)) {
      face.push_back(ring.columns.size());
      ring.columns.push_back(topology.tail(k));
    }
    face.push_back(1 + (j + 1) % ring.size());
  });
  return ring;
}

std::size_t FaceRing::point_count() const {
  std::size_t count = 1 + size();
  for (const auto& face : faces) count += face.size() - 3;
  return count;
}

bool FaceRing::all_quads() const {
  return std::all_of(faces.begin(), faces.end(), [](const auto& f) { return f.size() == 4; });
}

FaceRing FaceRing::child() const {
  FaceRing ring;
  static_cast<Ring&>(ring) = Ring::child();
  const std::size_t n = size();
  for (std::size_t j = 0; j < faces.size(); ++j) {
    ring.faces.push_back({0, 1 + j, 1 + n + j, 1 + (j + 1) % n});
  }
  return ring;
}

std::vector<Mask> FaceRing::child_masks() const {
  std::vector<Mask> masks = {vertex_mask(*this)};
  for (std::size_t j = 0; j < size(); ++j) masks.push_back(spoke_mask(*this, j));
  for (const auto& face : faces) {
    add_centroid(masks.emplace_back(point_count(), 0.0), face, 1);
  }
  return masks;
}

Mask vertex_mask(const FaceRing& ring) {
  return refined_mask(ring, ring.point_count(),
                      [&] { return plain_mask(ring, refined_row(ring.size())); });
}

Mask limit_mask(const FaceRing& ring) {
  if (is_infinite(ring.sharpness)) return corner_mask(ring.point_count());
  if (has_limit_mask(ring)) return settled_limit_mask(ring);
  const auto settled = settle(ring, has_limit_mask);
  return compose(settled_limit_mask(settled.ring), settled.weights);
}

bool is_settled(const FaceRing& ring) { return !ring.is_semi_sharp() && ring.all_quads(); }

}  // namespace surpass::catmull_clark

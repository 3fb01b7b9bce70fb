// A structured torus grid, its edges flipped at random, its surface bent by waves and noise.
#include "generate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace surpass::bench {
namespace {

constexpr Index kFewestSpokes = 4;
constexpr Index kMostSpokes = 9;
constexpr double kFlipped = 0.08;  // share of the edges that are tried, in each of two passes
constexpr std::size_t kRun = 256;  // vertices or faces that Order::mild shuffles among themselves

// The engine is fixed by the standard, its distributions are not: these two are ours.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double centred() { return 2 * unit() - 1; }
  std::size_t below(std::size_t n) { return engine_() % n; }

 private:
  std::mt19937_64 engine_;
};

// Triangles as half-edges: 3f + k runs from corner k of face f to the next.
class FlippableGrid {
 public:
  FlippableGrid(Index rows, Index columns) : rows_(rows), columns_(columns) {
    const Index quads = rows * columns;
    tail_.resize(std::size_t{6} * quads);
    twin_.resize(tail_.size());
    valence_.assign(quads, 6);
    for (Index i = 0; i < rows; ++i) {
      for (Index j = 0; j < columns; ++j) add_quad(i, j);
    }
  }

  void flip_at_random(Random& random) {
    for (Index h = 0; h < tail_.size(); ++h) {
      if (h < twin_[h] && random.unit() < kFlipped && may_flip(h)) flip(h);
    }
  }

  [[nodiscard]] const std::vector<Index>& corners() const { return tail_; }

 private:
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] Index vertex(Index i, Index j) const { return i % rows_ * columns_ + j % columns_; }

  // Corners a, b, c and a, c, d of the quad, and who faces whom.
  void add_quad(Index i, Index j) {
    const Index h = 6 * vertex(i, j);
    const Index corners[] = {vertex(i, j), vertex(i, j + 1),     vertex(i + 1, j + 1),
                             vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)};
    std::copy(std::begin(corners), std::end(corners), tail_.begin() + h);
    link(h, 6 * vertex(i + rows_ - 1, j) + 4);
    link(h + 1, 6 * vertex(i, j + 1) + 5);
    link(h + 2, h + 3);
  }

  void link(Index g, Index h) {
    twin_[g] = h;
    twin_[h] = g;
  }

  [[nodiscard]] bool are_neighbours(Index h, Index v) const {  // h leaves the other vertex
    Index g = h;
    do {
      if (tail_[next(g)] == v) return true;
      g = twin_[previous(g)];
    } while (g != h);
    return false;
  }

  [[nodiscard]] bool may_flip(Index h) const {
    const Index t = twin_[h];
    const Index c = previous(h);
    const Index d = previous(t);
    return valence_[tail_[h]] > kFewestSpokes && valence_[tail_[t]] > kFewestSpokes &&
           valence_[tail_[c]] < kMostSpokes && valence_[tail_[d]] < kMostSpokes &&
           !are_neighbours(c, tail_[d]);
  }

  // The edge between a and b becomes the one between c and d, the tips of its two triangles.
  void flip(Index h) {
    const Index t = twin_[h];
    const Index p = previous(h);
    const Index q = previous(t);
    const Index beyond_p = twin_[p];
    const Index beyond_q = twin_[q];
    --valence_[tail_[h]];
    --valence_[tail_[t]];
    ++valence_[tail_[p]];
    ++valence_[tail_[q]];
    tail_[h] = tail_[q];
    tail_[t] = tail_[p];
    link(h, beyond_q);
    link(t, beyond_p);
    link(p, q);
  }

  Index rows_;
  Index columns_;
  std::vector<Index> tail_;
  std::vector<Index> twin_;
  std::vector<Index> valence_;
};

double rounded(double x) { return std::round(x * 1e7) / 1e7; }

// A torus with waves on it; position and radius are disturbed by a fraction of the grid's spacing.
Point surface_point(double row, double column, double spacing, Random& random) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double v = kTurn * (row + 0.3 * spacing * random.centred());
  const double u = kTurn * (column + 0.3 * spacing * random.centred());
  const double waves = 0.06 * std::sin(5 * u + 2 * v) + 0.03 * std::sin(9 * v - 4 * u);
  const double tube = 0.4 + waves + 0.3 * spacing * random.centred();
  const double ring = 1 + tube * std::cos(v);
  return {rounded(ring * std::cos(u)), rounded(ring * std::sin(u)), rounded(tube * std::sin(v))};
}

// new_place[i] of element i: a permutation within consecutive runs.
std::vector<Index> mild_shuffle(std::size_t n, Random& random) {
  std::vector<Index> place(n);
  std::iota(place.begin(), place.end(), Index{0});
  for (std::size_t begin = 0; begin < n; begin += kRun) {
    const std::size_t end = std::min(n, begin + kRun);
    for (std::size_t i = end - 1; i > begin; --i) {
      std::swap(place[i], place[begin + random.below(i - begin + 1)]);
    }
  }
  return place;
}

// All faces have the same number of corners.
void shuffle(Mesh& mesh, Random& random) {
  const std::size_t degree = mesh.face(0).size();
  const auto vertex_place = mild_shuffle(mesh.points.size(), random);
  const auto face_place = mild_shuffle(mesh.face_count(), random);
  const Mesh old = mesh;
  for (std::size_t v = 0; v < old.points.size(); ++v) mesh.points[vertex_place[v]] = old.points[v];
  for (std::size_t h = 0; h < old.face_vertices.size(); ++h) {
    mesh.face_vertices[degree * face_place[h / degree] + h % degree] =
        vertex_place[old.face_vertices[h]];
  }
}

void add_points(Mesh& mesh, Index rows, Index columns, Random& random) {
  const double spacing = 1.0 / std::max(rows, columns);
  mesh.points.reserve(std::size_t{rows} * columns);
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) {
      mesh.points.push_back(surface_point(double(i) / rows, double(j) / columns, spacing, random));
    }
  }
}

}  // namespace

Mesh generate_torus(Index rows, Index columns, Order order, std::uint64_t seed) {
  Random random(seed);
  FlippableGrid grid(rows, columns);
  grid.flip_at_random(random);
  grid.flip_at_random(random);

  Mesh mesh;
  add_points(mesh, rows, columns, random);
  mesh.face_vertices = grid.corners();
  mesh.face_offsets.resize(mesh.face_vertices.size() / 3 + 1);
  for (Index f = 0; f < mesh.face_offsets.size(); ++f) mesh.face_offsets[f] = 3 * f;
  if (order == Order::mild) shuffle(mesh, random);
  return mesh;
}

Mesh generate_quad_torus(Index rows, Index columns, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  add_points(mesh, rows, columns, random);
  const auto vertex = [&](Index i, Index j) { return i % rows * columns + j % columns; };
  std::vector<Index> valence(mesh.points.size(), 4);
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; j += 2) {
      // Around the two cells; the edge between them joins b and e, turned it joins a and d.
      const Index a = vertex(i, j);
      const Index b = vertex(i, j + 1);
      const Index c = vertex(i, j + 2);
      const Index d = vertex(i + 1, j + 2);
      const Index e = vertex(i + 1, j + 1);
      const Index f = vertex(i + 1, j);
      const bool turned = random.below(4) == 0 && std::min(valence[b], valence[e]) > 3 &&
                          std::max(valence[a], valence[d]) < 6;
      if (turned) {
        --valence[b], --valence[e], ++valence[a], ++valence[d];
        mesh.add_face(std::array{a, b, c, d});
        mesh.add_face(std::array{a, d, e, f});
      } else {
        mesh.add_face(std::array{a, b, e, f});
        mesh.add_face(std::array{b, c, d, e});
      }
    }
  }
  shuffle(mesh, random);
  return mesh;
}

}  // namespace surpass::bench

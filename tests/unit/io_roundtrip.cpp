// Whatever a format holds comes back bit for bit, for generated meshes with every kind of baggage.
#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "unit/io_support.hpp"

namespace surpass {
namespace {

// A mesh from a seed; rapidcheck chooses and shrinks seed and sizes.
class Maker {
 public:
  Maker(std::uint64_t seed, Index vertices, Index faces)
      : random_(seed), vertices_(vertices), faces_(faces) {}

  Mesh mesh(Index least_corners, Index most_corners) {
    Mesh mesh;
    for (Index v = 0; v < vertices_; ++v) mesh.points.push_back({number(), number(), number()});
    for (Index f = 0; f < faces_; ++f) {
      std::vector<Index> face(least_corners + below(most_corners - least_corners + 1));
      for (Index& v : face) v = below(vertices_);
      mesh.add_face(face);
    }
    return mesh;
  }
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_() % count); }
  bool coin() { return below(2) == 0; }
  /// Any finite double: random bits, or a short decimal.
  double number() {
    if (coin()) return static_cast<double>(below(2001)) / 100 - 10;
    const double value = std::bit_cast<double>(random_());
    return std::isfinite(value) ? value : -0.0;
  }
  std::vector<double> numbers(std::size_t count) {
    std::vector<double> values(count);
    for (double& value : values) value = number();
    return values;
  }
  std::vector<double> integers(std::size_t count, std::uint32_t below_this) {
    std::vector<double> values(count);
    for (double& value : values) value = below(below_this);
    return values;
  }
  float sharpness() { return static_cast<float>(below(1000) + 1) / 70; }

  void add_sharpness(Mesh& mesh) {
    for (int k = 0; k < 5; ++k) {
      mesh.creases.push_back({{below(vertices_), below(vertices_)}, sharpness()});
    }
    for (Index v = 0; v < vertices_; ++v) {
      if (below(4) == 0) mesh.corners.push_back({v, sharpness()});
    }
    for (Index f = 0; f < faces_; ++f) {
      if (below(4) == 0) mesh.hole_faces.push_back(f);
    }
  }
  std::vector<Index> rows(std::size_t corners, std::uint32_t count) {
    std::vector<Index> indices(corners);
    for (Index& row : indices) row = below(3) == 0 ? kNone : below(count);
    return indices;
  }
  // Every face in some of the sets, in the order in which an OBJ reader finds them.
  void add_face_sets(Mesh& mesh) {
    using Kind = FaceSet::Kind;
    for (const Kind kind : {Kind::group, Kind::object, Kind::material, Kind::smoothing}) {
      std::vector<FaceSet> sets(3);
      for (std::size_t s = 0; s < 3; ++s) sets[s] = {kind, std::to_string(s + 1), {}};
      for (Index f = 0; f < faces_; ++f) {
        const std::uint32_t choice = below(4);
        if (choice < 3) sets[choice].faces.push_back(f);
        if (kind == Kind::group && choice == 0) sets[1].faces.push_back(f);
      }
      std::erase_if(sets, [](const FaceSet& set) { return set.faces.empty(); });
      std::stable_sort(sets.begin(), sets.end(), [](const FaceSet& a, const FaceSet& b) {
        return a.faces.front() < b.faces.front();
      });
      mesh.face_sets.insert(mesh.face_sets.end(), sets.begin(), sets.end());
    }
  }

 private:
  std::mt19937_64 random_;
  Index vertices_;
  Index faces_;
};

Maker any_maker() {
  return {*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange<Index>(1, 40),
          *rc::gen::inRange<Index>(1, 40)};
}

// Equal in value and in the sign of zeros, which operator== does not tell apart.
std::vector<std::uint64_t> bits(std::span<const double> values) {
  std::vector<std::uint64_t> result;
  for (const double value : values) result.push_back(std::bit_cast<std::uint64_t>(value));
  return result;
}

void expect_survives(const Mesh& mesh, const WriteOptions& options) {
  const Mesh back = written_and_read(mesh, options);
  RC_ASSERT(back == mesh);
  RC_ASSERT(bits(flat(back.points)) == bits(flat(mesh.points)));
  for (std::size_t k = 0; k < mesh.channels.size(); ++k) {
    RC_ASSERT(bits(back.channels[k].values) == bits(mesh.channels[k].values));
  }
}

RC_GTEST_PROP(RoundTrip, Obj, ()) {
  Maker make = any_maker();
  Mesh mesh = make.mesh(1, 9);
  const std::size_t corners = mesh.face_vertices.size();
  if (make.coin()) {
    mesh.channels = {{"color", {"red", "green", "blue"}, make.numbers(3 * mesh.points.size())}};
  }
  if (make.coin()) {
    const std::size_t width = 1 + make.below(3);
    mesh.corner_channels.push_back(
        {"texture", width, make.numbers(7 * width), make.rows(corners, 7)});
  }
  if (make.coin()) {
    mesh.corner_channels.push_back({"normal", 3, make.numbers(12), make.rows(corners, 4)});
  }
  make.add_sharpness(mesh);
  make.add_face_sets(mesh);
  mesh.tags = {"t interpolateboundary 1/0/0 1", "t smoothtriangles 0/0/1 catmark"};
  mesh.material_libraries = {"some file.mtl"};
  mesh.annotate("scheme", "loop");
  expect_survives(mesh, {.format = Format::obj});
}

RC_GTEST_PROP(RoundTrip, Ply, ()) {
  Maker make = any_maker();
  Mesh mesh = make.mesh(1, 300);
  const std::size_t n = mesh.points.size();
  mesh.channels = {{"quality", {"quality"}, make.numbers(n)},
                   {"color", {"red", "green", "blue"}, make.integers(3 * n, 256), Storage::uint8},
                   {"label", {"label"}, make.integers(n, 4000000000U), Storage::uint32},
                   {"texture", {"u", "v"}, make.integers(2 * n, 50), Storage::float32},
                   {"normal", {"nx", "ny", "nz"}, make.numbers(3 * n)}};
  const std::size_t f = mesh.face_count();
  mesh.face_channels = {
      {"color", {"red", "green", "blue", "alpha"}, make.integers(4 * f, 256), Storage::uint8},
      {"weight", {"weight"}, make.numbers(f)}};
  CornerChannel texture = {"texture", 2, {}, {}};
  for (Index face = 0; face < f; ++face) {
    const bool without = make.coin();
    for (std::size_t k = 0; k < mesh.face(face).size(); ++k) {
      texture.indices.push_back(without ? kNone : static_cast<Index>(texture.values.size() / 2));
      if (!without) {
        texture.values.push_back(make.number());
        texture.values.push_back(make.number());
      }
    }
  }
  if (!texture.values.empty()) mesh.corner_channels = {texture};
  make.add_sharpness(mesh);
  mesh.annotate("boundary", "hoppe");
  for (const Encoding encoding : {Encoding::ascii, Encoding::little_endian, Encoding::big_endian}) {
    expect_survives(mesh, {.format = Format::ply, .encoding = encoding});
  }
}

RC_GTEST_PROP(RoundTrip, Off, ()) {
  Maker make = any_maker();
  Mesh mesh = make.mesh(1, 9);
  const std::size_t n = mesh.points.size();
  if (make.coin()) mesh.channels.push_back({"normal", {"nx", "ny", "nz"}, make.numbers(3 * n)});
  if (make.coin()) {
    mesh.channels.push_back({"color", {"red", "green", "blue", "alpha"}, make.numbers(4 * n)});
  } else if (make.coin()) {
    mesh.channels.push_back(
        {"color", {"red", "green", "blue"}, make.integers(3 * n, 256), Storage::uint8});
  }
  if (make.coin()) mesh.channels.push_back({"texture", {"s", "t"}, make.numbers(2 * n)});
  if (make.coin()) {
    mesh.face_channels = {{"color", {"red", "green", "blue"}, make.numbers(3 * mesh.face_count())}};
  }
  mesh.annotate("scheme", "loop");
  expect_survives(mesh, {.format = Format::off});
}

// STL knows no vertices: what survives is each triangle's positions, in floats.
RC_GTEST_PROP(RoundTrip, Stl, ()) {
  Maker make = any_maker();
  Mesh mesh = make.mesh(3, 3);
  for (Point& point : mesh.points) {
    for (double& x : point) x = double{static_cast<float>(std::remainder(x, 1e6))};
  }
  for (const Encoding encoding : {Encoding::ascii, Encoding::little_endian}) {
    const WriteOptions options = {.format = Format::stl, .encoding = encoding};
    const Mesh back = written_and_read(mesh, options);
    RC_ASSERT(back.face_offsets == mesh.face_offsets);
    for (std::size_t c = 0; c < mesh.face_vertices.size(); ++c) {
      RC_ASSERT(back.points[back.face_vertices[c]] == mesh.points[mesh.face_vertices[c]]);
    }
    expect_survives(back, options);  // and from then on everything
  }
}

}  // namespace
}  // namespace surpass

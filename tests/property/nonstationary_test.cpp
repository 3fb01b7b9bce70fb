// Laws of non-stationary Loop surfaces, for every mesh.
#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "generators.hpp"

namespace surpass {
namespace {

struct NonstationaryCase {
  Mesh mesh;
  NonstationaryOptions options;
};

NonstationaryCase any_nonstationary(bool with_corners) {
  NonstationaryCase made{test::any_mesh(false), {}};
  if (with_corners && *rc::gen::arbitrary<bool>()) {
    made.mesh.corners.push_back({*rc::gen::inRange<Index>(0, made.mesh.vertex_count())});
  }
  made.options.rule =
      *rc::gen::element(NonstationaryRule::interpolating, NonstationaryRule::interpolating,
                        NonstationaryRule::uniform, NonstationaryRule::quadratic);
  made.options.shape = *rc::gen::element(-3.9, -3.0, -1.5, 0.0, 1.0, 1.9);
  made.options.weights = *rc::gen::element(LoopWeights::warren, LoopWeights::classic);
  made.options.boundary = *rc::gen::element(Boundary::edge_only, Boundary::edge_and_corner);
  made.options.steps = *rc::gen::element(0, 1, 2, 3);
  return made;
}

Point moved(const Point& p) {
  return {0.3 * p[0] - 2 * p[1] + 0.1 * p[2] + 5, p[0] + p[1] - p[2] - 3, 0.7 * p[2] + 0.2 * p[0]};
}

NonstationaryLoop refined(const Mesh& mesh, const NonstationaryOptions& options, int levels,
                          const Context& context = {}) {
  auto surface = NonstationaryLoop::create(mesh, options, context);
  RC_ASSERT(surface.has_value());
  for (int level = 0; level < levels; ++level) RC_ASSERT(surface->refine(context).has_value());
  return std::move(*surface);
}

TEST(NonstationaryLaws, GivenVerticesAreMetByTheStepsOrByTheLimit) {
  test::check("met", 60, [] {
    const auto [mesh, options] = any_nonstationary(true);
    RC_PRE(options.rule != NonstationaryRule::uniform);
    const int levels = options.steps == 0 ? 2 : options.steps;
    const auto surface = refined(mesh, options, levels);
    auto found = options.steps == 0 ? surface.limit_positions().value() : surface.mesh().points;
    found.resize(mesh.points.size());
    RC_ASSERT(test::max_distance(found, mesh.points) <= 2e-14 * bounding_box(mesh.points).side());
  });
}

TEST(NonstationaryLaws, AffineMapsCommute) {
  test::check("affine", 40, [] {
    const auto [mesh, options] = any_nonstationary(true);
    Mesh other = mesh;
    for (Point& p : other.points) p = moved(p);
    const auto here = refined(mesh, options, 2);
    const auto there = refined(other, options, 2);
    auto points = here.mesh().points;
    for (Point& p : points) p = moved(p);
    auto limits = here.limit_positions().value();
    for (Point& p : limits) p = moved(p);
    const double close = 1e-12 * bounding_box(other.points).side();
    RC_ASSERT(test::max_distance(points, there.mesh().points) <= close);
    RC_ASSERT(test::max_distance(limits, there.limit_positions().value()) <= close);
  });
}

// Numbers of vertices and the order of faces and of their corners say nothing.
TEST(NonstationaryLaws, RenumberingCommutes) {
  test::check("renumber", 40, [] {
    const auto [mesh, options] = any_nonstationary(true);
    std::vector<Index> to(mesh.vertex_count());
    std::iota(to.begin(), to.end(), Index{0});
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::shuffle(to.begin(), to.end(), random);
    Mesh other;
    other.points.resize(mesh.points.size());
    for (Index v = 0; v < mesh.vertex_count(); ++v) other.points[to[v]] = mesh.points[v];
    for (const Corner& corner : mesh.corners) other.corners.push_back({to[corner.vertex]});
    for (Index f = mesh.face_count(); f-- > 0;) {
      const auto face = mesh.face(f);
      other.add_face(std::vector<Index>{to[face[1]], to[face[2]], to[face[0]]});
    }
    // Vertices of the first refinement by their parents.
    const auto here = refined(mesh, options, 1);
    const auto there = refined(other, options, 1);
    const auto topology = Topology::build(mesh).value();
    const auto turned = Topology::build(other).value();
    std::vector<Index> image(here.mesh().points.size());
    for (Index v = 0; v < mesh.vertex_count(); ++v) image[v] = to[v];
    for (Index e = 0; e < topology.edge_count(); ++e) {
      const auto [a, b] = topology.edge_vertices(e);
      image[mesh.vertex_count() + e] = other.vertex_count() + turned.find_edge(to[a], to[b]);
    }
    const auto compare = [&](const std::vector<Point>& a, const std::vector<Point>& b,
                             double close) {
      std::vector<Point> same(b.size());
      for (Index v = 0; v < b.size(); ++v) same[v] = b[image[v]];
      RC_ASSERT(test::max_distance(a, same) <= close);
    };
    const double close = 1e-13 * bounding_box(mesh.points).side();
    compare(here.mesh().points, there.mesh().points, close);
    compare(here.limit_positions().value(), there.limit_positions().value(), close);
    compare(here.limit_normals().value(), there.limit_normals().value(), 1e-7);
  });
}

TEST(NonstationaryLaws, ThreadsDoNotMatter) {
  test::check("threads", 10, [] {
    const auto [mesh, options] = any_nonstationary(true);
    const Context one{.threads = 1};
    const Context three{.threads = 3};
    const auto a = refined(mesh, options, 4, one);
    const auto b = refined(mesh, options, 4, three);
    RC_ASSERT(a.mesh() == b.mesh());
    RC_ASSERT(a.limit_mesh(one).value() == b.limit_mesh(three).value());
  });
}

}  // namespace
}  // namespace surpass

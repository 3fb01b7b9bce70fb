// Similarity interpolation against the same problem posed anew and solved densely: least squares
// over the sampled derivatives under equations for the given vertices, by Lagrange's multipliers.
#include <surpass/similarity.hpp>

#include <numeric>
#include <set>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "scheme/doo_sabin_sites.hpp"
#include "scheme/limit_operator.hpp"
#include "scheme/patch_rows.hpp"
#include "similarity_samples.hpp"

namespace surpass {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Matrix matrix_of(const std::vector<Point>& points) {
  Matrix m(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = points[i][k];
    }
  }
  return m;
}

// Every row of every patch over all control points.
struct Rows {
  Matrix rows;
  std::vector<Derivative> derivative;
  std::vector<double> count;
  std::vector<double> area;
};

// Of the faces that are not holes; each patch by itself, where the method shares what it can.
Rows all_rows(const Mesh& refined, const Rules& rules) {
  const auto topology = Topology::build(refined).value();
  std::vector<unsigned char> sampled(refined.face_count(), 1);
  for (const Index f : refined.hole_faces) sampled[f] = 0;
  const auto patches = PatchRows::build(refined, topology, rules, 1, sampled, {}).value();
  Rows all;
  std::vector<Vector> rows;
  for (std::size_t p = 0; p < patches.patch_count(); ++p) {
    const PatchKind& kind = patches.kind(p);
    for (std::size_t r = 0; r < kind.row_count(); ++r) {
      Vector& row = rows.emplace_back(Vector::Zero(refined.vertex_count()));
      for (std::size_t c = 0; c < kind.columns; ++c) row[patches.columns(p)[c]] += kind.row(r)[c];
      all.derivative.push_back(kind.derivative[r]);
      all.count.push_back(kind.count[r]);
      all.area.push_back(kind.area[r]);
    }
  }
  all.rows.resize(static_cast<Eigen::Index>(rows.size()), refined.vertex_count());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    all.rows.row(static_cast<Eigen::Index>(r)) = rows[r].transpose();
  }
  return all;
}

// Of the faces that the given vertices turned into, or what they have in their place.
Matrix limits_at_sites(const Mesh& mesh, const Mesh& refined, const Rules& rules) {
  const auto level = doo_sabin::refined_level(mesh, rules, 1, {}).value();
  Matrix m = Matrix::Zero(mesh.vertex_count(), refined.vertex_count());
  for (Index i = 0; i < mesh.vertex_count(); ++i) {
    doo_sabin::add_site_limit(level.layout, rules.weights, level.sites[i],
                              [&](Index j, double w) { m(i, j) += w; });
  }
  return m;
}

Matrix limits_of(const Mesh& mesh, const Mesh& refined, const Rules& rules) {
  if (rules.scheme == Scheme::doo_sabin) return limits_at_sites(mesh, refined, rules);
  const Index given = mesh.vertex_count();
  const auto topology = Topology::build(refined).value();
  const auto op = limit_operator(refined, topology, rules, {}).value();
  Matrix m = Matrix::Zero(given, refined.vertex_count());
  for (Index i = 0; i < given; ++i) {
    for (Index k = 0; k < op.rows.row_length(i); ++k) {
      m(i, op.rows.row_columns(i)[k]) += op.rows.row_weights(i)[k];
    }
  }
  return m;
}

// The weight of a row in the problem, without its count.
double row_weight(const SimilarityOptions& options, const Rows& all, const Matrix& g,
                  std::size_t r) {
  std::array<double, 3> squares = {};
  std::array<double, 3> counts = {};
  const auto order = [&](std::size_t i) {
    return all.derivative[i] == Derivative::first   ? 0U
           : all.derivative[i] == Derivative::third ? 2U
                                                    : 1U;
  };
  for (std::size_t i = 0; i < all.count.size(); ++i) {
    if (all.derivative[i] == Derivative::mixed) continue;
    squares[order(i)] += all.count[i] * g.row(static_cast<Eigen::Index>(i)).squaredNorm();
    counts[order(i)] += all.count[i];
  }
  const double square = g.row(static_cast<Eigen::Index>(r)).squaredNorm();
  switch (options.row_weights) {
    case RowWeights::none: return 1;
    // What is left of a derivative that vanishes is rounding.
    case RowWeights::unit: return square > 1e-24 * squares[0] / counts[0] ? 1 / square : 0;
    case RowWeights::order: return counts[order(r)] / squares[order(r)];
    case RowWeights::regularised: return 1 / (square + 0.09 * squares[0] / counts[0]);
  }
  return 0;
}

// Minimises sum |block_r (row_r Q - target_r)|^2 under limits Q = given, all coordinates at once.
Matrix dense_solution(const SimilarityOptions& options, const Rows& all, const Matrix& limits,
                      const Matrix& reference, const Matrix& given) {
  const Eigen::Index m = reference.rows();
  const Eigen::Index n = limits.rows();
  const Matrix g = all.rows * reference;
  Matrix system = Matrix::Zero(3 * (m + n), 3 * (m + n));
  Vector right = Vector::Zero(3 * (m + n));
  for (std::size_t k = 0; k < all.count.size(); ++k) {
    const auto r = static_cast<Eigen::Index>(k);
    Eigen::Matrix3d block = Eigen::Matrix3d::Identity();
    Eigen::Vector3d target = g.row(r).transpose();
    if (options.similarity == Similarity::fair) {
      const double weight = all.derivative[k] == Derivative::first    ? options.membrane
                            : all.derivative[k] == Derivative::second ? options.thin_plate
                            : all.derivative[k] == Derivative::mixed  ? 2 * options.thin_plate
                                                                      : 0;
      block *= weight * all.area[k];
      target.setZero();
    } else if (all.derivative[k] == Derivative::mixed) {
      continue;
    } else if (options.similarity == Similarity::directions) {
      Eigen::Matrix3d cross;
      cross << 0, -target[2], target[1], target[2], 0, -target[0], -target[1], target[0], 0;
      block = all.count[k] * row_weight(options, all, g, k) * cross.transpose() * cross;
    } else {
      block *= all.count[k];
    }
    std::vector<Eigen::Index> used;
    for (Eigen::Index j = 0; j < m; ++j) {
      if (all.rows(r, j) != 0) used.push_back(j);
    }
    for (const Eigen::Index i : used) {
      right.segment<3>(3 * i) += all.rows(r, i) * (block * target);
      for (const Eigen::Index j : used) {
        system.block<3, 3>(3 * i, 3 * j) += all.rows(r, i) * all.rows(r, j) * block;
      }
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < m; ++j) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        system(3 * (m + i) + k, 3 * j + k) = system(3 * j + k, 3 * (m + i) + k) = limits(i, j);
      }
    }
    right.segment<3>(3 * (m + i)) = given.row(i).transpose();
  }
  const Vector solution = system.fullPivLu().solve(right);
  Matrix q(m, 3);
  for (Eigen::Index j = 0; j < m; ++j) q.row(j) = solution.segment<3>(3 * j).transpose();
  return q;
}

void expect_dense_solution(const Mesh& mesh, SimilarityOptions options, double tolerance) {
  SCOPED_TRACE(std::string(name_of(options.similarity)) + ", " + name_of(options.row_weights) +
               ", " + name_of(options.rules.boundary));
  options.scaling = Scaling::none;  // the reference is then plain refinement
  options.solver_tolerance = 1e-14;
  options.max_iterations = 20000;
  const auto found = interpolate_similar(mesh, options);
  ASSERT_TRUE(found) << describe(found.error());
  const Mesh refined = refine(mesh, options.rules, 1).value();
  const Matrix expected = dense_solution(options, all_rows(refined, options.rules),
                                         limits_of(mesh, refined, options.rules),
                                         matrix_of(refined.points), matrix_of(mesh.points));
  EXPECT_LT((matrix_of(found->control.points) - expected).cwiseAbs().maxCoeff(), tolerance);
}

// In the forms that see each coordinate alone.
void expect_dense_vectors_and_fair(const Mesh& mesh, SimilarityOptions options) {
  expect_dense_solution(mesh, options, 1e-11);
  options.similarity = Similarity::fair;
  options.membrane = 0.3;
  expect_dense_solution(mesh, options, 1e-11);
}

// Loop surfaces on the same machinery, at extraordinary vertices and boundaries.
TEST(Similarity, OnLoopSurfacesIsTheDenseSolution) {
  std::mt19937_64 random(8);
  for (const Mesh& mesh : {test::octahedron(), test::bipyramid(7), test::triangle_grid(4, 3)}) {
    for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
      SimilarityOptions options;
      options.rules = {Scheme::loop, boundary};
      const Mesh given = test::jitter(mesh, random, 0.15);
      expect_dense_vectors_and_fair(given, options);
      options.similarity = Similarity::directions;
      expect_dense_solution(given, options, 1e-8);
    }
  }
}

// Doo-Sabin surfaces, whose patches belong to vertices: extraordinary faces, boundaries, creases
// and darts.
TEST(Similarity, OnDooSabinSurfacesIsTheDenseSolution) {
  std::mt19937_64 random(9);
  Mesh creased = test::quad_grid(4, 4);
  creased.creases = {{{4, 5}}, {{5, 6}}, {{6, 7}}, {{9, 13}}};
  // Two doublets beside each other, whose limits share all of their control points.
  Mesh doublets = test::prism(5);
  doublets = test::split_edge(doublets, 0, 1, {1.1, 0.4, -1});
  doublets = test::split_edge(doublets, 0, 10, {1.2, 0.2, -1});
  for (const Mesh& mesh : {test::cube(), test::prism(5), creased, doublets}) {
    for (const Weights weights : {Weights::averaging, Weights::cosine}) {
      SimilarityOptions options;
      options.rules = {Scheme::doo_sabin, Boundary::edge_and_corner, weights};
      const Mesh given = test::jitter(mesh, random, 0.15);
      expect_dense_vectors_and_fair(given, options);
      options.similarity = Similarity::directions;
      options.rules.boundary = Boundary::edge_only;
      expect_dense_solution(given, options, 1e-7);
    }
  }
}

Mesh creased_grid() {
  std::mt19937_64 random(3);
  Mesh mesh = test::jitter(test::quad_grid(4, 4), random, 0.1);
  mesh.creases = {{{4, 5}}, {{5, 6}}, {{6, 7}, 1.5F}, {{9, 13}, 2.5F}};
  mesh.corners = {{10, 1.2F}};
  return mesh;
}

TEST(Similarity, IsTheDenseSolution) {
  for (const Mesh& mesh :
       {test::jittered(test::cube()), test::jittered(test::prism(5)), creased_grid()}) {
    for (const Boundary boundary : {Boundary::edge_only, Boundary::edge_and_corner}) {
      SimilarityOptions options;
      options.rules.boundary = boundary;
      expect_dense_vectors_and_fair(mesh, options);
      options.similarity = Similarity::directions;
      for (const RowWeights weights :
           {RowWeights::none, RowWeights::unit, RowWeights::order, RowWeights::regularised}) {
        options.row_weights = weights;
        expect_dense_solution(mesh, options, 1e-8);  // the condition is up to 1e5 on open meshes
      }
    }
  }
}

// The given mesh inside a ring of quads whose outer vertices start at the boundary's; refined, and
// of it what the method is to keep: faces of the surface, then the inner half of each quad.
Mesh refined_in_dummy_ring(const Mesh& given, const Rules& rules) {
  Mesh extended = given;
  const auto topology = Topology::build(given).value();
  for (const auto& loop : boundary_loops(topology)) {
    const Index first = extended.vertex_count();
    const auto n = static_cast<Index>(loop.size());
    for (const Index h : loop) extended.points.push_back(given.points[topology.tail(h)]);
    for (Index k = 0; k < n; ++k) {
      extended.add_face(std::array{topology.head(loop[k]), topology.tail(loop[k]), first + k,
                                   first + (k + 1) % n});
    }
  }
  const Mesh fine = refine(extended, rules, 1).value();
  Mesh kept;
  std::vector<Index> number(fine.vertex_count(), kNone);
  const auto for_kept = [&](auto&& use) {
    for (Index f = 0; f < fine.face_count(); ++f) {
      if (f < given.corner_count() || (f - given.corner_count()) % 4 < 2) use(f);
    }
  };
  for_kept([&](Index f) {
    for (const Index v : fine.face(f)) number[v] = 0;
  });
  for (Index v = 0; v < fine.vertex_count(); ++v) {
    if (number[v] == kNone) continue;
    number[v] = kept.vertex_count();
    kept.points.push_back(fine.points[v]);
  }
  for_kept([&](Index f) {
    std::vector<Index> face;
    for (const Index v : fine.face(f)) face.push_back(number[v]);
    if (f >= given.corner_count()) kept.hole_faces.push_back(kept.face_count());
    kept.add_face(face);
  });
  return kept;
}

TEST(Similarity, InsideADummyRingIsTheDenseSolution) {
  for (const Mesh& mesh :
       {test::jittered(test::quad_grid(4, 3)), test::jittered(test::triangle_grid(3, 3))}) {
    for (const Similarity similarity :
         {Similarity::vectors, Similarity::directions, Similarity::fair}) {
      SCOPED_TRACE(name_of(similarity));
      SimilarityOptions options;
      options.open = OpenMeshes::dummy_ring;
      options.similarity = similarity;
      options.membrane = 0.3;
      options.scaling = Scaling::none;
      options.solver_tolerance = 1e-14;
      options.max_iterations = 20000;
      const auto found = interpolate_similar(mesh, options);
      ASSERT_TRUE(found) << describe(found.error());
      const Mesh refined = refined_in_dummy_ring(mesh, options.rules);
      EXPECT_EQ(found->control.face_vertices, refined.face_vertices);
      EXPECT_EQ(found->control.hole_faces, refined.hole_faces);
      const Matrix expected = dense_solution(options, all_rows(refined, options.rules),
                                             limits_of(mesh, refined, options.rules),
                                             matrix_of(refined.points), matrix_of(mesh.points));
      const double tolerance = similarity == Similarity::directions ? 1e-7 : 1e-10;
      EXPECT_LT((matrix_of(found->control.points) - expected).cwiseAbs().maxCoeff(), tolerance);
    }
  }
}

// A written surface is compared with the given vertices by their numbers: also one without faces,
// and those of the given mesh's own holes.
TEST(Similarity, ADrawnSurfaceBeginsWithTheGivenVertices) {
  Mesh mesh = test::jittered(test::quad_grid(5, 4));
  mesh.hole_faces = {0, 11};  // at opposite corners
  mesh.points.push_back({9, 9, 9});
  for (const OpenMeshes open : {OpenMeshes::boundary_rules, OpenMeshes::dummy_ring}) {
    SimilarityOptions options;
    options.open = open;
    const Mesh control = interpolate_similar(mesh, options)->control;
    for (const int levels : {0, 1, 2}) {
      const Mesh drawn = limit_mesh(control, options.rules, levels).value();
      ASSERT_GE(drawn.points.size(), mesh.points.size());
      const std::vector<Point> first(drawn.points.begin(),
                                     drawn.points.begin() + std::ssize(mesh.points));
      EXPECT_LT(test::max_distance(first, mesh.points), 1e-13);
      const std::set<Index> used(drawn.face_vertices.begin(), drawn.face_vertices.end());
      EXPECT_EQ(drawn.vertex_count() - used.size(), 3U) << name_of(open);
    }
  }
}

// Nothing of the surface depends on the rule at the outer boundary, and closed meshes have no ring.
TEST(Similarity, TheDummyRingReplacesBoundaryRules) {
  Mesh mesh = test::jittered(test::quad_grid(5, 4));
  mesh.creases = {{{7, 12}, 2.5F}, {{2, 7}}};  // one of them ends at the boundary
  SimilarityOptions options;
  options.open = OpenMeshes::dummy_ring;
  options.rules.boundary = Boundary::edge_only;
  const auto one = interpolate_similar(mesh, options).value();
  options.rules.boundary = Boundary::edge_and_corner;
  const auto other = interpolate_similar(mesh, options).value();
  EXPECT_EQ(one.control.points, other.control.points);
  EXPECT_EQ(one.report.solve.final.max, other.report.solve.final.max);
  EXPECT_LT(one.report.solve.final.max, 1e-14);
  const Mesh drawn = limit_mesh(one.control, options.rules, 1).value();
  EXPECT_EQ(drawn.face_count(), 4 * 4 * 12) << "the surface alone";
  std::set<Index> used(drawn.face_vertices.begin(), drawn.face_vertices.end());
  EXPECT_EQ(used.size(), drawn.vertex_count()) << "and no dummies";
  const Mesh closed = test::jittered(test::prism(5));
  const auto with = interpolate_similar(closed, options).value();
  options.open = OpenMeshes::boundary_rules;
  EXPECT_EQ(with.control.points, interpolate_similar(closed, options).value().control.points);
  options.open = OpenMeshes::dummy_ring;
  options.rules = {Scheme::loop};
  const auto loop = SimilarityInterpolator::create(test::triangle_grid(3, 3), options);
  ASSERT_FALSE(loop);
  EXPECT_EQ(loop.error().code, ErrorCode::invalid_argument);
}

TEST(Similarity, ThinPlateAloneIsTheDenseSolution) {
  SimilarityOptions options;
  options.similarity = Similarity::fair;
  expect_dense_solution(test::jittered(test::prism(6)), options, 1e-11);
}

// Rules of Hoppe et al. at the boundary: what they make of curves is left out.
TEST(Similarity, OnOpenLoopSurfacesUnderHoppeIsTheDenseSolution) {
  SimilarityOptions options;
  options.rules = {Scheme::loop, Boundary::hoppe};
  expect_dense_solution(test::jittered(test::triangle_grid(4, 4)), options, 1e-10);
}

}  // namespace
}  // namespace surpass

// Derivatives of Doo-Sabin surfaces and similarity interpolation with them: against the biquadratic
// B-spline, the scheme's own refinement, and the laws of interpolation.
#include <algorithm>
#include <functional>

#include "doo_sabin_samples.hpp"
#include "scheme/patch_rows.hpp"
#include "support/vectors.hpp"

namespace surpass::test {
namespace {

struct Derivatives {
  Values first;
  Values second;
  Values mixed;
};

Derivatives by_rows(const PatchRows& rows, std::size_t patch, const Values& control) {
  Derivatives found;
  const PatchKind& kind = rows.kind(patch);
  for (std::size_t r = 0; r < kind.row_count(); ++r) {
    Point value = {};
    for (std::size_t c = 0; c < kind.columns; ++c) {
      value = weighted_sum(1, value, kind.row(r)[c], control[rows.columns(patch)[c]]);
    }
    switch (kind.derivative[r]) {
      case Derivative::first: found.first.push_back(value); break;
      case Derivative::second: found.second.push_back(value); break;
      case Derivative::mixed: found.mixed.push_back(value); break;
      case Derivative::third: ADD_FAILURE() << "there are none"; break;
    }
  }
  return found;
}

PatchRows rows_of(const Mesh& mesh, const Rules& rules, int level = 1, Sides sides = Sides::each) {
  const auto topology = Topology::build(mesh).value();
  return PatchRows::build(mesh, topology, rules, level, {}, {}, sides).value();
}

// The quadratic B-splines of three control points on the middle one's span, 0 <= t <= 1.
using Weights3 = std::array<double, 3>;
Weights3 value_at(double t) {
  return {(1 - t) * (1 - t) / 2, (1 + 2 * t - 2 * t * t) / 2, t * t / 2};
}
Weights3 slope_at(double t) { return {t - 1, 1 - 2 * t, t}; }
constexpr Weights3 kBend = {1, -2, 1};

// The nine points around a vertex of four quads, row after row.
std::array<Point, 9> net_around(const Mesh& mesh, const Topology& t, Index v) {
  std::array<Point, 9> net;
  net[4] = mesh.points[v];
  constexpr std::size_t kSpoke[] = {5, 7, 3, 1};
  constexpr std::size_t kAcross[] = {8, 6, 0, 2};
  std::size_t k = 0;
  t.for_each_outgoing(v, [&](Index h) {
    net[kSpoke[k]] = mesh.points[t.head(h)];
    net[kAcross[k++]] = mesh.points[t.head(t.next(h))];
  });
  return net;
}

Point combined(const std::array<Point, 9>& net, const Weights3& u, const Weights3& v) {
  Point p = {};
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) p = weighted_sum(1, p, u[i] * v[j], net[3 * j + i]);
  }
  return p;
}

// At n + 1 by n + 1 parameters.
Derivatives by_splines(const std::array<Point, 9>& net, int n) {
  Derivatives found;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double u = static_cast<double>(i) / n;
      const double v = static_cast<double>(j) / n;
      found.first.push_back(combined(net, slope_at(u), value_at(v)));
      found.first.push_back(combined(net, value_at(u), slope_at(v)));
      found.second.push_back(combined(net, kBend, value_at(v)));
      found.second.push_back(combined(net, value_at(u), kBend));
      found.mixed.push_back(combined(net, slope_at(u), slope_at(v)));
    }
  }
  return found;
}

bool among_quads(const Topology& t, Index v) {
  if (t.is_boundary(v) || t.faces_at(v) != 4) return false;
  bool quads = true;
  t.for_each_outgoing(v, [&](Index h) { quads = quads && t.face_degree(t.face(h)) == 4; });
  return quads;
}

Mesh control_of(const Mesh& given, const Rules& rules, unsigned seed) {
  std::mt19937_64 random(seed);
  return jitter(refine(given, rules, 1).value(), random, 0.1);
}

TEST(DooSabinDerivativeRows, AmongQuadsAreThoseOfTheBiquadraticSpline) {
  const Rules rules = {Scheme::doo_sabin};
  for (const int level : {1, 2}) {
    for (const Mesh& given : {cube(), quad_grid(5, 4)}) {
      const Mesh control = control_of(given, rules, 4);
      const auto topology = Topology::build(control).value();
      const PatchRows rows = rows_of(control, rules, level);
      const int n = 1 << level;
      int compared = 0;
      for (std::size_t p = 0; p < rows.patch_count(); ++p) {
        const Index v = rows.vertices()[p];
        if (!among_quads(topology, v)) continue;
        ++compared;
        const Derivatives ours = by_rows(rows, p, control.points);
        const Derivatives theirs = by_splines(net_around(control, topology, v), n);
        EXPECT_EQ(ours.first.size(), theirs.first.size());
        EXPECT_EQ(ours.mixed.size(), theirs.mixed.size());
        // Constant along their axis: one row for each line.
        EXPECT_EQ(ours.second.size(), 2U * (static_cast<unsigned>(n) + 1));
        for (const auto list : {&Derivatives::first, &Derivatives::second, &Derivatives::mixed}) {
          EXPECT_LT(unlike(ours.*list, theirs.*list), 1e-13);
          EXPECT_LT(unlike(theirs.*list, ours.*list), 1e-13);
        }
        const PatchKind& kind = rows.kind(p);
        double samples = 0;
        double area = 0;
        for (std::size_t r = 0; r < kind.row_count(); ++r) {
          if (kind.derivative[r] != Derivative::second) continue;
          samples += kind.count[r];
          area += kind.area[r];
        }
        EXPECT_NEAR(samples, 2.0 * (n + 1) * (n + 1), 1e-12);
        EXPECT_NEAR(area, 2, 1e-12) << "the whole patch, for either axis";
      }
      EXPECT_GE(compared, given.face_count() == 6 ? 0 : 12);
    }
  }
}

// Beside faces of three and five sides what is known is what the refined surface has there.
TEST(DooSabinDerivativeRows, BesideOtherFacesAreThoseOfTheRefinedMesh) {
  for (const Weights weights : {Weights::averaging, Weights::cosine}) {
    const Rules rules = {Scheme::doo_sabin, Boundary::edge_and_corner, weights};
    for (const Mesh& given : {cube(), prism(5), prism(7)}) {
      const Mesh control = control_of(given, rules, 5);
      const Mesh fine = refine(control, rules, 1).value();
      const auto topology = Topology::build(control).value();
      const auto fine_topology = Topology::build(fine).value();
      const PatchRows rows = rows_of(control, rules);
      ASSERT_EQ(rows.patch_count(), control.points.size());
      for (std::size_t p = 0; p < rows.patch_count(); ++p) {
        Derivatives theirs;  // on the quarters of the patch, whose parameters run twice as fast
        topology.for_each_outgoing(rows.vertices()[p], [&](Index h) {
          if (!among_quads(fine_topology, h)) return;
          const auto quarter = by_splines(net_around(fine, fine_topology, h), 1);
          for (const Point& d : quarter.first) theirs.first.push_back(weighted_sum(2, d, 0, d));
          for (const Point& d : quarter.second) theirs.second.push_back(weighted_sum(4, d, 0, d));
          for (const Point& d : quarter.mixed) theirs.mixed.push_back(weighted_sum(4, d, 0, d));
        });
        const Derivatives ours = by_rows(rows, p, control.points);
        EXPECT_EQ(ours.first.size(), 18U);
        EXPECT_GT(ours.second.size(), 5U);
        EXPECT_LT(unlike(theirs.first, ours.first), 1e-13);
        EXPECT_LT(unlike(ours.second, theirs.second), 1e-13);
        EXPECT_LT(unlike(ours.mixed, theirs.mixed), 1e-13);
      }
    }
  }
}

// In the middle of a face that is no quad the tangents are left eigenvectors of the face rule.
TEST(DooSabinDerivativeRows, TangentsInOtherFacesAreEigenvectors) {
  for (const Weights weights : {Weights::averaging, Weights::cosine}) {
    for (const Index n : {3U, 5U, 6U, 9U, 20U}) {
      const Rules rules = {Scheme::doo_sabin, Boundary::edge_and_corner, weights};
      const Mesh control = control_of(prism(n), rules, n);
      const Mesh fine = refine(control, rules, 1).value();
      const auto tangents = [&](const Mesh& mesh, Index face) {
        const PatchRows rows = rows_of(mesh, rules);
        Values found;
        for (std::size_t p = 0; p < rows.patch_count(); ++p) {
          const auto corners = mesh.face(face);
          if (std::find(corners.begin(), corners.end(), rows.vertices()[p]) == corners.end()) {
            continue;
          }
          const Values all = by_rows(rows, p, mesh.points).first;
          found.insert(found.end(), all.begin(), all.end());
        }
        return found;
      };
      const Index face = n;  // the bottom, behind the sides; it keeps its number
      ASSERT_EQ(control.face(face).size(), n);
      const double eigenvalue =
          weights == Weights::cosine ? 0.5 : 0.5 + std::cos(2 * std::acos(-1.0) / n) / 4;
      const Values coarse = tangents(control, face);
      int matched = 0;
      for (const Point& t : tangents(fine, face)) {
        double best = HUGE_VAL;
        for (const Point& c : coarse) {
          best = std::min({best, size_of(weighted_sum(1, t, -eigenvalue, c)),
                           size_of(weighted_sum(1, t, eigenvalue, c))});
        }
        matched += best < 1e-14 ? 1 : 0;
      }
      EXPECT_GE(matched, static_cast<int>(2 * n)) << n;
    }
  }
}

// A quadratic height over a plane grid is reproduced: its derivatives are those of the height.
TEST(DooSabinDerivativeRows, OfAQuadraticAreItsOwn) {
  Mesh control = quad_grid(6, 6);
  // The control points of (u^2, u v, v^2) differ from its values by constants.
  for (Point& p : control.points) p[2] = p[0] * p[0] - 3 * p[0] * p[1] + 2 * p[1] * p[1];
  const auto topology = Topology::build(control).value();
  const PatchRows rows = rows_of(control, {Scheme::doo_sabin});
  int seen = 0;
  for (std::size_t p = 0; p < rows.patch_count(); ++p) {
    if (!among_quads(topology, rows.vertices()[p])) continue;
    ++seen;
    const Derivatives found = by_rows(rows, p, control.points);
    for (const Point& d : found.second) {
      EXPECT_NEAR(std::min(std::abs(d[2] - 2), std::abs(d[2] - 4)), 0, 1e-13);
      EXPECT_NEAR(std::hypot(d[0], d[1]), 0, 1e-13);
    }
    for (const Point& d : found.mixed) EXPECT_NEAR(std::abs(d[2]), 3, 1e-13);
  }
  EXPECT_EQ(seen, 16);
}

// What one patch has for both neighbours makes the same sums.
TEST(DooSabinDerivativeRows, SharedSidesMakeTheSameSums) {
  for (const Mesh& given : {cube(), prism(5), quad_grid(4, 5), random_polygons({.seed = 3})}) {
    const Rules rules = {Scheme::doo_sabin};
    const Mesh control = control_of(given, rules, 7);
    std::array<double, 6> sums[2] = {};
    std::size_t count[2] = {};
    for (const Sides sides : {Sides::each, Sides::shared}) {
      const PatchRows rows = rows_of(control, rules, 1, sides);
      const auto s = static_cast<std::size_t>(sides);
      for (std::size_t p = 0; p < rows.patch_count(); ++p) {
        const PatchKind& kind = rows.kind(p);
        count[s] += kind.row_count();
        for (std::size_t r = 0; r < kind.row_count(); ++r) {
          Point value = {};
          for (std::size_t c = 0; c < kind.columns; ++c) {
            value = weighted_sum(1, value, kind.row(r)[c], control.points[rows.columns(p)[c]]);
          }
          const auto which = 2 * static_cast<std::size_t>(kind.derivative[r]);
          sums[s][which] += kind.count[r] * dot(value, value);
          sums[s][which + 1] += kind.area[r] * dot(value, value);
        }
      }
    }
    for (std::size_t k = 0; k < sums[0].size(); ++k) {
      EXPECT_NEAR(sums[0][k], sums[1][k], 1e-11 * sums[0][k]) << k;
    }
    EXPECT_LT(count[1], 0.8 * static_cast<double>(count[0]));
  }
}

// By refinement of the control mesh: where the given vertices' places go does not depend on what
// the method takes for their limits.
double missed_by(const Mesh& control, const Mesh& given, const Rules& rules) {
  constexpr int kLevels = 3;
  auto level = refined_level(given, rules, kLevels);
  level.mesh.points = refine(control, rules, kLevels - 1).value().points;
  double worst = 0;
  for (Index v = 0; v < given.vertex_count(); ++v) {
    worst = std::max(worst, distance(mean(points_at(level, level.sites[v])), given.points[v]));
  }
  return worst / bounding_box(given.points).side();
}

void expect_interpolated(const Mesh& mesh, const Rules& rules) {
  for (const Similarity form : {Similarity::vectors, Similarity::directions, Similarity::fair}) {
    for (const unsigned iterations : {0U, 1000U}) {
      SCOPED_TRACE(std::string(name_of(form)) + ", " + std::to_string(iterations));
      SimilarityOptions options;
      options.rules = rules;
      options.similarity = form;
      options.max_iterations = iterations;
      const auto found = interpolate_similar(mesh, options);
      ASSERT_TRUE(found) << describe(found.error());
      EXPECT_TRUE(found->report.solve.converged);
      EXPECT_TRUE(iterations == 0 || found->report.solver_converged) << found->report.residual;
      EXPECT_LT(missed_by(found->control, mesh, rules), 1e-12);
      const auto certificate = certify(found->control, mesh, rules);
      ASSERT_TRUE(certificate) << describe(certificate.error());
      EXPECT_LE(certificate->max, 1e-12);
    }
  }
}

TEST(SimilarityOnDooSabin, InterpolatesEverySample) {
  for_every_sample(
      [](const Sample& sample, const Rules& rules) { expect_interpolated(sample.mesh, rules); });
}

// Doublets share the control points of their limits with their neighbours, here all of them; every
// corner of a vertex between three is another's, too.
TEST(SimilarityOnDooSabin, InterpolatesNothingButDoublets) {
  Mesh split = tetrahedron();
  const Mesh whole = split;
  for (const auto& [a, b] : std::initializer_list<std::pair<Index, Index>>{
           {0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}) {
    split = split_edge(split, a, b, weighted_sum(0.4, whole.points[a], 0.7, whole.points[b]));
  }
  for (const Rules& rules : doo_sabin_rules()) {
    for (const Index n : {3U, 4U, 7U, 100U}) expect_interpolated(pillow(n), rules);
    expect_interpolated(split, rules);
  }
}

TEST(SimilarityOnDooSabin, InterpolatesTheCommittedMeshes) {
  int interpolated = 0;
  for (const std::string& path : committed_meshes()) {
    SCOPED_TRACE(path);
    const Mesh mesh = read_mesh(path).value().mesh;
    const Rules rules = {Scheme::doo_sabin};
    const auto topology = Topology::build(mesh);
    if (!topology || !limit_operator(mesh, *topology, rules, {})) continue;  // or semi-sharp
    ++interpolated;
    expect_interpolated(mesh, rules);
  }
  EXPECT_GT(interpolated, 30);
}

// The given mesh, moved: so is the control mesh. Directions know no shear.
TEST(SimilarityOnDooSabin, MovesWithTheGivenMesh) {
  const Mesh mesh = random_polygons({.seed = 5});
  const auto moved = [](Values points, bool sheared) {
    for (Point& p : points) {
      const Point q = sheared ? Point{2 * p[0] + p[1], p[1] - 0.4 * p[2], 0.7 * p[2]}
                              : Point{3 * p[1], -3 * p[0], 3 * p[2]};
      p = {q[0] + 5, q[1] - 2, q[2] + 1};
    }
    return points;
  };
  for (const Similarity form : {Similarity::vectors, Similarity::directions, Similarity::fair}) {
    SimilarityOptions options;
    options.rules = {Scheme::doo_sabin};
    options.similarity = form;
    options.scaling = Scaling::none;
    options.solver_tolerance = 1e-13;
    options.max_iterations = 5000;
    const bool sheared = form != Similarity::directions;
    const auto solver = SimilarityInterpolator::create(mesh, options).value();
    const auto before = solver.solve(mesh.points).value();
    const auto after = solver.solve(moved(mesh.points, sheared)).value();
    EXPECT_LT(max_distance(moved(before.points, sheared), after.points), sheared ? 1e-10 : 1e-8);
  }
}

// Other numbers of the faces and vertices, the same surface.
TEST(SimilarityOnDooSabin, DoesNotDependOnTheNumbering) {
  const Mesh mesh = random_polygons({.seed = 6, .kind = 2});
  std::mt19937_64 random(2);
  std::vector<Index> to(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) to[v] = v;
  std::shuffle(to.begin(), to.end(), random);
  Mesh other;
  other.points.resize(mesh.points.size());
  for (Index v = 0; v < mesh.vertex_count(); ++v) other.points[to[v]] = mesh.points[v];
  for (Index f = mesh.face_count(); f > 0; --f) {
    std::vector<Index> face;
    for (const Index v : mesh.face(f - 1)) face.push_back(to[v]);
    std::rotate(face.begin(), face.begin() + 1, face.end());
    other.add_face(face);
  }
  for (const Similarity form : {Similarity::vectors, Similarity::fair}) {
    SimilarityOptions options;
    options.rules = {Scheme::doo_sabin};
    options.similarity = form;
    options.solver_tolerance = 1e-13;
    const auto one = interpolate_similar(mesh, options).value();
    const auto two = interpolate_similar(other, options).value();
    // Corner points have the numbers of the corners that made them.
    double worst = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const Index g = mesh.face_count() - 1 - f;
      const auto m = static_cast<Index>(mesh.face(f).size());
      for (Index k = 0; k < m; ++k) {
        const Point& p = one.control.points[mesh.face_offsets[f] + (k + 1) % m];
        worst = std::max(worst, distance(p, two.control.points[other.face_offsets[g] + k]));
      }
    }
    EXPECT_LT(worst, 1e-10);
  }
}

TEST(SimilarityOnDooSabin, GaussAndSeidelFindTheSame) {
  const Mesh mesh = random_polygons({.seed = 7});
  for (const Similarity form : {Similarity::vectors, Similarity::directions, Similarity::fair}) {
    SimilarityOptions options;
    options.rules = {Scheme::doo_sabin};
    options.similarity = form;
    options.solver_tolerance = 1e-11;
    options.max_iterations = 20000;
    const auto one = interpolate_similar(mesh, options).value();
    options.solver = SimilaritySolver::gauss_seidel;
    const auto two = interpolate_similar(mesh, options).value();
    EXPECT_TRUE(two.report.solver_converged);
    EXPECT_LT(max_distance(one.control.points, two.control.points), 1e-6);
  }
}

TEST(SimilarityOnDooSabin, SameBitsForAnyNumberOfThreads) {
  const Mesh mesh = refine(random_polygons({.seed = 8}), {Scheme::catmull_clark}, 1).value();
  for (const Similarity form : {Similarity::vectors, Similarity::directions, Similarity::fair}) {
    SimilarityOptions options;
    options.rules = {Scheme::doo_sabin};
    options.similarity = form;
    const auto one = interpolate_similar(mesh, options, {.threads = 1}).value();
    for (const int threads : {2, 8}) {
      EXPECT_EQ(one.control.points,
                interpolate_similar(mesh, options, {.threads = threads}).value().control.points);
    }
  }
}

TEST(SimilarityOnDooSabin, ChannelsAreInterpolatedAlong) {
  Mesh mesh = random_polygons({.seed = 9});
  Channel colour{"color", {"r", "g"}, {}};
  for (const Point& p : mesh.points) colour.values.insert(colour.values.end(), {p[1], 7 * p[2]});
  mesh.channels = {colour};
  SimilarityOptions options;
  options.rules = {Scheme::doo_sabin};
  const auto found = interpolate_similar(mesh, options).value();
  Mesh carrier = found.control;
  Mesh given = mesh;
  for (std::size_t v = 0; v < carrier.points.size(); ++v) {
    carrier.points[v] = {found.control.channels[0].values[2 * v],
                         found.control.channels[0].values[2 * v + 1], 0};
  }
  for (Point& p : given.points) p = {p[1], 7 * p[2], 0};
  EXPECT_LT(certify(carrier, given, options.rules)->max, 1e-13);
}

// The limit points are found by the faces of the given mesh; other faces, or none, do not do.
TEST(SimilarityOnDooSabin, CertificatesNeedTheFacesOfTheGivenMesh) {
  const Mesh mesh = prism(5);
  SimilarityOptions options;
  options.rules = {Scheme::doo_sabin};
  const Mesh control = interpolate_similar(mesh, options)->control;
  EXPECT_EQ(certify(control, mesh.points, options.rules).error().code, ErrorCode::mismatch);
  Mesh other = mesh;
  std::rotate(other.face_vertices.begin(), other.face_vertices.begin() + 1,
              other.face_vertices.begin() + 4);
  EXPECT_EQ(certify(control, other, options.rules).error().code, ErrorCode::mismatch);
  EXPECT_EQ(certify(control, bipyramid(5), options.rules).error().code, ErrorCode::mismatch);
  Mesh moved = mesh;
  moved.points[3][1] += 1e-3 * bounding_box(mesh.points).side();
  EXPECT_NEAR(certify(control, moved, options.rules)->max, 1e-3, 1e-6);
  EXPECT_EQ(certify(control, moved, options.rules)->worst_vertex, 3U);
}

}  // namespace
}  // namespace surpass::test

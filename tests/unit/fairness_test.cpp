// Fairness measures where they are known: on tori, by Gauss and Bonnet, and by the laws that they
// obey.
#include <numeric>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "fairness_samples.hpp"

namespace surpass {
namespace {

using test::Torus;

Fairness measure(const Mesh& mesh, Scheme scheme, int levels, int rings = 2) {
  const auto found = fairness(mesh, {scheme}, {.levels = levels, .rings = rings});
  EXPECT_TRUE(found) << describe(found.error());
  return found.value_or(Fairness{});
}

// The surface of control points on the torus is off by a multiple of the squared step, so every
// measure is, too: with twice the points its error is a quarter.
TEST(Fairness, OfAFineTorusIsThatOfTheTorus) {
  const Torus torus;
  for (const Scheme scheme : all_schemes()) {
    const Fairness coarse = measure(torus.mesh(scheme, 48, 24), scheme, 3);
    const Fairness fine = measure(torus.mesh(scheme, 96, 48), scheme, 3);
    const auto expect = [&](const char* what, double known, auto&& value, double accuracy) {
      const double before = value(coarse) - known;
      const double after = value(fine) - known;
      EXPECT_LT(std::abs(after), accuracy * known) << what << ", " << name_of(scheme);
      EXPECT_NEAR(before / after, 4, 0.35) << what << ", " << name_of(scheme);
    };
    expect(
        "area", torus.area(), [](const Fairness& f) { return f.coverage.area; }, 0.01);
    expect(
        "bending", torus.bending(), [](const Fairness& f) { return f.bending; }, 0.02);
    expect(
        "total variation", torus.variation(1), [](const Fairness& f) { return f.total_variation; },
        0.05);
    if (scheme == Scheme::doo_sabin) continue;  // whose curvature jumps
    expect(
        "variation", torus.variation(2), [](const Fairness& f) { return f.curvature_variation; },
        0.04);
    expect(
        "largest", 1 / torus.r, [](const Fairness& f) { return f.largest_curvature; }, 0.02);
  }
}

TEST(Fairness, OfATorusLeavesNothingOut) {
  for (const Scheme scheme : all_schemes()) {
    const Fairness found = measure(Torus{}.mesh(scheme, 24, 12), scheme, 2);
    const FairnessCoverage& c = found.coverage;
    EXPECT_EQ(c.patches, (scheme == Scheme::loop ? 2U : 1U) * 24 * 12 * 16) << name_of(scheme);
    EXPECT_EQ(c.measured_patches, c.patches);
    EXPECT_EQ(c.left_out, 0);
    EXPECT_EQ(c.area, c.measured_area);
    EXPECT_EQ(c.samples, 24U * 12 * 16);
    EXPECT_EQ(c.degenerate_samples, 0U);
    EXPECT_DOUBLE_EQ(found.curvature_variation_relative, found.curvature_variation * c.area);
    EXPECT_DOUBLE_EQ(found.largest_curvature_relative, found.largest_curvature * std::sqrt(c.area));
  }
}

// Second derivatives of the torus by the steps of the control mesh, in parameters with unit faces.
TEST(Fairness, ThinPlateIsOverTheControlMeshsParameters) {
  const Torus torus;
  constexpr Index kAround = 96;
  constexpr Index kTube = 48;
  const double s = 2 * M_PI / kAround;
  const double t = 2 * M_PI / kTube;
  for (const Scheme scheme : all_schemes()) {
    double sum = 0;
    for (Index j = 0; j < kTube; ++j) {
      const double p = t * j;
      const double w = torus.R + torus.r * std::cos(p);
      const Eigen::Vector3d a = s * s * Eigen::Vector3d(-w, 0, 0);
      const Eigen::Vector3d b = t * t * torus.r * Eigen::Vector3d(-std::cos(p), 0, -std::sin(p));
      const Eigen::Vector3d m = s * t * torus.r * Eigen::Vector3d(0, -std::sin(p), 0);
      if (scheme == Scheme::loop) {
        // The steps are at 60 degrees: with unit vectors x and (x + root 3 y) / 2.
        const Eigen::Vector3d xy = (2 * m - a) / std::sqrt(3.0);
        const Eigen::Vector3d yy = (a + 4 * b - 4 * m) / 3;
        sum += kAround * std::sqrt(3.0) / 2 *
               (a.squaredNorm() + 2 * xy.squaredNorm() + yy.squaredNorm());
      } else {
        sum += kAround * (a.squaredNorm() + 2 * m.squaredNorm() + b.squaredNorm());
      }
    }
    const double parameters = kAround * kTube * (scheme == Scheme::loop ? std::sqrt(3.0) / 2 : 1);
    const Fairness found = measure(torus.mesh(scheme, kAround, kTube), scheme, 2);
    EXPECT_NEAR(found.thin_plate / sum, 1, 0.01) << name_of(scheme);
    EXPECT_NEAR(found.thin_plate_relative, found.thin_plate * parameters / found.coverage.area,
                1e-12 * found.thin_plate_relative);
  }
}

// What is left out around extraordinary vertices, and the sampling error, shrink by a factor a
// level in the long run; Aitken's extrapolation from three levels takes it off.
void expect_gauss_bonnet(const Mesh& mesh, Scheme scheme, int euler, const std::string& what) {
  std::vector<double> found;
  for (const int levels : {4, 5, 6}) {
    found.push_back(measure(mesh, scheme, levels, 0).total_gauss / (2 * M_PI));
  }
  const double before = found[1] - found[0];
  const double last = found[2] - found[1];
  EXPECT_LT(std::abs(found[2] - euler), 0.6 * std::abs(found[1] - euler)) << what;
  EXPECT_NEAR(found[2] + last * last / (before - last), euler, 0.005) << what;
}

TEST(Fairness, TotalCurvatureIsGaussAndBonnets) {
  for (const Scheme scheme : all_schemes()) {
    const std::string name = name_of(scheme);
    expect_gauss_bonnet(test::icosahedron(), scheme, 2, name + " icosahedron");
    expect_gauss_bonnet(test::octahedron(), scheme, 2, name + " octahedron");
    expect_gauss_bonnet(test::bipyramid(5), scheme, 2, name + " bipyramid");
    if (scheme != Scheme::loop) expect_gauss_bonnet(test::cube(), scheme, 2, name + " cube");
    // Here nothing is left out, and the error of sampling is of second order.
    const Mesh torus = Torus{}.mesh(scheme, 24, 12);
    const double coarse = measure(torus, scheme, 3).total_gauss;
    const double fine = measure(torus, scheme, 4).total_gauss;
    EXPECT_LT(std::abs(coarse), 0.01) << name;
    EXPECT_LT(std::abs(fine), std::abs(coarse) / 3.5 + 1e-9) << name;
  }
}

Mesh moved(const Mesh& mesh, const Eigen::Affine3d& map) {
  Mesh out = mesh;
  for (Point& p : out.points) {
    const Eigen::Vector3d q = map * Eigen::Map<const Eigen::Vector3d>(p.data());
    p = {q[0], q[1], q[2]};
  }
  return out;
}

// All that is measured, each divided by the power of length that it has.
std::vector<double> free_of(double unit, const Fairness& f) {
  return {f.bending,
          f.trimmed_bending,
          f.thin_plate / (unit * unit),
          f.thin_plate_relative,
          f.curvature_variation * unit * unit,
          f.curvature_variation_relative,
          f.total_variation,
          f.largest_curvature * unit,
          f.high_curvature * unit,
          f.largest_curvature_relative,
          f.high_curvature_relative,
          f.total_gauss,
          f.coverage.area / (unit * unit),
          f.coverage.measured_area / (unit * unit),
          f.coverage.left_out};
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b, double accuracy,
                 const std::string& what) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i], b[i], accuracy * (std::abs(a[i]) + 1)) << what << ", measure " << i;
  }
}

TEST(Fairness, ObeysItsLaws) {
  for (const Scheme scheme : all_schemes()) {
    for (const int kind : {0, 2}) {
      const Mesh mesh = test::random_mesh_for(scheme, {.seed = 11, .kind = kind, .creases = 0.05});
      const auto plain = free_of(1, measure(mesh, scheme, 4));
      const std::string name = name_of(scheme);
      Eigen::Affine3d scale(Eigen::Scaling(300.0));
      expect_same(plain, free_of(300, measure(moved(mesh, scale), scheme, 4)), 1e-9,
                  name + " scaled");
      Eigen::Affine3d power(Eigen::Scaling(1 / 1024.0));
      EXPECT_EQ(plain, free_of(1 / 1024.0, measure(moved(mesh, power), scheme, 4)))
          << "a power of two changes no bit";
      Eigen::Affine3d turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
      turn.translation() = Eigen::Vector3d(5, -3, 8);
      expect_same(plain, free_of(1, measure(moved(mesh, turn), scheme, 4)), 1e-9, name + " turned");

      Mesh other = mesh;
      std::vector<Index> to(mesh.vertex_count());
      std::iota(to.begin(), to.end(), 0U);
      std::mt19937_64 random(3);
      std::shuffle(to.begin(), to.end(), random);
      for (Index v = 0; v < mesh.vertex_count(); ++v) other.points[to[v]] = mesh.points[v];
      for (Index& v : other.face_vertices) v = to[v];
      for (Crease& c : other.creases) c.vertices = {to[c.vertices[0]], to[c.vertices[1]]};
      for (Corner& c : other.corners) c.vertex = to[c.vertex];
      expect_same(plain, free_of(1, measure(other, scheme, 4)), 1e-9, name + " renumbered");
    }
  }
}

// A control mesh refined once is the same surface; its parameters are half as long.
TEST(Fairness, IsThatOfTheRefinedControlMesh) {
  for (const Scheme scheme : all_schemes()) {
    const Mesh mesh = test::random_mesh_for(scheme, {.seed = 4, .kind = 1});
    const Mesh refined = refine(mesh, {scheme}, 1).value();
    EXPECT_EQ(level_difference(mesh, mesh), 0);
    EXPECT_EQ(level_difference(refined, mesh), 1);
    EXPECT_EQ(level_difference(mesh, refined), -1);
    const Fairness coarse = measure(mesh, scheme, 4);
    Fairness fine = measure(refined, scheme, 3);
    EXPECT_NEAR(fine.thin_plate * 4, coarse.thin_plate, 1e-9 * coarse.thin_plate);
    fine.thin_plate *= 4;
    expect_same(free_of(1, coarse), free_of(1, fine), 1e-9, name_of(scheme));
  }
}

TEST(Fairness, HasTheSameBitsForAnyNumberOfThreads) {
  for (const Scheme scheme : all_schemes()) {
    const Mesh mesh = test::random_mesh_for(scheme, {.seed = 2, .kind = 0, .creases = 0.03});
    Context context;
    context.threads = 1;
    const FairnessOptions options{.levels = 5};
    const auto one = fairness(mesh, {scheme}, options, context).value();
    ASSERT_GT(one.coverage.patches, 20000U);
    const Mesh other = moved(mesh, Eigen::Affine3d(Eigen::Scaling(1.0, 1.1, 0.9)));
    const auto deviation = normal_deviation(mesh, other, {scheme}, options, context).value();
    for (const int threads : {2, 3, 8}) {
      context.threads = threads;
      EXPECT_EQ(free_of(1, one), free_of(1, fairness(mesh, {scheme}, options, context).value()));
      const auto again = normal_deviation(mesh, other, {scheme}, options, context).value();
      EXPECT_EQ(deviation.mean, again.mean);
      EXPECT_EQ(deviation.rms, again.rms);
      EXPECT_EQ(deviation.max, again.max);
    }
  }
}

}  // namespace
}  // namespace surpass

// Requirements that lie so densely that most follow from the others, or nearly.
#include <surpass/similarity.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/polygons.hpp"
#include "support/requirements.hpp"

namespace surpass {
namespace {

using Kind = Requirement::Kind;

// The cube refined once has 26 control points, of which the eight given vertices take eight: a
// position on a surface that exists follows from 18 others. On the quarter of a face 14 of them
// have a say, and one vertex takes one.
class ManyRequirements : public testing::Test {
 protected:
  static constexpr std::size_t kFreeOnTheCube = 18;
  static constexpr std::size_t kFreeOnAQuarter = 13;

  void SetUp() override {
    control_ = solver_.refined();
    control_.points = solver_.solve(test::cube().points).value().points;
    control_.points[20][0] += 0.1;  // a surface of its own
    given_ = solver_.limit_positions(control_.points).value();
  }

  // What the surface has at n x n places on each of the first quarters; those of a face follow each
  // other.
  [[nodiscard]] std::vector<Requirement> on_quarters(Kind kind, Index quarters, int n) const {
    const LimitSurface surface = LimitSurface::create(control_, SimilarityOptions{}.rules).value();
    std::vector<Requirement> all;
    for (Index corner = 0; corner < quarters; ++corner) {
      for (int i = 0; i < n * n; ++i) {
        const double u = (i % n + 0.5) / n;
        const double v = (i / n + 0.5) / n;
        const SurfaceSample s = surface.evaluate({corner, u, v}).value();
        const Point& value = kind == Kind::position ? s.position
                             : kind == Kind::normal ? s.normal
                                                    : s.du;
        all.push_back(test::on_face(kind, {corner / 4, u, v, corner % 4}, value));
      }
    }
    return all;
  }

  // How many are not redundant, once all are met.
  [[nodiscard]] std::size_t needed(const std::vector<Requirement>& all) const {
    const auto found = solver_.solve_required(all, given_);
    EXPECT_TRUE(found) << describe(found.error());
    if (!found) return 0;
    std::size_t count = 0;
    for (const RequirementOutcome& outcome : found->report.requirements) {
      EXPECT_LT(outcome.error, 1e-11);
      count += outcome.redundant ? 0 : 1;
    }
    return count;
  }

  SimilarityInterpolator solver_ = SimilarityInterpolator::create(test::cube()).value();
  Mesh control_;
  std::vector<Point> given_;
};

TEST_F(ManyRequirements, AreAsManyAsThereIsFreedomFor) {
  for (const int n : {5, 8, 12, 20}) {
    SCOPED_TRACE(n);
    EXPECT_EQ(needed(on_quarters(Kind::position, 1, n)), kFreeOnAQuarter);
    // A derivative does not see where the surface is.
    EXPECT_EQ(needed(on_quarters(Kind::derivative, 1, n)), kFreeOnAQuarter - 1);
    // The normals are the surface's if each of 13 points may go along one direction at least.
    EXPECT_LE(needed(on_quarters(Kind::normal, 1, n)), 3 * kFreeOnAQuarter);
  }
  EXPECT_EQ(needed(on_quarters(Kind::position, 24, 6)), kFreeOnTheCube);
  EXPECT_EQ(needed(on_quarters(Kind::derivative, 24, 6)), kFreeOnTheCube);
}

TEST_F(ManyRequirements, FindTheSurfaceThatTheyAreOf) {
  const auto found = solver_.solve_required(on_quarters(Kind::position, 24, 4), given_);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_LT(test::max_distance(found->points, control_.points), 1e-9);
}

// There coordinates are rounded to a trillionth, or a ten-billionth, of the box side, and so are
// the requirements: what they say agrees to that, times shares in the hundreds.
TEST_F(ManyRequirements, FarFromTheOriginAreMetToTheRoundingThere) {
  for (const double away : {1e4, 1e6}) {
    SCOPED_TRACE(away);
    for (Point& p : control_.points) {
      for (double& c : p) c += away;
    }
    given_ = solver_.limit_positions(control_.points).value();
    const double allowed = floored_tolerance(
        kRequirementTolerance, flat(std::span<const Point>(given_)), bounding_box(given_).side());
    for (const Kind kind : {Kind::position, Kind::derivative, Kind::normal}) {
      for (const Index quarters : {1U, 24U}) {
        const auto found = solver_.solve_required(on_quarters(kind, quarters, 8), given_);
        ASSERT_TRUE(found) << describe(found.error());
        for (const RequirementOutcome& outcome : found->report.requirements) {
          EXPECT_LT(outcome.error, allowed);
        }
      }
    }
    for (Point& p : control_.points) {
      for (double& c : p) c -= away;
    }
  }
}

TEST_F(ManyRequirements, OneThatLiesElsewhereIsSeen) {
  for (const double apart : {1e-3, 1e-6, 1e-8}) {
    std::vector<Requirement> all = on_quarters(Kind::position, 1, 12);
    all[77].value[1] += apart;
    const auto refused = solver_.solve_required(all, given_);
    ASSERT_FALSE(refused) << apart;
    EXPECT_EQ(refused.error().code, ErrorCode::contradictory);
  }
}

// "1 (what), 2 (what) and 4 more: 7, 9-11".
std::vector<std::size_t> numbers_named(std::string message) {
  message = message.substr(message.find(": ") + 2);
  message = message.substr(0, message.find(';'));
  message = std::regex_replace(message, std::regex("\\([^)]*\\)| and [0-9]+ more:"), ",");
  const std::regex run("([0-9]+)(-([0-9]+))?");
  std::vector<std::size_t> numbers;
  for (std::sregex_iterator at(message.begin(), message.end(), run), end; at != end; ++at) {
    const std::size_t first = std::stoul((*at)[1]);
    const std::size_t last = (*at)[3].matched ? std::stoul((*at)[3]) : first;
    for (std::size_t i = first; i <= last; ++i) numbers.push_back(i);
  }
  return numbers;
}

// All that are named contradict each other, and without any one of them they do not.
TEST_F(ManyRequirements, ThoseThatContradictAreNamed) {
  std::vector<Requirement> all = on_quarters(Kind::position, 1, 12);
  all[77].value[1] += 1e-3;
  const auto refused = solver_.solve_required(all, given_);
  ASSERT_FALSE(refused);
  const auto numbers = numbers_named(refused.error().message);
  ASSERT_GT(numbers.size(), 6U) << refused.error().message;
  std::vector<Requirement> named;
  for (const std::size_t i : numbers) named.push_back(all.at(i));
  EXPECT_FALSE(solver_.solve_required(named, given_));
  for (std::size_t i = 0; i < named.size(); ++i) {
    std::vector<Requirement> others = named;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_TRUE(solver_.solve_required(others, given_)) << numbers[i];
  }
}

// Whatever was about to be named.
TEST_F(ManyRequirements, InterruptedAtAnyTimeTheyAreNotRefused) {
  std::vector<Requirement> all = on_quarters(Kind::position, 1, 8);
  all[33].value[1] += 1e-3;
  int reports = 0;
  Context context{.threads = 1, .progress = [&](const Progress&) { ++reports; }};
  EXPECT_EQ(solver_.solve_required(all, given_, {}, {}, context).error().code,
            ErrorCode::contradictory);
  const int whole = reports;
  ASSERT_GT(whole, 10);
  std::atomic<bool> stop = false;
  context.cancel = &stop;
  for (int last = 1; last < whole; ++last) {
    reports = 0;
    stop = false;
    context.progress = [&](const Progress&) { stop = ++reports >= last; };
    EXPECT_EQ(solver_.solve_required(all, given_, {}, {}, context).error().code,
              ErrorCode::cancelled)
        << last << " of " << whole;
  }
}

// What a normal leaves to a place others may take, so that rows are fewer than requirements say;
// and 14 values of every coordinate follow from each other by shares of thousands.
TEST_F(ManyRequirements, OfMixedKindsAllThatContradictAreNamedAndNoMore) {
  std::mt19937 random(11);
  std::normal_distribution<double> number;
  std::uniform_real_distribution<double> at(0.05, 0.95);
  const auto contradict = [&](const std::vector<Requirement>& all) {
    const auto result = solver_.solve_required(all, given_);
    return !result && result.error().message.find("contradict") != std::string::npos;
  };
  const std::array kinds = {Kind::position, Kind::normal, Kind::derivative};
  for (int trial = 0; trial < 12; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<Requirement> all;
    for (std::size_t i = 0; i < 30; ++i) {
      const SurfacePlace place{0, at(random), at(random), 0};
      const Point value = {number(random), number(random), number(random)};
      all.push_back(test::on_face(kinds[i % 3], place, value, {number(random), number(random)}));
    }
    const auto refused = solver_.solve_required(all, given_);
    ASSERT_FALSE(refused);
    std::vector<Requirement> named;
    for (const std::size_t i : numbers_named(refused.error().message)) named.push_back(all.at(i));
    EXPECT_LT(named.size(), 25U) << refused.error().message;
    EXPECT_TRUE(contradict(named)) << refused.error().message;
    for (std::size_t i = 0; i < named.size(); ++i) {
      std::vector<Requirement> others = named;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_FALSE(contradict(others)) << i << " of " << refused.error().message;
    }
  }
}

// The nearer a place is to a given vertex, the less of its position is free, and the less tells it
// from what the normal there says.
TEST_F(ManyRequirements, BesideAGivenVertexAreMet) {
  const LimitSurface surface = LimitSurface::create(control_, SimilarityOptions{}.rules).value();
  for (double apart = 1e-2; apart > 1e-13; apart /= 3) {
    SCOPED_TRACE(apart);
    const SurfaceSample vertex = surface.evaluate({0, 0, 0}).value();
    const SurfaceSample beside = surface.evaluate({0, apart, apart / 2}).value();
    const auto normal = test::on_face(Kind::normal, {0, 0, 0, 0}, vertex.normal);
    const auto position = test::on_face(Kind::position, {0, apart, apart / 2, 0}, beside.position);
    EXPECT_LE(needed({position}), 1U);
    EXPECT_LE(needed({normal, position}), 2U);
  }
}

double width_of(const std::vector<Point>& points) { return bounding_box(points).side(); }

// Directions and normals are met by a point, and the fairest surface of all is one: then some
// tangents get lengths, but not so many that they contradict each other.
TEST_F(ManyRequirements, OfTangentsAloneDoNotShrinkTheSurfaceToAPoint) {
  std::vector<Requirement> all;
  for (Index v = 1; v < 8; ++v) all.push_back(test::at_vertex(Kind::remove, v));
  for (const auto form : {Similarity::fair, Similarity::directions, Similarity::vectors}) {
    const auto solver = SimilarityInterpolator::create(test::cube(), {.similarity = form}).value();
    for (const Kind kind : {Kind::normal, Kind::direction}) {
      for (const int n : {1, 2, 3}) {
        SCOPED_TRACE(testing::Message()
                     << name_of(form) << ' ' << (kind == Kind::normal ? "normals" : "directions")
                     << ' ' << n);
        std::vector<Requirement> asked = all;
        for (const Requirement& r : on_quarters(kind, 24, n)) asked.push_back(r);
        const auto found = solver.solve_required(asked, given_);
        ASSERT_TRUE(found) << describe(found.error());
        EXPECT_TRUE(found->report.solve.converged);
        for (const RequirementOutcome& outcome : found->report.requirements) {
          EXPECT_LT(outcome.error, 1e-11);
        }
        EXPECT_GT(width_of(found->points), 0.05 * width_of(given_));
        EXPECT_LT(width_of(found->points), 20 * width_of(given_));
      }
    }
  }
}

// So many that only a point does them all, which is no surface.
TEST_F(ManyRequirements, OfTangentsThatOnlyAPointMeetsAreRefused) {
  for (const double wrong : {1e-3, 1e-5, 1e-7}) {
    SCOPED_TRACE(wrong);
    std::vector<Requirement> all;
    for (Index v = 1; v < 8; ++v) all.push_back(test::at_vertex(Kind::remove, v));
    for (Requirement& r : on_quarters(Kind::direction, 24, 3)) {
      r.value[all.size() % 3] += wrong * std::cos(all.size());
      all.push_back(r);
    }
    const auto refused = solver_.solve_required(all, given_);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("no surface was found"), std::string::npos);
  }
}

// A redundant requirement elsewhere has no say in which lengths are kept.
TEST_F(ManyRequirements, WhatFollowsAnywayChangesNothing) {
  for (const double apart : {2e-3, 5e-3, 2e-2, 0.1}) {
    SCOPED_TRACE(apart);
    std::vector<Requirement> all;
    for (const double u : {0.4, 0.4 + apart}) {  // across the cube's first face, which z is
      all.push_back(test::on_face(Kind::direction, {0, u, 0.5}, {0.1, 0.2, 1}));
    }
    const auto without = solver_.solve_required(all, given_);
    all.push_back(test::on_face(Kind::position, {3, 0, 0}, given_[test::cube().face(3)[0]]));
    const auto with = solver_.solve_required(all, given_);
    ASSERT_TRUE(without && with);
    EXPECT_TRUE(with->report.requirements.back().redundant);
    EXPECT_LT(test::max_distance(without->points, with->points), 1e-9);
  }
}

// Two places less than 1e-9 apart are one, but for what normals may differ there.
TEST_F(ManyRequirements, NormalsBesideEachOtherDifferByWhatTheSurfaceDoes) {
  const LimitSurface surface = LimitSurface::create(control_, SimilarityOptions{}.rules).value();
  const auto normal_at = [&](double u, double v) {
    return test::on_face(Kind::normal, {2, u, v, 1}, surface.evaluate({9, u, v}).value().normal);
  };
  const Requirement one = normal_at(0.5, 0.5);
  Requirement beside = normal_at(0.5 + 5e-10, 0.5);
  EXPECT_LE(needed({one, beside}), 2U);
  beside.value[0] += 1e-3;
  const auto refused = solver_.solve_required(std::vector{one, beside}, given_);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::contradictory);
}

TEST_F(ManyRequirements, ThatNoSurfaceMeetsAreRefused) {
  std::vector<Requirement> many;
  for (int k = 0; k < 4000; ++k) {
    const auto at = [&](double step) { return std::fmod(0.5 + step * k, 1.0); };
    const SurfacePlace place{static_cast<Index>(k % 6), at(0.754877), at(0.569840)};
    many.push_back(test::on_face(Kind::position, place, {at(0.618), at(0.382), at(0.236)}));
  }
  const auto refused = solver_.solve_required(many, given_);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::contradictory);
}

}  // namespace
}  // namespace surpass

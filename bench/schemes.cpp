// The other schemes on quads of the same size, and many solves in a row.
#include <surpass/interpolate.hpp>
#include <surpass/quality.hpp>

#include <stdexcept>

#include "contenders.hpp"
#include "judges.hpp"

namespace surpass::bench {
namespace {

const Context kOneThread{.threads = 1};
constexpr int kFrames = 100;

std::shared_ptr<const Interpolator> prepared(const Mesh& mesh, Scheme scheme) {
  InterpolateOptions options{.tolerance = kTolerance};
  options.rules.scheme = scheme;
  auto solver = Interpolator::create(mesh, options, kOneThread);
  if (!solver) throw std::runtime_error(describe(solver.error()));
  return std::make_shared<const Interpolator>(std::move(*solver));
}

Solution solved(const Interpolator& solver, std::span<const Point> points) {
  auto solution = solver.solve(points, {}, kOneThread);
  if (!solution) throw std::runtime_error(describe(solution.error()));
  return std::move(*solution);
}

// By the plain rows, from the faces.
Verdict judge_scheme(const Mesh& mesh, Scheme scheme, const Solution& solution) {
  Mesh control = mesh;
  control.points = solution.points;
  const auto certificate = certify(control, mesh.points, {.scheme = scheme}, kOneThread);
  if (!certificate) throw std::runtime_error(describe(certificate.error()));
  return {.error = certificate->max, .sweeps = solution.report.iterations};
}

}  // namespace

void add_schemes(Harness& harness, Index side) {
  for (const Scheme scheme : {Scheme::catmull_clark, Scheme::doo_sabin}) {
    harness.add(
        {.step = std::string("solve again, ") + name_of(scheme) + " on quads",
         .tool = "Surpass",
         .counted = "Interpolator::solve for the points, set-up kept"},
        side,
        [scheme](const Workload& w) {
          return [&mesh = w.quads(), solver = prepared(w.quads(), scheme)] {
            return solved(*solver, mesh.points);
          };
        },
        [scheme](const Workload& w, const Solution& solution) {
          return judge_scheme(w.quads(), scheme, solution);
        });
  }
  harness.add(
      {.step = "100 frames",
       .tool = "Surpass",
       .counted = "set-up and 100 solves on one topology, each frame bent a little further",
       .slow = true},
      side,
      [](const Workload& w) {
        return [&mesh = w.mesh()] {
          const auto solver = prepared(mesh, Scheme::loop);
          std::vector<Point> frame = mesh.points;
          std::vector<Point> control = solved(*solver, frame).points;  // frame 0: as given
          for (int k = 1; k < kFrames; ++k) {
            for (Point& p : frame) p[2] += 1e-3 * p[0] * p[0];
            static_cast<void>(solved(*solver, frame));
          }
          return control;
        };
      },
      [](const Workload& w, const std::vector<Point>& control) {
        return judge_control(w, control);
      });
}

}  // namespace surpass::bench

// Ours: one refinement step from a mesh, and a prepared one applied again and again.
#include "refinement.hpp"

#include <surpass/refiner.hpp>

#include <stdexcept>

namespace surpass::bench {
namespace {

const Context kOneThread{.threads = 1};

template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(describe(result.error()));
  return std::move(*result);
}

Verdict judge(const Workload& workload, Scheme scheme, const std::vector<Point>& points,
              const Mesh& mesh) {
  return judge_refined(workload, scheme,
                       {points, mesh.face_vertices, scheme == Scheme::loop ? 3U : 4U},
                       Agreement::doubles);
}

}  // namespace

std::string step_name(const char* what, Scheme scheme) {
  return std::string(what) + (scheme == Scheme::loop ? "" : std::string(", ") + name_of(scheme));
}

namespace {

void add_once(Harness& harness, Index side, Scheme scheme) {
  harness.add(
      {.step = step_name("refine", scheme),
       .tool = "Surpass",
       .counted = "refine: topology, weights, points and faces of the refined mesh"},
      side,
      [scheme](const Workload& w) {
        return [&mesh = given(w, scheme), scheme] {
          return value_of(refine(mesh, {.scheme = scheme}, 1, kOneThread));
        };
      },
      [scheme](const Workload& w, const Mesh& refined) {
        return judge(w, scheme, refined.points, refined);
      });
}

// A refiner and room for what it makes.
struct Prepared {
  Refiner refiner;
  std::vector<Point> refined;
};

std::shared_ptr<Prepared> prepare(const Mesh& mesh, Scheme scheme) {
  auto refiner = value_of(Refiner::create(mesh, {.rules = {.scheme = scheme}}, kOneThread));
  const std::size_t count = refiner.mesh().points.size();
  return std::make_shared<Prepared>(Prepared{std::move(refiner), std::vector<Point>(count)});
}

void add_again(Harness& harness, Index side, Scheme scheme) {
  harness.add(
      {.step = step_name("refine again", scheme),
       .tool = "Surpass",
       .counted = "Refiner::refine for the points, into kept memory"},
      side,
      [scheme](const Workload& w) {
        const Mesh& mesh = given(w, scheme);
        return [&mesh, kept = prepare(mesh, scheme)] {
          const std::span<const Point> points = mesh.points;
          const auto done =
              kept->refiner.refine(3, flat(points), flat(std::span(kept->refined)), kOneThread);
          if (!done) throw std::runtime_error(describe(done.error()));
          return kept;
        };
      },
      [scheme](const Workload& w, const std::shared_ptr<Prepared>& kept) {
        return judge(w, scheme, kept->refined, kept->refiner.mesh());
      });
}

}  // namespace

void add_refinement(Harness& harness, Index side) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    add_once(harness, side, scheme);
    add_again(harness, side, scheme);
  }
}

}  // namespace surpass::bench

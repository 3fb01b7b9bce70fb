// A moving mesh: a surface through its vertices in every frame, upright at the first one, with one
// set-up.
#include <surpass/surpass.hpp>

#include <cstdio>
#include <vector>

static int fail(const surpass::Error& error) {
  std::fprintf(stderr, "%s\n", surpass::describe(error).c_str());
  return 1;
}

// The points, bent along the third axis the more the farther out they lie.
static std::vector<surpass::Point> bent(std::vector<surpass::Point> points, double by) {
  const surpass::Box box = surpass::bounding_box(points);
  for (surpass::Point& p : points) {
    const double out = (p[0] - box.low[0]) / box.side();
    p[2] += by * out * out * box.side();
  }
  return points;
}

int main(int argc, char** argv) {
  if (argc != 2) return fail({.message = "usage: follow MESH"});
  const auto given = surpass::read_mesh(argv[1]);
  if (!given) return fail(given.error());
  const auto solver = surpass::SimilarityInterpolator::create(
      given->mesh, {.rules = {surpass::Scheme::catmull_clark}});
  if (!solver) return fail(solver.error());
  surpass::Requirement upright;
  upright.kind = surpass::Requirement::Kind::normal;
  upright.vertex = 0;
  upright.value = {0, 0, 1};
  for (int i = 0; i < 3; ++i) {
    const auto points = bent(given->mesh.points, 0.1 * i);
    const auto frame = solver->solve_required(std::vector{upright}, points);
    if (!frame) return fail(frame.error());
    std::printf("frame %d: %zu control points, error %.2g, normal met to %.2g\n", i,
                frame->points.size(), frame->report.solve.final.max,
                frame->report.requirements[0].error);
  }
}

// A moving control mesh: the refined surface of every frame, with one set-up.
#include <surpass/surpass.hpp>

#include <cmath>
#include <cstdio>
#include <string>

static int fail(const surpass::Error& error) {
  std::fprintf(stderr, "%s\n", surpass::describe(error).c_str());
  return 1;
}

// The points, turned about the vertical axis the more the higher they lie.
static std::vector<surpass::Point> twisted(std::vector<surpass::Point> points, double turns) {
  const surpass::Box box = surpass::bounding_box(points);
  for (auto& [x, y, z] : points) {
    const double angle = 2 * 3.14159265358979 * turns * (z - box.low[2]) / box.side();
    const double turned = std::cos(angle) * x - std::sin(angle) * y;
    y = std::sin(angle) * x + std::cos(angle) * y;
    x = turned;
  }
  return points;
}

int main(int argc, char** argv) {
  if (argc != 3) return fail({.message = "usage: animate CONTROL FRAMES, such as frame%d.obj"});
  const auto control = surpass::read_mesh(argv[1]);
  if (!control) return fail(control.error());
  const auto scheme = surpass::suggested_scheme(control->mesh);
  const auto refiner =
      surpass::Refiner::create(control->mesh, {.rules = {scheme}, .levels = 2, .limit = true});
  if (!refiner) return fail(refiner.error());
  surpass::Mesh frame = refiner->mesh();
  std::erase_if(frame.channels, [](const auto& c) { return c.name == "normal"; });
  const std::string name = argv[2];
  const auto number = name.find("%d");
  for (int i = 0; i < 3; ++i) {
    const auto moved = refiner->refine(twisted(control->mesh.points, 0.1 * i));
    if (!moved) return fail(moved.error());
    frame.points = *moved;
    const std::string path = number == std::string::npos
                                 ? name
                                 : std::string(name).replace(number, 2, std::to_string(i));
    if (const auto written = surpass::write_mesh(frame, path); !written) {
      return fail(written.error());
    }
    std::printf("%s: %u vertices\n", path.c_str(), frame.vertex_count());
  }
}

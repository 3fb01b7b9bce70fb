// The smallest program: the control mesh whose Loop surface passes through a mesh's vertices.
#include <surpass/surpass.hpp>

#include <cstdio>

static int fail(const surpass::Error& error) {
  std::fprintf(stderr, "%s\n", surpass::describe(error).c_str());
  return 1;
}

int main(int argc, char** argv) {
  if (argc != 3) return fail({.message = "usage: interpolate GIVEN CONTROL"});
  const auto given = surpass::read_mesh(argv[1]);
  if (!given) return fail(given.error());
  const auto found = surpass::interpolate(given->mesh);
  if (!found) return fail(found.error());
  std::printf("error %.1e of the box side after %u evaluations\n", found->report.final.max,
              found->report.iterations);
  const auto written = surpass::write_mesh(found->control, argv[2]);
  return written ? 0 : fail(written.error());
}

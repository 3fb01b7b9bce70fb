// surpass_torus SIDE FILE: writes the benchmark's torus of SIDE x SIDE vertices as OBJ, for
// curve.py.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "generate.hpp"
#include "mesh_files.hpp"

int main(int argc, char** argv) {
  const long side = argc == 3 ? std::strtol(argv[1], nullptr, 10) : 0;
  if (side < 4 || side > 30000) {
    std::fputs("usage: surpass_torus SIDE FILE, with a side from 4 to 30000\n", stderr);
    return 1;
  }
  try {
    const auto n = static_cast<surpass::Index>(side);
    surpass::bench::write_obj(surpass::bench::generate_torus(n, n, surpass::bench::Order::mild),
                              argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surpass_torus: %s\n", error.what());
    return 2;
  }
  return 0;
}

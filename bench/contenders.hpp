// Everybody who takes part. Each function adds what one library can do, at one size.
#pragma once

#include "harness.hpp"

namespace surpass::bench {

void add_anchors(Harness& harness, Index side);
void add_triad(Harness& harness, Index side, const char* step);
void add_surpass(Harness& harness, Index side);
void add_solve_again(Harness& harness, Index side);
void add_command(Harness& harness, Index side);
void add_similarity(Harness& harness, Index side);
void add_schemes(Harness& harness, Index side);
void add_opensubdiv(Harness& harness, Index side);
void add_openmesh(Harness& harness, Index side);
void add_cgal(Harness& harness, Index side);
void add_tinyobjloader(Harness& harness, Index side);
void add_assimp(Harness& harness, Index side);
void add_cholmod(Harness& harness, Index side);
void add_eigen(Harness& harness, Index side);

}  // namespace surpass::bench

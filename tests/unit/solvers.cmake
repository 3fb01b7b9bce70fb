find_package(Eigen3 REQUIRED)
surpass_test(unit_solvers SOURCES direct_solve_test.cpp solvability_test.cpp independent_rows_test.cpp sparse_cholesky_test.cpp
             tiled_rows_test.cpp wavefront_test.cpp LIBS Eigen3::Eigen LABELS unit)

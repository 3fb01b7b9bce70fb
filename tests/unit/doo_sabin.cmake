find_package(Eigen3 REQUIRED)
surpass_test(unit_doo_sabin SOURCES doo_sabin_limit_test.cpp doo_sabin_normals_test.cpp
             doo_sabin_refinement_test.cpp doo_sabin_mesh_test.cpp LIBS Eigen3::Eigen LABELS unit)

find_package(Eigen3 REQUIRED)
surpass_test(unit_similarity
             SOURCES similarity_test.cpp similarity_dense_test.cpp similarity_doo_sabin_test.cpp
                     cross_kernels_test.cpp
             LIBS Eigen3::Eigen LABELS unit)

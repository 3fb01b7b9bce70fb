surpass_test(unit_fairness SOURCES limit_jets_test.cpp curvature_test.cpp fairness_test.cpp fairness_part_test.cpp
             LIBS Eigen3::Eigen LABELS unit)

find_package(Eigen3 REQUIRED)
surpass_test(unit_nonstationary SOURCES nonstationary_values_test.cpp nonstationary_surface_test.cpp
             nonstationary_curves_test.cpp nonstationary_folds_test.cpp nonstationary_schemes_test.cpp nonstationary_fairness_test.cpp
             LIBS Eigen3::Eigen LABELS unit)
surpass_test(nonstationary_slow SOURCES nonstationary_slow_test.cpp
             LIBS Eigen3::Eigen LABELS slow TIMEOUT 900)

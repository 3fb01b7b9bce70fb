if(TARGET surpass_reconstruct)
  surpass_test(unit_reconstruct SOURCES reconstruct_clouds.cpp reconstruct_test.cpp
               reconstruct_bad_clouds_test.cpp reconstruct_simplify_test.cpp
               reconstruct_parts_test.cpp
               LIBS surpass_reconstruct Eigen3::Eigen LABELS unit)
  surpass_test(reconstruct_data SOURCES reconstruct_clouds.cpp reconstruct_data_test.cpp
               LIBS surpass_reconstruct Eigen3::Eigen LABELS unit)
  surpass_test(reconstruct_slow SOURCES reconstruct_clouds.cpp reconstruct_slow_test.cpp
               LIBS surpass_reconstruct Eigen3::Eigen LABELS slow TIMEOUT 900)
endif()

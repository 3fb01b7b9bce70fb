if(SURPASS_RENDER)
  find_package(PNG REQUIRED)
  surpass_test(unit_render SOURCES render_camera_test.cpp render_cloud_test.cpp
               render_errors_test.cpp render_field_test.cpp render_image_test.cpp render_normals_test.cpp render_picture_test.cpp
               render_reflection_test.cpp render_scene_test.cpp
               LIBS surpass_render PNG::PNG Eigen3::Eigen LABELS unit)
endif()

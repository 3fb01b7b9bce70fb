if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  surpass_test(unit_program SOURCES large_blocks_test.cpp
               ${PROJECT_SOURCE_DIR}/apps/surpass/large_blocks.cpp LABELS unit)
  target_include_directories(unit_program PRIVATE ${PROJECT_SOURCE_DIR}/apps/surpass)
endif()

find_package(rapidcheck REQUIRED)
surpass_test(unit_io SOURCES io_obj.cpp io_ply.cpp io_off.cpp io_stl.cpp io_xyz.cpp io_files.cpp io_digits.cpp
             LABELS unit)
surpass_test(unit_io_roundtrip SOURCES io_roundtrip.cpp LIBS rapidcheck LABELS unit property)

# CGAL's soup reader did not come from us. The test needs CGAL's headers only.
find_package(CGAL QUIET)
if(CGAL_FOUND)
  surpass_test(unit_io_cgal SOURCES io_cgal.cpp LIBS CGAL::CGAL LABELS unit oracle)
endif()

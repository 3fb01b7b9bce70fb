# `cmake --install` and the package: find_package(surpass [COMPONENTS oracle render reconstruct])
# gives surpass::surpass, and surpass::oracle, surpass::render and surpass::reconstruct where they were
# built.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(SURPASS_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/surpass)

# One export set a component: who does not ask for pictures needs no Embree.
function(surpass_install_library target export_name)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${export_name})
  install(TARGETS ${target} EXPORT surpass-${export_name})
  install(EXPORT surpass-${export_name} NAMESPACE surpass:: DESTINATION ${SURPASS_PACKAGE_DIR})
endfunction()

set(SURPASS_ABSENT_HEADERS)
surpass_install_library(surpass surpass)
foreach(component oracle render reconstruct)
  if(TARGET surpass_${component})
    surpass_install_library(surpass_${component} ${component})
  else()
    list(APPEND SURPASS_ABSENT_HEADERS PATTERN ${component}.hpp EXCLUDE)
  endif()
endforeach()

if(TARGET surpass_oracle)  # the package has to find OpenSubdiv the same way
  install(FILES cmake/FindOpenSubdiv.cmake DESTINATION ${SURPASS_PACKAGE_DIR})
endif()

install(DIRECTORY include/surpass DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp" ${SURPASS_ABSENT_HEADERS})
install(FILES ${PROJECT_BINARY_DIR}/include/surpass/version.hpp
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/surpass)
# The frame of HTML reports, if `make web` has built it.
install(FILES ${PROJECT_SOURCE_DIR}/build/report/report.html
        DESTINATION ${CMAKE_INSTALL_DATADIR}/surpass OPTIONAL)
install(FILES LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/surpass-config.cmake.in surpass-config.cmake
                              INSTALL_DESTINATION ${SURPASS_PACKAGE_DIR})
write_basic_package_version_file(surpass-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/surpass-config.cmake
              ${PROJECT_BINARY_DIR}/surpass-config-version.cmake
        DESTINATION ${SURPASS_PACKAGE_DIR})

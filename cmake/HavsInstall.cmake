# cmake --install: the program, the libraries with their headers, and the package for find_package(havs), which gives the targets
# havs::core, havs::mesh, ... The module that opens VTK's readers is installed beside them (src/mesh/vtk).
include(CMakePackageConfigHelpers)

set(libraries havs_core havs_mesh havs_transfer havs_light havs_scene havs_sort havs_image havs_gl havs_raster havs_overlay havs_reference havs_render havs_page
              havs_study)
if(TARGET havs_glad)
  list(APPEND libraries havs_glad)
endif()
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/havs)

install(TARGETS havs)
install(TARGETS ${libraries} EXPORT havsTargets)
install(EXPORT havsTargets NAMESPACE havs:: DESTINATION ${package_dir})
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/havs FILES_MATCHING PATTERN "*.h"
        PATTERN app EXCLUDE PATTERN module EXCLUDE)
install(DIRECTORY shaders/core DESTINATION ${CMAKE_INSTALL_DATADIR}/havs/shaders)
install(FILES README.md LICENSE docs/licences.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/havsConfig.cmake.in ${PROJECT_BINARY_DIR}/havsConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/havsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/havsConfig.cmake ${PROJECT_BINARY_DIR}/havsConfigVersion.cmake
        DESTINATION ${package_dir})

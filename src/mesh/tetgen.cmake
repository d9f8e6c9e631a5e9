# TetGen's library, which is under the AGPL: -DHAVS_WITH_TETGEN=OFF builds without it.
find_path(TETGEN_INCLUDE_DIR tetgen.h REQUIRED)
find_library(TETGEN_LIBRARY tet REQUIRED)
mark_as_advanced(TETGEN_INCLUDE_DIR TETGEN_LIBRARY)

target_sources(havs_mesh PRIVATE
  tetgen.cpp
  tetgen_binary_file.cpp
  tetgen_off_reader.cpp
  tetgen_ply_reader.cpp
  tetgen_poly_reader.cpp
  tetgen_run.cpp
  tetgen_stl_reader.cpp
  tetgen_switches.cpp)
target_include_directories(havs_mesh SYSTEM PRIVATE ${TETGEN_INCLUDE_DIR})
target_link_libraries(havs_mesh PRIVATE ${TETGEN_LIBRARY})

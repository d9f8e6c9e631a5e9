# havs_library(NAME SOURCES a.cpp ... LINK havs::core ... [PRIVATE_LINK ...])
# One library a folder of src/: havs_NAME, alias havs::NAME, headers as "NAME/header.h".
function(havs_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(havs_${name} STATIC ${ARG_SOURCES})
  add_library(havs::${name} ALIAS havs_${name})
  set_target_properties(havs_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(havs_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/havs>)
  target_link_libraries(havs_${name} PUBLIC ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK} $<BUILD_INTERFACE:havs_options>)
endfunction()

# Flags every target of ours is compiled with. No contraction to fma: the same source must give
# the same bits in the shaders, in C++ and on SIMD lanes (docs/05-architecture.md).
add_library(havs_options INTERFACE)
target_compile_options(havs_options INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wold-style-cast
                       -Wno-missing-field-initializers -Wno-restrict -ffp-contract=off)

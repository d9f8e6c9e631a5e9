# havs_test(LABEL NAME SOURCES a.cpp ... LINK havs::mesh ...): one GoogleTest program, its cases found by ctest
# under the name LABEL.Suite.Case and the label LABEL (unit, gl, image, cli, hard). APART: its files use the same names,
# so each is compiled by itself, also where the preset compiles several as one.
function(havs_test label name)
  cmake_parse_arguments(ARG "APART" "" "SOURCES;LINK" ${ARGN})
  set(target test_${label}_${name})
  add_executable(${target} ${ARG_SOURCES})
  if(ARG_APART)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
  endif()
  if(NOT TARGET tests_${label})  # all programs of a label, and what they open or run
    add_custom_target(tests_${label})
    add_dependencies(tests_${label} havs)
    if(HAVS_WITH_VTK)
      add_dependencies(tests_${label} havs_vtk)
    endif()
  endif()
  add_dependencies(tests_${label} ${target})
  target_link_libraries(${target} PRIVATE ${ARG_LINK} GTest::gmock GTest::gtest_main havs_options)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${target} PRIVATE
    HAVS_MESHES="${PROJECT_SOURCE_DIR}/meshes"
    HAVS_SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data"
    HAVS_BUILD="${CMAKE_BINARY_DIR}")
  havs_precompiled_as(${target} havs_test_headers)
  set(properties LABELS ${label})
  if(HAVS_SANITIZE)
    list(APPEND properties ENVIRONMENT ${HAVS_SANITIZER_ENVIRONMENT})
  endif()
  include(GoogleTest)
  # Without values: GoogleTest prints a struct as its bytes, with addresses, so names would change with each build.
  gtest_discover_tests(${target} TEST_PREFIX ${label}.${name}. NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
                       PROPERTIES ${properties})
endfunction()

# havs_glad: the functions of OpenGL 4.5 core as pointers, written at build time by glad 2 (Debian: python3-glad) from
# the Khronos registry it carries. Its own loader is left out: each context passes its get-proc-address (src/gl/device.cpp).

# The first python3 on PATH may be another than the one that Debian installs glad for.
function(havs_python_has_glad result candidate)
  execute_process(COMMAND ${candidate} -c "import glad" RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()
find_program(HAVS_GLAD_PYTHON NAMES python3 VALIDATOR havs_python_has_glad
             DOC "A Python that can import glad 2")
if(NOT HAVS_GLAD_PYTHON)
  message(FATAL_ERROR "No python3 can import glad; install python3-glad, or set HAVS_GLAD_PYTHON to a Python that has glad 2")
endif()

set(extensions
  GL_EXT_shader_framebuffer_fetch
  GL_ARB_fragment_shader_interlock
  GL_NV_fragment_shader_interlock
  GL_KHR_debug)
list(JOIN extensions "," extensions)
set(glad_dir ${PROJECT_BINARY_DIR}/glad)
add_custom_command(
  OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h ${glad_dir}/include/KHR/khrplatform.h
  COMMAND ${HAVS_GLAD_PYTHON} -m glad --quiet --reproducible --api gl:core=4.5 --extensions ${extensions}
          --out-path ${glad_dir} c
  COMMENT "Generating the OpenGL functions with glad"
  VERBATIM)

add_library(havs_glad STATIC ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h ${glad_dir}/include/KHR/khrplatform.h)
add_library(havs::glad ALIAS havs_glad)
set_target_properties(havs_glad PROPERTIES EXPORT_NAME glad)
target_compile_options(havs_glad PRIVATE -w)
target_include_directories(havs_glad SYSTEM PUBLIC
  $<BUILD_INTERFACE:${glad_dir}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/havs>)
install(DIRECTORY ${glad_dir}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/havs)

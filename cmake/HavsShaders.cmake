# havs_embed_shaders(TARGET DIRECTORY dir FILES dir/core/a.glsl ...): compiles the text of the shaders into TARGET, each
# under its path relative to DIRECTORY, as havs::embeddedShaders() of gl/shader_source.h. Made anew when a shader changes.
# The same file, run as a script (cmake -P), writes that source; no other tool is needed.
if(CMAKE_SCRIPT_MODE_FILE)
  set(entries "")
  string(REPLACE "|" ";" names "${NAMES}")
  foreach(name IN LISTS names)
    file(READ "${DIRECTORY}/${name}" text)
    string(APPEND entries "    {\"${name}\", R\"shader(${text})shader\"},\n")
  endforeach()
  file(WRITE "${OUTPUT}" "// Written by cmake/HavsShaders.cmake.
#include \"gl/shader_source.h\"

namespace havs {
namespace {
constexpr EmbeddedShader kShaders[] = {
${entries}};
}  // namespace
std::span<const EmbeddedShader> embeddedShaders() { return kShaders; }
}  // namespace havs
")
  return()
endif()

set(havs_embed_script ${CMAKE_CURRENT_LIST_FILE})
function(havs_embed_shaders target)
  cmake_parse_arguments(ARG "" "DIRECTORY" "FILES" ${ARGN})
  set(names "")
  foreach(file IN LISTS ARG_FILES)
    file(RELATIVE_PATH name ${ARG_DIRECTORY} ${file})
    list(APPEND names ${name})
  endforeach()
  list(JOIN names "|" names)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DDIRECTORY=${ARG_DIRECTORY} -DNAMES=${names} -DOUTPUT=${output} -P ${havs_embed_script}
    DEPENDS ${ARG_FILES} ${havs_embed_script}
    COMMENT "Embedding the shaders of ${target}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()

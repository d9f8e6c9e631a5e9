# havs_embed_page(TARGET FOLDER dir): puts the study's page together from the files of FOLDER and Vega, and embeds it into
# TARGET as havs::pageShell() of study/page_shell.h. Made anew when one of the files changes.
# The same file, run as a script (cmake -P), joins them; no other tool is needed.
set(vega_parts util time format loader dataflow expression event-selector statistics scale canvas scenegraph selection
    functions runtime encode transforms view-transforms label view parser interpreter)  # each after what it is built on
set(page_scripts words study elements plot front tables axes fits effects run main)              # one scope, in this order

if(CMAKE_SCRIPT_MODE_FILE)
  # Debian carries Vega as one file a part, each a CommonJS module.
  set(vega "const vega = (() => { const modules = {};\n")
  foreach(part IN LISTS vega_parts)
    file(READ "${VEGA}/vega-${part}.min.js" text)
    string(REGEX REPLACE "\n//# sourceMappingURL=[^\n]*" "" text "${text}")
    string(REPLACE "vega-selection" "vega-selections" name "vega-${part}")  # the name that the others ask for
    string(APPEND vega "((exports, module, require) => {${text}\n})(modules['${name}'] = {}, {}, name => modules[name]);\n")
  endforeach()
  string(APPEND vega "return modules; })();\n")
  set(scripts "")
  foreach(script IN LISTS page_scripts)
    file(READ "${FOLDER}/${script}.js" text)
    string(APPEND scripts "${text}\n")
  endforeach()
  foreach(text IN ITEMS "${vega}" "${scripts}")
    if(text MATCHES "</script|<!--")
      message(FATAL_ERROR "a script holds '${CMAKE_MATCH_0}', which HTML would read as its own")
    endif()
  endforeach()
  file(READ "${FOLDER}/style.css" style)
  file(READ "${FOLDER}/vega-licences.txt" licences)
  file(READ "${FOLDER}/template.html" page)
  string(REPLACE "<!--HAVS:STYLE-->" "${style}" page "${page}")
  string(REPLACE "<!--HAVS:LICENCES-->" "${licences}" page "${page}")
  string(REPLACE "<!--HAVS:VEGA-->" "${vega}" page "${page}")
  string(REPLACE "<!--HAVS:SCRIPTS-->" "${scripts}" page "${page}")
  file(WRITE "${OUTPUT}" "${page}")
  return()
endif()

set(havs_page_script ${CMAKE_CURRENT_LIST_FILE})
function(havs_embed_page target)
  cmake_parse_arguments(ARG "" "FOLDER" "" ${ARGN})
  find_path(HAVS_VEGA_FOLDER vega-view.min.js PATHS /usr/share/javascript/vega
            DOC "The folder of Vega's parts, vega-*.min.js, as Debian's libjs-vega installs them")
  mark_as_advanced(HAVS_VEGA_FOLDER)
  if(NOT HAVS_VEGA_FOLDER)
    message(FATAL_ERROR "Vega, which draws the plots of the study's page, is missing: install libjs-vega, set "
                        "HAVS_VEGA_FOLDER, or leave the page out with -DHAVS_WITH_REPORT=OFF")
  endif()
  set(inputs ${ARG_FOLDER}/template.html ${ARG_FOLDER}/style.css ${ARG_FOLDER}/vega-licences.txt)
  foreach(script IN LISTS page_scripts)
    list(APPEND inputs ${ARG_FOLDER}/${script}.js)
  endforeach()
  foreach(part IN LISTS vega_parts)
    list(APPEND inputs ${HAVS_VEGA_FOLDER}/vega-${part}.min.js)
  endforeach()
  set(HAVS_PAGE_SHELL ${CMAKE_CURRENT_BINARY_DIR}/page_shell.html)
  add_custom_command(
    OUTPUT ${HAVS_PAGE_SHELL}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${ARG_FOLDER} -DVEGA=${HAVS_VEGA_FOLDER} -DOUTPUT=${HAVS_PAGE_SHELL} -P ${havs_page_script}
    DEPENDS ${inputs} ${havs_page_script}
    COMMENT "Putting the study's page together"
    VERBATIM)
  configure_file(${ARG_FOLDER}/page_shell.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/page_shell.cpp @ONLY)
  set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/page_shell.cpp PROPERTIES OBJECT_DEPENDS ${HAVS_PAGE_SHELL})
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/page_shell.cpp ${HAVS_PAGE_SHELL})
endfunction()

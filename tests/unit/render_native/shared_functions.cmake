# cmake -DNM=nm -DOBJECTS=a.o|b.o -P shared_functions.cmake
# Objects compiled for more than the plainest processor must define no function that other objects define, too (weak in
# nm's list, as inline functions are): the linker keeps one of them for all, and might keep theirs.
string(REPLACE "|" ";" objects "${OBJECTS}")
execute_process(COMMAND ${NM} -C --defined-only ${objects} OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${NM} failed")
endif()
string(REGEX MATCHALL "[^\n]* T [^\n]*" own "${symbols}")
if(NOT own)
  message(FATAL_ERROR "no function found in ${OBJECTS}")
endif()
string(REGEX MATCHALL "[^\n]* [Wu] [^\n]*" shared "${symbols}")
if(shared)
  list(JOIN shared "\n" shared)
  message(FATAL_ERROR "functions that the linker may keep for other objects:\n${shared}")
endif()

# Installs the build into a folder of its own, builds the consumer against it and lets both it and the installed program run.
# -DBUILD=..., -DSOURCE=..., -DWORK=..., -DWITH_VTK=ON|OFF, -DCXX_FLAGS=...
foreach(name IN ITEMS BUILD SOURCE WORK)
  if(NOT DEFINED ${name})
    message(FATAL_ERROR "-D${name}=... is missing")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${status}:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

file(WRITE ${WORK}/one.node "4 3 1 0\n0 0 0 0 0\n1 1 0 0 1\n2 0 1 0 0\n3 0 0 1 0\n")
file(WRITE ${WORK}/one.ele "1 4 0\n0 0 1 2 3\n")
run(${prefix}/bin/havs info ${WORK}/one.node)
run(${prefix}/bin/havs mesh ${WORK}/one.node -o ${WORK}/copy.node)
if(WITH_VTK)
  run(${prefix}/bin/havs mesh ${WORK}/one.node -o ${WORK}/copy.vtu)
  run(${prefix}/bin/havs info ${WORK}/copy.vtu)
endif()

run(${CMAKE_COMMAND} -S ${SOURCE}/tests/cli/consumer -B ${WORK}/consumer -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=${CXX_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/consumer ${WORK}/one.node ${WORK}/one.png)
if(NOT EXISTS ${WORK}/one.png)
  message(FATAL_ERROR "the consumer wrote no picture")
endif()
file(REMOVE_RECURSE ${WORK})

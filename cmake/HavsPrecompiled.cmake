# Headers that take seconds to read are read once: they are most of what the command line and the tests take to build.
# ccache keeps what was compiled with them only when told that it may.
if(CCACHE AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

# havs_precompiled(TARGET HEADER...): by TARGET's own flags.
function(havs_precompiled target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess -Winvalid-pch>)
endfunction()

# havs_precompiled_as(TARGET OTHER): those of OTHER, whose flags must be the same but for definitions that its headers do
# not look at.
function(havs_precompiled_as target other)
  target_precompile_headers(${target} REUSE_FROM ${other})
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess -Winvalid-pch>)
endfunction()

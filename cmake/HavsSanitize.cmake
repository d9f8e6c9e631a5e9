# -DHAVS_SANITIZE=address,leak (or undefined, thread, ...): everything is built under these sanitizers; see CMakePresets.json.
set(HAVS_SANITIZE "" CACHE STRING "Sanitizers, separated by commas; empty: none")
if(HAVS_SANITIZE)
  add_compile_options(-fsanitize=${HAVS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
                      -Wno-maybe-uninitialized)  # g++ 12 warns falsely in instrumented code
  add_link_options(-fsanitize=${HAVS_SANITIZE})
endif()

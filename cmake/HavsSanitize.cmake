# -DHAVS_SANITIZE=address,leak (or undefined, thread, ...): everything is built under these sanitizers; see CMakePresets.json.
set(HAVS_SANITIZE "" CACHE STRING "Sanitizers, separated by commas; empty: none")
if(HAVS_SANITIZE)
  add_compile_options(-fsanitize=${HAVS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
                      -Wno-maybe-uninitialized)  # g++ 12 warns falsely in instrumented code
  add_link_options(-fsanitize=${HAVS_SANITIZE})
  # Of every test. What is suppressed lies in libraries that are not ours; the files say why.
  set(support ${PROJECT_SOURCE_DIR}/tests/support)
  if(HAVS_SANITIZE MATCHES thread)
    set(HAVS_SANITIZER_ENVIRONMENT "TSAN_OPTIONS=suppressions='${support}/tsan.supp':print_suppressions=0")
  else()
    set(HAVS_SANITIZER_ENVIRONMENT "LSAN_OPTIONS=suppressions='${support}/lsan.supp':print_suppressions=0")
    # g++ 12's leak sanitizer mistakes a library's thread-local block that lies 16 bytes into a page for one of glibc 2.19
    # and dies where it thinks that it ends; so it is told not to look.
    string(APPEND HAVS_SANITIZER_ENVIRONMENT ":intercept_tls_get_addr=0")
  endif()
endif()

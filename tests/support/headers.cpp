// Nothing: there only to have the precompiled headers of the tests (tests/CMakeLists.txt).

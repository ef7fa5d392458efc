# One test that installs the build and uses it from outside; see check_install.cmake.
# Sanitizers in the libraries would force themselves on the consumer, so such a build has no test.

string(FIND "${CMAKE_CXX_FLAGS}" "-fsanitize" sanitized)
if(sanitized EQUAL -1)
  add_test(NAME install_test COMMAND ${CMAKE_COMMAND}
    -D BUILD=${PROJECT_BINARY_DIR} -D CONFIG=$<CONFIG> -D SOURCE=${PROJECT_SOURCE_DIR}
    -D SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/install -D VERSION=${PROJECT_VERSION}
    -D CXX=${CMAKE_CXX_COMPILER} -D GENERATOR=${CMAKE_GENERATOR} -D LIBDIR=${CMAKE_INSTALL_LIBDIR}
    -D HELPER=$<TARGET_EXISTS:lepp-gmsh>
    -P ${CMAKE_CURRENT_SOURCE_DIR}/install/check_install.cmake)
  set_tests_properties(install_test PROPERTIES LABELS install TIMEOUT 300)
endif()

# Installs a build tree, moves what was installed, and uses it from there: the program, then its
# consumers by find_package() and by pkg-config. Any failure is a fatal error.

cmake_minimum_required(VERSION 3.25)
set(first ${SCRATCH}/first)
set(prefix ${SCRATCH}/prefix)
set(geometry ${SOURCE}/meshes/valid/annulus.geo)

# run(command...): it must succeed; leaves what it printed in `output`.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${out}${err}")
  endif()
  set(output "${out}${err}" PARENT_SCOPE)
endfunction()

# refuse(what text): the text names no package that is our own affair, and none of our flags.
function(refuse what text)
  foreach(path ${SCRATCH} ${SOURCE} ${BUILD})
    string(REPLACE ${path} "" text "${text}")
  endforeach()
  string(REGEX MATCH "gmsh\\.|-lgmsh|libgmsh|fmt|boost|nlohmann|CLI11|-Wall|-Wextra|-Wconversion|-ffp"
    found "${text}")
  if(found)
    message(FATAL_ERROR "${what} has \"${found}\":\n${text}")
  endif()
endfunction()

# run_consumers(folder): runs the programs in it, and looks at what they were linked with.
function(run_consumers folder)
  run(${folder}/core_consumer)
  message(STATUS "core_consumer: ${output}")
  if(EXISTS ${folder}/adaptive_loop)  # where Eigen is installed
    run(${folder}/adaptive_loop)
    message(STATUS "adaptive_loop: ${output}")
  endif()
  if(HELPER)
    run(${folder}/io_consumer ${geometry} ${prefix}/libexec/lepp/lepp-gmsh ${folder})
  endif()
  foreach(consumer core_consumer io_consumer)
    run(ldd ${folder}/${consumer})
    refuse("ldd ${consumer}" "${output}")
  endforeach()
endfunction()

# Like a user's own shell: none of the flags that this build may have been given.
foreach(name CXXFLAGS LDFLAGS CPPFLAGS LD_LIBRARY_PATH LEPP_GMSH)
  unset(ENV{${name}})
endforeach()
file(REMOVE_RECURSE ${SCRATCH})

# ---- install, and move --------------------------------------------------------------------------
run(${CMAKE_COMMAND} --install ${BUILD} --config "${CONFIG}" --prefix ${first})
file(RENAME ${first} ${prefix})

# ---- headers: nothing private, and no package but in the two adaptors ---------------------------
file(GLOB_RECURSE headers ${prefix}/include/*)
foreach(header ${headers})
  if(NOT header MATCHES "/(dual_graph_bgl|transfer_matrix)\\.hpp$")
    file(STRINGS ${header} includes REGEX "^#include <(gmsh|fmt|boost|nlohmann|CLI|Eigen)")
    if(includes)
      message(FATAL_ERROR "${header} needs a package: ${includes}")
    endif()
  endif()
endforeach()

# ---- the program, without any environment -------------------------------------------------------
run(env -i ${prefix}/bin/lepp --version)
if(NOT output MATCHES "${VERSION}")
  message(FATAL_ERROR "lepp --version says ${output}, not ${VERSION}")
endif()
if(HELPER)
  run(env -i PATH=/usr/bin:/bin ${prefix}/bin/lepp mesh ${geometry} -o ${SCRATCH}/annulus.msh)
endif()

# ---- find_package -------------------------------------------------------------------------------
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${SCRATCH}/by_cmake -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${SCRATCH}/by_cmake --verbose --parallel 2)
refuse("the build of the consumers" "${output}")
run_consumers(${SCRATCH}/by_cmake)
file(READ ${SCRATCH}/by_cmake/gmsh_helper.txt helper)
if(HELPER AND NOT helper STREQUAL "${prefix}/libexec/lepp/lepp-gmsh")
  message(FATAL_ERROR "lepp_GMSH_HELPER is \"${helper}\"")
endif()

# ---- pkg-config ---------------------------------------------------------------------------------
set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
file(MAKE_DIRECTORY ${SCRATCH}/by_pkg_config)
foreach(pair core:lepp io:lepp-io)
  string(REGEX MATCH "(.+):(.+)" ignored ${pair})
  set(program ${CMAKE_MATCH_1}_consumer)
  run(pkg-config --cflags --libs "${CMAKE_MATCH_2} >= 0.1")
  refuse("pkg-config ${CMAKE_MATCH_2}" "${output}")
  separate_arguments(flags UNIX_COMMAND "${output}")
  run(${CXX} -std=c++20 -O1 ${CMAKE_CURRENT_LIST_DIR}/consumer/${program}.cpp ${flags}
    -o ${SCRATCH}/by_pkg_config/${program})
endforeach()
execute_process(COMMAND pkg-config --exists eigen3 RESULT_VARIABLE no_eigen)
if(NOT no_eigen)
  run(pkg-config --cflags --libs lepp eigen3)
  separate_arguments(flags UNIX_COMMAND "${output}")
  run(${CXX} -std=c++20 -O0 ${CMAKE_CURRENT_LIST_DIR}/consumer/adaptive_loop.cpp ${flags}
    -o ${SCRATCH}/by_pkg_config/adaptive_loop)
endif()
set(ENV{LD_LIBRARY_PATH} ${prefix}/${LIBDIR})  # pkg-config sets no run path to shared libraries
run_consumers(${SCRATCH}/by_pkg_config)

# ---- versions: 0.1.x is what 0.1 asked for, nothing else is -------------------------------------
function(check_version wanted expected)
  string(REPLACE "." ";" parts ${wanted})
  list(GET parts 0 PACKAGE_FIND_VERSION_MAJOR)
  list(GET parts 1 PACKAGE_FIND_VERSION_MINOR)
  set(PACKAGE_FIND_VERSION ${wanted})
  set(PACKAGE_VERSION_COMPATIBLE FALSE)
  include(${prefix}/${LIBDIR}/cmake/lepp/leppConfigVersion.cmake)
  if((PACKAGE_VERSION_COMPATIBLE AND NOT expected) OR (expected AND NOT PACKAGE_VERSION_COMPATIBLE))
    message(FATAL_ERROR "find_package(lepp ${wanted}) accepts: ${PACKAGE_VERSION_COMPATIBLE}")
  endif()
endfunction()
check_version(0.1 TRUE)
check_version(0.0 FALSE)
check_version(0.2 FALSE)
check_version(1.0 FALSE)

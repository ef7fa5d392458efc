# The same sources three times: as the project is built, without optimisation, and by clang. Only
# what the test needs, and in one step per compiler and file, so that it costs about a minute.

set(folder ${CMAKE_CURRENT_LIST_DIR})
set(own ${folder}/hashes.cpp ${CMAKE_CURRENT_SOURCE_DIR}/bench/families.cpp)

add_executable(determinism_hashes ${own})
target_include_directories(determinism_hashes PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_options(determinism_hashes PRIVATE -ffp-contract=off)
target_link_libraries(determinism_hashes PRIVATE lepp::io)

get_target_property(sources lepp_core SOURCES)
list(FILTER sources EXCLUDE REGEX "voronoi/|nonobtuse/")
foreach(name atomic_files boundary_loops entity_table line_reader msh msh_entities places poly_read
        poly_write input_file text_file)
  list(APPEND sources lepp/io/${name}.cpp)
endforeach()
list(TRANSFORM sources PREPEND ${PROJECT_SOURCE_DIR}/lib/)
set(includes ${PROJECT_SOURCE_DIR}/lib ${PROJECT_BINARY_DIR}/lib/generated
             ${CMAKE_CURRENT_SOURCE_DIR})

add_executable(determinism_hashes_O0 ${own} ${sources})
target_include_directories(determinism_hashes_O0 PRIVATE ${includes})
target_include_directories(determinism_hashes_O0 SYSTEM PRIVATE ${Boost_INCLUDE_DIRS})
target_compile_options(determinism_hashes_O0 PRIVATE -O0 -g0 -ffp-contract=off)
set(programs $<TARGET_FILE:determinism_hashes> $<TARGET_FILE:determinism_hashes_O0>)

# Another compiler than the project's own; it is called directly, as a project has only one.
find_program(LEPP_CLANG clang++-14 DOC "A clang++ for the determinism test; none: it does without")
if(LEPP_CLANG AND NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  list(TRANSFORM includes PREPEND -I OUTPUT_VARIABLE include_flags)
  set(objects)
  foreach(source ${own} ${sources})
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${source})
    string(REPLACE "/" "_" name ${name})
    set(object ${CMAKE_CURRENT_BINARY_DIR}/clang_O2/${name}.o)
    add_custom_command(OUTPUT ${object}
      COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${LEPP_CLANG} -std=c++20 -O2 -ffp-contract=off
              ${include_flags} -MD -MT ${object} -MF ${object}.d -c ${source} -o ${object}
      DEPENDS ${source} DEPFILE ${object}.d COMMENT "clang -O2: ${name}" VERBATIM)
    list(APPEND objects ${object})
  endforeach()
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/clang_O2)
  set(program ${CMAKE_CURRENT_BINARY_DIR}/clang_O2/determinism_hashes)
  add_custom_command(OUTPUT ${program}
    COMMAND ${LEPP_CLANG} ${objects} -o ${program} DEPENDS ${objects} VERBATIM)
  add_custom_target(determinism_hashes_clang ALL DEPENDS ${program})
  list(APPEND programs ${program})
endif()

file(GLOB inputs ${CMAKE_CURRENT_SOURCE_DIR}/regression/*.poly)
list(SORT inputs)
add_test(NAME determinism COMMAND ${CMAKE_COMMAND} "-DPROGRAMS=${programs}" "-DINPUTS=${inputs}"
  -DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/determinism -P ${folder}/compare.cmake)
set_tests_properties(determinism PROPERTIES LABELS io TIMEOUT 300)

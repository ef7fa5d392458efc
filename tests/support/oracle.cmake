# What the tests against the oracle, the stress program and the fuzz targets share.
add_library(lepp_test_oracle STATIC
  ${CMAKE_CURRENT_LIST_DIR}/gen_pslg.cpp
  ${CMAKE_CURRENT_LIST_DIR}/invariants.cpp
  ${CMAKE_CURRENT_LIST_DIR}/invariants_promise.cpp
  ${CMAKE_CURRENT_LIST_DIR}/invariants_split.cpp
  ${CMAKE_CURRENT_LIST_DIR}/mesh_edges.cpp
  ${CMAKE_CURRENT_LIST_DIR}/oracle.cpp
  ${CMAKE_CURRENT_LIST_DIR}/oracle_arrangement.cpp
  ${CMAKE_CURRENT_LIST_DIR}/oracle_cases.cpp
  ${CMAKE_CURRENT_LIST_DIR}/oracle_cdt.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plain/constrained_delaunay.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plain/delaunay.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plain/extract_regions.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plain/regions.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plain/segments.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trial.cpp)
find_package(Boost 1.74 REQUIRED)
target_include_directories(lepp_test_oracle PUBLIC ${CMAKE_CURRENT_LIST_DIR}/..)
target_include_directories(lepp_test_oracle SYSTEM PRIVATE ${Boost_INCLUDE_DIRS})
target_link_libraries(lepp_test_oracle PUBLIC lepp::core)
target_compile_options(lepp_test_oracle PRIVATE -ffp-contract=off)

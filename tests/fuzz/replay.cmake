# Any compiler: the corpus, and inputs that once broke something, as a test.
add_executable(fuzz_replay
  ${CMAKE_CURRENT_LIST_DIR}/poly_reader.cpp
  ${CMAKE_CURRENT_LIST_DIR}/pslg_to_cdt.cpp
  ${CMAKE_CURRENT_LIST_DIR}/replay_main.cpp)
target_link_libraries(fuzz_replay PRIVATE lepp_test_oracle lepp::io)
foreach(target pslg_to_cdt poly_reader)
  add_test(NAME replay_${target}
    COMMAND fuzz_replay ${target} ${CMAKE_CURRENT_LIST_DIR}/corpus/${target})
  set_tests_properties(replay_${target} PROPERTIES LABELS io TIMEOUT 120)
endforeach()

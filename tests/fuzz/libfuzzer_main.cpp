// What libFuzzer calls; LEPP_FUZZ_TARGET is the function of target.hpp to run.

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lepp::test::LEPP_FUZZ_TARGET({data, size});
  return 0;
}

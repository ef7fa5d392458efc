#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
#include <cstdio>

#include "support/real_inputs.hpp"

int main(int argc, char** argv) {
  doctest::Context context(argc, argv);
  const int status = context.run();
  if (lepp::test::skipped_files() > 0) {
    std::printf("skipped %zu real input files: LEPP_TEST_DATA is not set\n",
                lepp::test::skipped_files());
  }
  return status;
}

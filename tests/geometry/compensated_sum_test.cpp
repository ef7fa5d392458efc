#include "lepp/geometry/compensated_sum.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace lepp;

TEST_CASE("a compensated sum keeps terms that a plain sum loses") {
  CompensatedSum sum;
  for (const double term : {1.0, 1e100, 1.0, -1e100}) sum.add(term);
  CHECK(sum.value() == 2);
}

TEST_CASE("a million tenths make a hundred thousand") {
  CompensatedSum sum;
  double plain = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    sum.add(0.1);
    plain += 0.1;
  }
  CHECK(sum.value() == 100'000);
  CHECK(plain != 100'000);
}

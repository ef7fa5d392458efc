#include <doctest/doctest.h>

#include "lepp/geometry/predicates.hpp"
#include "support/oracle.hpp"
#include "support/oracle_cases.hpp"
#include "support/sanitized.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("the integer oracle equals rational numbers, with and without its filter") {
  int degenerate = 0;
  for (std::uint64_t seed = 0; seed < cases(20'000); ++seed) {
    CAPTURE(seed);
    const auto [a, b, c, d] = predicate_case(seed);
    const int turn = rational_orient2d(a, b, c), inside = rational_incircle(a, b, c, d);
    REQUIRE(exact_orient2d(a, b, c) == turn);
    REQUIRE(oracle_orient2d(a, b, c) == turn);
    REQUIRE(exact_incircle(a, b, c, d) == inside);
    REQUIRE(oracle_incircle(a, b, c, d) == inside);
    REQUIRE(exact_dot_sign(a, b, c) == rational_dot_sign(a, b, c));
    REQUIRE(oracle_dot_sign(a, b, c) == rational_dot_sign(a, b, c));
    if (inside == 0 || turn == 0) ++degenerate;
  }
  CHECK(degenerate > static_cast<int>(cases(20'000) / 8));  // the cases are as hard as they claim
}

TEST_CASE("predicates equal the oracle on a million cases, most of them near-degenerate") {
  constexpr std::uint64_t first = 1'000'000'007;
  for (std::uint64_t i = 0; i < cases(1'000'000); ++i) {
    const auto difference = predicate_difference(first + i);
    REQUIRE_MESSAGE(!difference, *difference);
  }
}

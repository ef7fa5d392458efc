#include "lepp/geometry/pslg.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "support/shapes.hpp"

using namespace lepp;

namespace {

std::vector<std::string> broken_rules(const Pslg& pslg) {
  std::vector<std::string> rules;
  for (const PslgViolation& violation : validate(pslg)) rules.push_back(violation.rule);
  return rules;
}

using Rules = std::vector<std::string>;

}  // namespace

TEST_CASE("a clean PSLG breaks no rule") {
  CHECK(broken_rules(test::unit_square()).empty());
  CHECK(broken_rules(test::example_1()).empty());
}

TEST_CASE("P1: coordinates are finite and in the supported range") {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e300, 5e-324, -1e-310}) {
    CAPTURE(bad);
    Pslg pslg = test::unit_square();
    pslg.points[2].x = bad;
    CHECK(broken_rules(pslg) == Rules{"P1"});
    CHECK_THROWS_AS(check_ids_and_range(pslg), InputError);
  }
}

TEST_CASE("P2: segments name points and curves that exist") {
  Pslg pslg = test::unit_square();
  pslg.segments[1].b = VertexId(17U);
  CHECK(broken_rules(pslg) == Rules{"P2"});
  pslg = test::unit_square();
  pslg.segments[1].curve = CurveId(3U);
  CHECK(broken_rules(pslg) == Rules{"P2"});
}

TEST_CASE("P3: equal points are duplicates") {
  Pslg pslg = test::unit_square();
  pslg.points.push_back({1, 1});
  const auto rules = broken_rules(pslg);
  CHECK(std::ranges::count(rules, "P3") == 1);
}

TEST_CASE("P4: segments meet only at shared ends") {
  SUBCASE("crossing") {
    Pslg pslg = test::unit_square();
    test::add_chain(pslg, {{0.5, -1}, {0.5, 0.5}}, false);
    CHECK(broken_rules(pslg) == Rules{"P4"});
  }
  SUBCASE("touching") {
    Pslg pslg = test::unit_square();
    test::add_chain(pslg, {{0.5, 0}, {0.5, 0.5}}, false);
    CHECK(broken_rules(pslg) == Rules{"P4"});
  }
  SUBCASE("overlapping") {
    Pslg pslg = test::unit_square();
    test::add_chain(pslg, {{0.25, 0}, {2, 0}}, false);
    const auto rules = broken_rules(pslg);
    CHECK(std::ranges::count(rules, "P4") == static_cast<long>(rules.size()));
    CHECK_FALSE(rules.empty());
  }
  SUBCASE("a lone point on a segment") {
    Pslg pslg = test::unit_square();
    pslg.points.push_back({0.5, 0});
    CHECK(broken_rules(pslg) == Rules{"P4"});
  }
}

TEST_CASE("arrays become a PSLG whose equal tags are one curve") {
  const double coordinates[] = {0, 0, 1, 0, 0, 1};
  const std::uint32_t segments[] = {0, 1, 1, 2, 2, 0};
  const int tags[] = {7, 0, 7};
  const Pslg pslg = pslg_from_arrays(coordinates, segments, tags);
  CHECK(pslg.points.size() == 3);
  REQUIRE(pslg.entities.curves.size() == 1);
  CHECK(pslg.entities.curves[0].tag == 7);
  CHECK(pslg.segments[0].curve == pslg.segments[2].curve);
  CHECK_FALSE(pslg.segments[1].curve);
}

TEST_CASE("arrays of the wrong length, and indices out of range, are refused") {
  const double odd[] = {0, 0, 1};
  CHECK_THROWS_AS(pslg_from_arrays(odd, {}), InputError);
  const double coordinates[] = {0, 0, 1, 0, 0, 1};
  const std::uint32_t three[] = {0, 1, 2};
  CHECK_THROWS_AS(pslg_from_arrays(coordinates, three), InputError);
  const std::uint32_t out_of_range[] = {0, 3};
  CHECK_THROWS_AS(pslg_from_arrays(coordinates, out_of_range), InputError);
  const std::uint32_t one[] = {0, 1};
  const int two_tags[] = {1, 2};
  CHECK_THROWS_AS(pslg_from_arrays(coordinates, one, two_tags), InputError);
}

#include "lepp/geometry/segment_meetings.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "support/hard_pslgs.hpp"
#include "support/plain_meetings.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

Pslg separate(const std::vector<std::pair<Point, Point>>& pieces) {
  Pslg pslg;
  for (const auto& [a, b] : pieces) test::add_chain(pslg, {a, b}, false);
  return pslg;
}

}  // namespace

TEST_CASE("what is found equals what comparing each pair with each finds") {
  const unsigned seed = 20263;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::size_t pairs = 0;
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    const Pslg pslg = test::hard_pslg(random, 60, 80);
    const SegmentMeetings found = find_segment_meetings(pslg), plain = test::plain_meetings(pslg);
    REQUIRE(found.pairs == plain.pairs);
    REQUIRE(found.points_on_segments == plain.points_on_segments);
    REQUIRE(found.repeated_segments == plain.repeated_segments);
    REQUIRE(found.zero_length == plain.zero_length);
    REQUIRE(found.duplicate_points == plain.duplicate_points);
    REQUIRE(found.none() == validate(pslg).empty());
    pairs += found.pairs.size();
  }
  CHECK(pairs > 1'500);
}

TEST_CASE("a fan of many spokes: only those of one direction meet") {
  Pslg pslg;
  pslg.points.push_back({0.1, 0.2});
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 1000;
    pslg.points.push_back(Point{0.1, 0.2} + Point{std::cos(angle), std::sin(angle)});
  }
  for (std::uint32_t i = 1; i <= 1000; ++i) {
    pslg.segments.push_back({VertexId(0U), VertexId(i), {}, 0, 1});
  }
  CHECK(find_segment_meetings(pslg).none());
  pslg.points.push_back({1.1, 1.2});  // 45 degrees, where a slope can round to either side of 1
  pslg.points.push_back({2.1, 2.2});
  pslg.segments.push_back({VertexId(1001U), VertexId(0U), {}, 0, 1});
  pslg.segments.push_back({VertexId(0U), VertexId(1002U), {}, 0, 1});
  const SegmentMeetings found = find_segment_meetings(pslg);
  CHECK(found.pairs == test::plain_meetings(pslg).pairs);
}

TEST_CASE("long segments side by side cost no more than short ones") {
  std::vector<std::pair<Point, Point>> upright, slanted;
  for (int i = 0; i < 100'000; ++i) {  // comparing each with each would reach the time limit
    upright.push_back({{1.0 * i, 0}, {1.0 * i, 1e5}});
    slanted.push_back({{1e-6 * i, 0}, {1 + 1e-6 * i, 1}});
  }
  for (const auto& pieces : {upright, slanted}) {
    const Pslg pslg = separate(pieces);
    CHECK(find_segment_meetings(pslg).none());
  }
}

TEST_CASE("examining a PSLG gives its violations and its meetings, unless ids are broken") {
  Pslg pslg = separate({{{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}});
  const PslgFindings found = examine(pslg);
  REQUIRE(found.meetings);
  CHECK(found.meetings->pairs == find_segment_meetings(pslg).pairs);
  REQUIRE(found.violations.size() == 1);
  CHECK(found.violations[0].rule == "P4");
  pslg.segments[0].b = VertexId(9U);
  CHECK_FALSE(examine(pslg).meetings);
  CHECK(examine(pslg).violations.at(0).rule == "P2");
}

TEST_CASE("a pair is named once, with a point that both have in common") {
  const Pslg pslg = separate({{{0, 0}, {4, 0}}, {{2, -1}, {2, 1}}, {{3, 0}, {6, 0}}});
  const SegmentMeetings found = find_segment_meetings(pslg);
  REQUIRE(found.pairs.size() == 2);
  CHECK(found.pairs[0] == SegmentPair{SegmentId(0U), SegmentId(1U), SegmentMeeting::crossing});
  CHECK(found.pairs[1] == SegmentPair{SegmentId(0U), SegmentId(2U), SegmentMeeting::overlapping});
  CHECK(meeting_point(pslg, found.pairs[0]) == Point{2, 0});
  CHECK(meeting_point(pslg, found.pairs[1]) == Point{3, 0});
}

TEST_CASE("copies of points and segments are listed apart, and compared only once") {
  Pslg pslg = test::unit_square();
  pslg.points.push_back({1, 1});                                    // 4, a copy of 2
  pslg.segments.push_back({VertexId(4U), VertexId(1U), {}, 0, 1});  // repeats 1
  pslg.segments.push_back({VertexId(4U), VertexId(2U), {}, 0, 1});  // no length
  test::add_chain(pslg, {{0.5, 0.5}, {2, 0.5}}, false);             // crosses 1 and its copy
  const SegmentMeetings found = find_segment_meetings(pslg);
  CHECK(found.duplicate_points == std::vector{std::pair(VertexId(2U), VertexId(4U))});
  CHECK(found.repeated_segments == std::vector{std::pair(SegmentId(1U), SegmentId(4U))});
  CHECK(found.zero_length == std::vector{SegmentId(5U)});
  CHECK(found.pairs.size() == 1);
  CHECK_FALSE(found.none());
}

TEST_CASE("too many meetings are refused: pairs and points on segments together, each once") {
  Pslg pslg;  // 4 nested segments through 10 points, a grid of 5 x 5 lines beside them
  for (int i = 0; i < 10; ++i) pslg.points.push_back({1.0 * i, 0.5 * i});
  for (int i = 1; i <= 4; ++i) test::add_chain(pslg, {{-2.0 * i, -1.0 * i}, {10.0, 5.0}}, false);
  for (int i = 0; i < 5; ++i) {
    test::add_chain(pslg, {{100.0 + i, 0}, {100.0 + i, 9}}, false);
    test::add_chain(pslg, {{99, 1.0 + i}, {109, 1.0 + i}}, false);
  }
  const SegmentMeetings found = find_segment_meetings(pslg, 71);
  CHECK(found.points_on_segments.size() == 40);
  CHECK(found.pairs.size() == 6 + 25);
  CHECK_THROWS_AS(find_segment_meetings(pslg, 70), RefusedError);
  CHECK_THROWS_AS(find_segment_meetings(pslg, 2), RefusedError);
}

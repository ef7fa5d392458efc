#include "lepp/geometry/segment_intersection.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace lepp;

TEST_CASE("every way in which two segments can meet is told apart") {
  const Point a{0, 0}, b{4, 0};
  CHECK(segments_meet(a, b, {0, 1}, {4, 1}) == SegmentMeeting::apart);
  CHECK(segments_meet(a, b, {5, 0}, {6, 0}) == SegmentMeeting::apart);
  CHECK(segments_meet(a, b, {4, 0}, {5, 1}) == SegmentMeeting::at_shared_end);
  CHECK(segments_meet(a, b, {4, 0}, {6, 0}) == SegmentMeeting::at_shared_end);
  CHECK(segments_meet(a, b, {2, 0}, {3, 1}) == SegmentMeeting::touching);
  CHECK(segments_meet(a, b, {2, -1}, {2, 1}) == SegmentMeeting::crossing);
  CHECK(segments_meet(a, b, {3, 0}, {6, 0}) == SegmentMeeting::overlapping);
  CHECK(segments_meet(a, b, {4, 0}, {0, 0}) == SegmentMeeting::overlapping);
  CHECK(segments_meet(a, b, {1, 0}, {2, 0}) == SegmentMeeting::overlapping);
}

TEST_CASE("a miss by one ulp is a miss") {
  const Point a{0, 0}, b{4, 0};
  CHECK(segments_meet(a, b, {2, std::nextafter(0.0, 1) * 0x1p+950}, {3, 1}) ==
        SegmentMeeting::apart);
}

TEST_CASE("the crossing point lies within rounding of both lines") {
  const Point p = crossing_point({0, 0}, {1, 1}, {0, 1}, {1, 0});
  CHECK(p == Point{0.5, 0.5});
  const Point q = crossing_point({1e7, 1e7}, {1e7 + 3, 1e7 + 1}, {1e7, 1e7 + 1}, {1e7 + 3, 1e7});
  CHECK(q.x == doctest::Approx(1e7 + 1.5).epsilon(1e-15));
  CHECK(q.y == doctest::Approx(1e7 + 0.5).epsilon(1e-15));
}

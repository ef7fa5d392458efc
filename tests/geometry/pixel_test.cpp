#include "lepp/geometry/pixel.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "lepp/geometry/pslg.hpp"
#include "lepp/geometry/segment_intersection.hpp"

using namespace lepp;

TEST_CASE("pixels tile the plane: a segment through a corner of four meets those that own ties") {
  // Doubles from 2^52 to 2^53 are the whole numbers, so pixels there are unit squares.
  const double m = 0x1p52;
  const Point even{m + 2, m + 2}, right{m + 3, m + 2}, up{m + 2, m + 3}, odd{m + 3, m + 3};
  const Point a{m, m + 5}, b{m + 5, m};  // passes (m + 2.5, m + 2.5)
  CHECK(meets_pixel(a, b, even));
  CHECK_FALSE(meets_pixel(a, b, odd));
  CHECK(meets_pixel(a, b, right));  // through its inside
  CHECK(meets_pixel(a, b, up));
  CHECK_FALSE(meets_pixel(a, b, {m + 1, m + 1}));
}

TEST_CASE("a pixel beside or beyond a segment is not met") {
  CHECK_FALSE(meets_pixel({0, 0}, {1, 0}, {2, 0}));
  CHECK_FALSE(meets_pixel({0, 0}, {1, 0}, {0.5, 1e-16}));
  CHECK(meets_pixel({0, 0}, {4, 1}, {2, 0.5}));
  CHECK(meets_pixel({0, 0}, {3, 1}, {1.5, 0.5}));
}

TEST_CASE("between 0 and the least supported number the pixels of both share the gap") {
  const double least = min_coordinate;
  CHECK(meets_pixel({1, 0}, {3, 2 * least}, {2, least}));
  CHECK(meets_pixel({1, 0}, {3, 1.5 * least}, {2, least}));  // 0.75 of it above x = 2
  CHECK_FALSE(meets_pixel({1, 0}, {3, 1.5 * least}, {2, 0}));
  CHECK(meets_pixel({1, -least}, {3, 1.5 * least}, {2, 0}));
}

TEST_CASE("the pixel of a rounded crossing is met by both segments") {
  const unsigned seed = 20264;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  int crossings = 0;
  for (int i = 0; i < 20'000; ++i) {
    CAPTURE(i);
    const double offset = i % 3 == 0 ? 0x1p52 : i % 3 == 1 ? 1e7 : 0;
    const auto coordinate = [&] { return offset + 0.1 * static_cast<double>(random() % 1000); };
    const Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    const Point c{coordinate(), coordinate()}, d{coordinate(), coordinate()};
    if (segments_meet(a, b, c, d) != SegmentMeeting::crossing) continue;
    ++crossings;
    const Point p = crossing_point(a, b, c, d);
    CHECK((p == a || p == b || meets_pixel(a, b, p)));
    CHECK((p == c || p == d || meets_pixel(c, d, p)));
    CHECK(p == crossing_point(c, d, b, a));
  }
  CHECK(crossings > 1000);
}

#include "lepp/refine/off_centre.hpp"

#include <doctest/doctest.h>

#include "lepp/geometry/triangle_measures.hpp"

using namespace lepp;

TEST_CASE("the off-centre of a needle sees its shortest edge under a little more than the bound") {
  const Point p{0, 0}, q{1, 0}, r{0.4, 20};
  for (const double bound : {10.0, 20.0, 30.0, 40.0}) {
    const Point o = OffCentre(bound)(p, q, r);
    const double angle = angles_deg(p, q, o)[2];
    CHECK(angle > bound);
    CHECK(angle < 1.06 * bound);
    CHECK(o.x == doctest::Approx(0.5));
  }
}

TEST_CASE("the off-centre does not depend on the corner that is named first") {
  const Point p{0, 0}, q{1, 0.2}, r{-3, 5};
  const OffCentre off_centre(30);
  const Point o = off_centre(p, q, r);
  for (const Point other : {off_centre(q, r, p), off_centre(r, p, q)}) {
    CHECK(other.x == doctest::Approx(o.x));
    CHECK(other.y == doctest::Approx(o.y));
  }
}

TEST_CASE("where the circumcentre is nearer, or no angle is asked for, it is the circumcentre") {
  const Point a{0, 0}, b{1, 0}, c{0.3, 0.9};
  const Point center = circumcenter(a, b, c);
  for (const double bound : {0.0, 20.0}) {
    const Point o = OffCentre(bound)(a, b, c);
    CHECK(o.x == doctest::Approx(center.x));
    CHECK(o.y == doctest::Approx(center.y));
  }
}

#include "lepp/voronoi/cut_polygon.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lepp;

namespace {

Side neighbour(std::uint32_t i) { return {Side::Kind::bisector, i}; }

std::size_t sides_cut_by(const CutPolygon& polygon, std::uint32_t i) {
  std::size_t sides = 0;
  for (const auto& corner : polygon.corners()) sides += corner.side == neighbour(i);
  return sides;
}

}  // namespace

TEST_CASE("a cut keeps the nearer part and labels the new side") {
  CutPolygon polygon;
  polygon.start_with({0, 0}, {4, 0}, {0, 4});
  CHECK(polygon.keep(nearer_to_origin_than({4, 0}), neighbour(7)));  // x <= 2
  CHECK(polygon.area() == 6);
  REQUIRE(polygon.corners().size() == 4);
  CHECK(polygon.corners()[1].at == Point{2, 0});
  CHECK(polygon.corners()[1].side == neighbour(7));
  CHECK(polygon.corners()[2].at == Point{2, 2});
  CHECK(sides_cut_by(polygon, 7) == 1);
}

TEST_CASE("the sides of a triangle are its edges, numbered like their opposite corners") {
  CutPolygon polygon;
  polygon.start_with({0, 0}, {4, 0}, {0, 4});
  CHECK(polygon.corners()[0].side == Side{Side::Kind::edge, 2});
  CHECK(polygon.corners()[1].side == Side{Side::Kind::edge, 0});
  CHECK(polygon.corners()[2].side == Side{Side::Kind::edge, 1});
}

TEST_CASE("rays keep what lies between them") {
  CutPolygon polygon;
  polygon.start_with({1, -1}, {3, 1}, {1, 3});  // seen from the origin
  const Side ray{Side::Kind::ray, 0};
  CHECK(polygon.keep(left_of_ray({1, 0}), ray));
  CHECK(polygon.keep(right_of_ray({2, 2}), ray));
  CHECK(polygon.corners().size() == 5);  // (1, 0) (2, 0) (3, 1) (2, 2) (1, 1)
  CHECK(polygon.area() == 2.5);
  CHECK_FALSE(polygon.keep(right_of_ray({1, -1}), ray));
}

TEST_CASE("a cut through a corner makes no second corner there") {
  CutPolygon polygon;
  polygon.start_with({0, 0}, {4, 0}, {0, 4});
  CHECK(polygon.keep(nearer_to_origin_than({4, 0}), neighbour(1)));
  CHECK(polygon.keep(nearer_to_origin_than({0, 4}),
                     neighbour(2)));  // meets the first cut on the long side
  CHECK(polygon.keep(nearer_to_origin_than({4, 4}), neighbour(3)));  // only touches that corner
  CHECK(polygon.area() == 4);
  CHECK(polygon.corners().size() == 4);
  CHECK(sides_cut_by(polygon, 3) == 0);
}

TEST_CASE("a cut that takes a corner off along two corners labels the side between them") {
  CutPolygon polygon;
  polygon.start_with({0, 0}, {4, 0}, {4, 4});
  CHECK(polygon.keep(nearer_to_origin_than({4, -4}),
                     neighbour(5)));  // x - y <= 4: touches corner (4, 0) only
  CHECK(polygon.area() == 8);
  CHECK(sides_cut_by(polygon, 5) == 0);
  CHECK(polygon.keep(nearer_to_origin_than({4, 4}),
                     neighbour(6)));  // x + y <= 4: from (4, 0) to (2, 2)
  CHECK(polygon.area() == 4);
  CHECK(polygon.corners().size() == 3);
  CHECK(sides_cut_by(polygon, 6) == 1);
}

TEST_CASE("a polygon beyond the bisector, or only touching it, is left as it was") {
  CutPolygon polygon;
  polygon.start_with({3, 0}, {5, 0}, {3, 1});
  CHECK_FALSE(polygon.keep(nearer_to_origin_than({4, 0}), neighbour(1)));
  CHECK(polygon.area() == 1);
  polygon.start_with({2, 0}, {5, 0}, {2, 1});
  CHECK_FALSE(polygon.keep(nearer_to_origin_than({4, 0}), neighbour(1)));
  CHECK(polygon.area() == 1.5);
  CHECK(sides_cut_by(polygon, 1) == 0);
}

TEST_CASE("a sliver as thin as rounding neither comes off nor is left over") {
  CutPolygon polygon;
  polygon.start_with({0, 0}, {2 + 4e-16, 0}, {0, 1});
  CHECK(polygon.keep(nearer_to_origin_than({4, 0}), neighbour(1)));
  CHECK(polygon.corners().size() == 3);
  polygon.start_with({2 - 4e-16, 0}, {5, 0}, {5, 1});
  CHECK_FALSE(polygon.keep(nearer_to_origin_than({4, 0}), neighbour(1)));
}

TEST_CASE("the part of an acute triangle is what two cuts leave of it") {
  const Point a{4, -1}, b{2.5, 3};
  for (std::uint32_t first = 0; first < 3; ++first) {
    CAPTURE(first);
    CutPolygon cut, at_once;
    cut.start_with({0, 0}, a, b, first);
    REQUIRE(cut.keep(nearer_to_origin_than(a), neighbour(0)));
    REQUIRE(cut.keep(nearer_to_origin_than(b), neighbour(1)));
    REQUIRE(at_once.start_with_acute(a, b, first));
    REQUIRE(at_once.corners().size() == 4);
    REQUIRE(cut.corners().size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(std::abs(at_once.corners()[i].at.x - cut.corners()[i].at.x) < 1e-15);
      CHECK(std::abs(at_once.corners()[i].at.y - cut.corners()[i].at.y) < 1e-15);
      CHECK(at_once.corners()[i].side == cut.corners()[i].side);
    }
  }
}

TEST_CASE("right, nearly right and obtuse angles at any corner are left to the cuts") {
  CutPolygon polygon;
  polygon.start_with({0, 0}, {4, 0}, {0, 4});
  for (const double shift : {0.0, 1e-9, -1e-9, -1.0}) {  // of the last corner
    CAPTURE(shift);
    CHECK_FALSE(polygon.start_with_acute({4, 0}, {shift, 3}, 0));
    CHECK_FALSE(polygon.start_with_acute({4, 0}, {4 - shift, 3}, 0));
    CHECK_FALSE(polygon.start_with_acute({4 - shift, 3}, {0, 3}, 0));
  }
  CHECK(polygon.area() == 8);
  CHECK(polygon.corners().size() == 3);
}

TEST_CASE("a polygon holds as many corners as the cuts make") {
  CutPolygon polygon;
  polygon.start_with({-9, -9}, {9, -9}, {0, 18});
  constexpr std::uint32_t cuts = 1000;
  for (std::uint32_t i = 0; i < cuts; ++i) {
    const double turn = 2 * std::numbers::pi * i / cuts;
    REQUIRE(polygon.keep(nearer_to_origin_than({2 * std::cos(turn), 2 * std::sin(turn)}),
                         neighbour(i)));
  }
  CHECK(polygon.corners().size() == cuts);
  CHECK(polygon.area() == doctest::Approx(cuts * std::tan(std::numbers::pi / cuts)));
}

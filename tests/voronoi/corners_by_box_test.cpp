#include "lepp/voronoi/corners_by_box.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/hand_made.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

std::vector<TriangleCorner> corners_of(const CornersByBox& all, std::uint32_t box) {
  return {all.corners(box).begin(), all.corners(box).end()};
}

TriangleCorner corner(std::uint32_t triangle, std::uint32_t i) { return {TriangleId(triangle), i}; }

}  // namespace

TEST_CASE("a vertex inside a region has one box, with the corners of all triangles around it") {
  const CornersByBox corners(hexagon());
  CHECK(corners.box_count() == 7);
  const std::uint32_t box = corners.first_box(6);
  CHECK(corners_of(corners, box) == std::vector{corner(0, 0), corner(1, 0), corner(2, 0),
                                                corner(3, 0), corner(4, 0), corner(5, 0)});
}

TEST_CASE("a vertex between two regions has a box in each, with the corners of that region") {
  const CornersByBox corners(two_triangles({0, 0}, {1, 0}, {1, 1}, {0, 1}, 1));
  CHECK(corners.box_count() == 6);
  CHECK(corners.first_box(0) == 0);
  CHECK(corners.first_box(1) == 2);
  CHECK(corners.region(0) == SurfaceId(0U));
  CHECK(corners.region(1) == SurfaceId(1U));
  CHECK(corners_of(corners, 0) == std::vector{corner(0, 0)});
  CHECK(corners_of(corners, 1) == std::vector{corner(1, 0)});
}

TEST_CASE("a vertex of two fans has the corners of both in one box") {
  const CornersByBox corners(
      from_triangles({{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, {{0, 1, 2}, {3, 4, 0}}));
  CHECK(corners.first_box(1) == 1);
  CHECK(corners_of(corners, 0) == std::vector{corner(0, 0), corner(1, 2)});
}

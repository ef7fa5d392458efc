#include "lepp/bisection/common_parts.hpp"

#include <doctest/doctest.h>

#include "bisection/remeshed.hpp"
#include "lepp/bisection/remesh_transfer.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("the pairs that overlap are as many as the meshes have triangles, up to a factor") {
  Random random(12);
  for (const double h : {0.2, 0.05}) {
    const Mesh before = random_mesh(divided_square(), h, random);
    const Mesh after = random_mesh(divided_square(), h, random);
    const std::size_t pairs = triangle_transfer(before, after).shares.size();
    CHECK(pairs < 4 * (before.triangle_count() + after.triangle_count()));
  }
}

TEST_CASE("the common part of two triangles: half of a square, a hexagon, a corner, nothing") {
  const std::array<Point, 3> t{{{0, 0}, {1, 0}, {0, 1}}};
  CHECK(CommonPart(t, t).area() == 0.5);
  CHECK(CommonPart(t, {{{1, 1}, {0, 1}, {1, 0}}}).area() == 0);
  CHECK(CommonPart(t, {{{0, 0}, {1, 1}, {0, 1}}}).area() == 0.25);
  CHECK(CommonPart(t, {{{5, 5}, {6, 5}, {5, 6}}}).area() == 0);
  const std::array<Point, 3> star{{{0.6, 0.6}, {-0.2, 0.6}, {0.6, -0.2}}};
  const CommonPart hexagon(t, star);
  CHECK(hexagon.size() == 6);
  CHECK(hexagon.area() == doctest::Approx(0.26));
  for (std::uint32_t edge = 0; edge < 3; ++edge) CHECK(hexagon.goes_on_across(edge));
  CHECK_FALSE(CommonPart(t, {{{-1, -1}, {9, -1}, {-1, 9}}}).goes_on_across(0));
}

#include "lepp/triangulation/locate.hpp"

#include <doctest/doctest.h>

#include <random>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/shapes.hpp"

using namespace lepp;

TEST_CASE("locate finds the triangle from any hint, also around a corner of the domain") {
  const Mesh mesh = constrained_delaunay(test::l_shape()).mesh;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-0.5, 2.5);
  for (int i = 0; i < 2000; ++i) {
    const Point p{uniform(random), uniform(random)};
    const TriangleId hint(random() % mesh.triangle_count());
    const auto place = locate(mesh, p, hint);
    const bool inside = p.x >= 0 && p.y >= 0 && p.x <= 2 && p.y <= 2 && (p.x <= 1 || p.y <= 1);
    REQUIRE(place.has_value() == inside);
    if (!place) continue;
    const auto [a, b, c] = mesh.corners(place->triangle);
    REQUIRE((orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0));
  }
}

TEST_CASE("a point on an edge names the edge") {
  const Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  const auto place = locate(mesh, {0.5, 0});
  REQUIRE(place.has_value());
  REQUIRE(place->on_edge.has_value());
  CHECK(mesh.is_boundary(*place->on_edge));
}

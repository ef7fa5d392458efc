#include "lepp/refine/straight_walk.hpp"

#include <doctest/doctest.h>

#include <random>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/locate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

TEST_CASE("a straight walk ends where the point is, or at a constrained edge between") {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int arrived = 0, barred = 0;
  for (int i = 0; i < 50; ++i) {
    const Mesh mesh = constrained_delaunay(test::random_star(random)).mesh;
    for (int k = 0; k < 20; ++k) {
      const Point p{coordinate(random), coordinate(random)};
      const TriangleId start(random() % mesh.triangle_count());
      const WayEnd end = straight_walk(mesh, start, p);
      if (end.barrier) {
        CHECK(mesh.is_constrained(*end.barrier));
        ++barred;
      } else {
        CHECK(contains(mesh, end.triangle, p));
        ++arrived;
      }
    }
  }
  CHECK(arrived > 100);
  CHECK(barred > 100);
}

TEST_CASE("in a convex mesh without interfaces every walk arrives") {
  Pslg pslg = test::unit_square();
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> coordinate(0.01, 0.99);
  for (int i = 0; i < 200; ++i) pslg.points.push_back({coordinate(random), coordinate(random)});
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  for (int k = 0; k < 300; ++k) {
    const Point p{coordinate(random), coordinate(random)};
    const WayEnd end = straight_walk(mesh, TriangleId(random() % mesh.triangle_count()), p);
    CHECK_FALSE(end.barrier);
    CHECK(contains(mesh, end.triangle, p));
  }
}

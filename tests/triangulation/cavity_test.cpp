#include "lepp/triangulation/cavity.hpp"

#include <doctest/doctest.h>

#include <random>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

TEST_CASE("filling the cavities of random points keeps a mesh constrained Delaunay") {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    Mesh mesh = constrained_delaunay(test::random_star(random)).mesh;
    Cavity cavity;
    for (int k = 0; k < 50; ++k) {
      const Point p{coordinate(random), coordinate(random)};
      const auto place = locate(mesh, p);
      if (!place || !cavity.find(mesh, place->triangle, p)) continue;
      const std::size_t old = cavity.triangles().size(), rim = cavity.rim().size();
      CHECK(rim == old + 2);  // no vertex inside
      const VertexId v = cavity.fill(mesh, p, {VertexOrigin::Kind::interior, 0});
      CHECK(mesh.point(v) == p);
      CHECK(cavity.triangles().size() == rim);
      for (const TriangleId t : cavity.triangles()) CHECK(mesh.vertex(t, 0) == v);
    }
    CHECK(validate(mesh).summary() == "valid");
  }
}

TEST_CASE("a grid of cocircular points fills the same way") {
  Mesh mesh = constrained_delaunay(test::polygon({0, 0, 4, 0, 4, 4, 0, 4})).mesh;
  Cavity cavity;
  for (int i = 1; i < 4; ++i) {
    for (int j = 1; j < 4; ++j) {
      const Point p{static_cast<double>(i), static_cast<double>(j)};
      REQUIRE(cavity.find(mesh, locate(mesh, p)->triangle, p));
      cavity.fill(mesh, p, {VertexOrigin::Kind::interior, 0});
    }
  }
  CHECK(mesh.vertex_count() == 13);
  CHECK(validate(mesh).summary() == "valid");
}

TEST_CASE("no vertex can be put on a vertex or a constrained edge") {
  const Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  Cavity cavity;
  CHECK_FALSE(cavity.find(mesh, locate(mesh, {1, 1})->triangle, {1, 1}));
  CHECK_FALSE(cavity.find(mesh, locate(mesh, {0.25, 0})->triangle, {0.25, 0}));
  CHECK(cavity.find(mesh, locate(mesh, {0.5, 0.5})->triangle, {0.5, 0.5}));
  CHECK(cavity.rim().size() == 4);
}

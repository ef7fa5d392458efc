#include "lepp/triangulation/locate.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/locator.hpp"
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

TEST_CASE("a point at a vertex names the vertex, and an edge that ends there") {
  const Mesh mesh = constrained_delaunay(test::l_shape()).mesh;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (std::size_t hint = 0; hint < mesh.triangle_count(); ++hint) {
      const auto place = locate(mesh, mesh.point(VertexId(v)), TriangleId(hint));
      REQUIRE(place.has_value());
      CHECK(place->at_vertex == VertexId(v));
      CHECK(place->on_edge.has_value());
    }
  }
}

namespace {

// Cells of side 1 / n with a corner moved at random, in the unit square, without the middle ninth.
Mesh square_with_hole(int n, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.1, 0.9);
  Pslg pslg = test::unit_square();
  test::add_chain(pslg, {{1. / 3, 1. / 3}, {2. / 3, 1. / 3}, {2. / 3, 2. / 3}, {1. / 3, 2. / 3}},
                  true);
  pslg.holes = {{0.5, 0.5}};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Point p{(i + uniform(random)) / n, (j + uniform(random)) / n};
      pslg.points.push_back(p);
    }
  }
  return constrained_delaunay(pslg).mesh;
}

// Teeth of width 1 and length `length`, with gaps as wide, on a back of height 1; turned by the
// 3-4-5 angle if so wanted.
enum class Turned { no, yes };
Pslg comb(int teeth, double length, Turned turned) {
  std::vector<double> coordinates;
  for (int i = 0; i < 2 * teeth; ++i) coordinates.insert(coordinates.end(), {1. * i, -1});
  for (int i = teeth - 1; i >= 0; --i) {
    const double left = 2 * i, right = left + 1;
    coordinates.insert(coordinates.end(), {right, 0, right, length, left, length, left, 0});
  }
  if (turned == Turned::yes) {
    for (std::size_t i = 0; i < coordinates.size(); i += 2) {
      const double x = coordinates[i], y = coordinates[i + 1];
      coordinates[i] = 0.8 * x - 0.6 * y;
      coordinates[i + 1] = 0.6 * x + 0.8 * y;
    }
  }
  return test::polygon(coordinates);
}

Point random_point_of(const Mesh& mesh, std::mt19937_64& random) {
  const auto [a, b, c] = mesh.corners(TriangleId(random() % mesh.triangle_count()));
  return midpoint(midpoint(a, b), c);
}

}  // namespace

TEST_CASE("from a hint next door the number of steps does not grow with the mesh") {
  std::mt19937_64 random(5);
  for (const int n : {20, 80}) {
    const Mesh mesh = square_with_hole(n, random);
    LocateSteps steps;
    const int asked = 2000;
    for (int i = 0; i < asked; ++i) {
      const TriangleId hint(random() % mesh.triangle_count());
      const auto [a, b, c] = mesh.corners(hint);
      locate(mesh, midpoint(a, b) + 0.75 * (c - midpoint(b, a)), hint, &steps);
    }
    CHECK(steps.count < 4 * asked);
  }
}

TEST_CASE("across a hole a walk goes round it, without a look at every triangle") {
  std::mt19937_64 random(6);
  const Mesh mesh = square_with_hole(60, random);
  const auto left = locate(mesh, {0.1, 0.5});
  REQUIRE(left.has_value());
  LocateSteps steps;
  REQUIRE(locate(mesh, {0.9, 0.5}, left->triangle, &steps).has_value());
  CHECK(steps.count < mesh.triangle_count() / 10);
}

TEST_CASE("a Locator takes a few steps wherever the point is, and some more in graded meshes") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform;
  // Points that crowd towards the origin, over nine powers of ten.
  Pslg graded = test::unit_square();
  for (int i = 0; i < 6000; ++i) {
    const double r = std::pow(10, -9 * uniform(random)), angle = uniform(random) * 1.57;
    graded.points.push_back({0.99 * r * std::cos(angle), 0.99 * r * std::sin(angle)});
  }
  const std::vector<Mesh> meshes{square_with_hole(20, random), square_with_hole(80, random),
                                 constrained_delaunay(graded).mesh,
                                 constrained_delaunay(comb(1000, 500, Turned::no)).mesh};
  for (const Mesh& mesh : meshes) {
    const Locator locator(mesh);
    CHECK(locator.size() <= 4 * mesh.triangle_count());
    LocateSteps inside, anywhere;
    const int asked = 4000;
    for (int i = 0; i < asked; ++i) {
      REQUIRE(locator.locate(random_point_of(mesh, random), &inside).has_value());
      const double scale = mesh.point(VertexId(1U)).x;
      locator.locate({uniform(random) * scale, uniform(random) * scale / 2}, &anywhere);
    }
    // There are as many grids as sizes, and sizes between 1e-9 and 1.
    const std::size_t most = &mesh == &meshes[2] ? 200 : 20;
    CHECK(inside.count < most * asked);
    CHECK(anywhere.count < most * asked);
  }
}

TEST_CASE("on combs all ways to locate agree, and a walk goes round the comb at most about once") {
  std::mt19937_64 random(8);
  for (const Turned turned : {Turned::no, Turned::yes}) {
    const Mesh mesh = constrained_delaunay(comb(100, 30, turned)).mesh;
    const Locator locator(mesh);
    std::vector<Point> points;
    for (int i = 0; i < 500; ++i) points.push_back(random_point_of(mesh, random));
    const auto places = locate(mesh, points);
    LocateSteps steps;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const TriangleId hint(random() % mesh.triangle_count());
      const auto place = locate(mesh, points[i], hint, &steps);
      REQUIRE(place.has_value());
      REQUIRE(places[i].has_value());
      REQUIRE(place->triangle == places[i]->triangle);
      REQUIRE(locator.locate(points[i])->triangle == place->triangle);
    }
    CHECK(steps.count < 500 * mesh.triangle_count());  // the loop has as many edges, and two
  }
}

TEST_CASE("a batch takes a few steps a point, whatever the order of the points") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> uniform;
  const Mesh mesh = square_with_hole(60, random);
  std::vector<Point> points;
  for (int i = 0; i < 20000; ++i) points.push_back({uniform(random), uniform(random)});
  LocateSteps steps;
  const auto places = locate(mesh, points, &steps);
  CHECK(steps.count < 12 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = points[i];
    const bool in_hole = x > 1. / 3 && x < 2. / 3 && y > 1. / 3 && y < 2. / 3;
    REQUIRE(places[i].has_value() == !in_hole);
  }
  CHECK(locate(mesh, std::span<const Point>{}).empty());
}

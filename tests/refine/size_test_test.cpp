#include "lepp/refine/size_test.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/refine/size_field.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/shapes.hpp"

using namespace lepp;

TEST_CASE("a triangle is too large by its longest edge, its area, its region or the field") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  const Point a{0, 0}, b{0.2, 0}, c{0.2, 0.1};  // area 0.01, longest edge 0.2236
  const SurfaceId region = mesh.region(TriangleId(0U));
  const auto too_large = [&](const RefineOptions& options) {
    return SizeTest(mesh, options).is_too_large(a, b, c, region);
  };
  RefineOptions options;
  CHECK_FALSE(too_large(options));
  options.max_edge = 0.23;
  options.max_area = 0.0101;
  CHECK_FALSE(too_large(options));
  options.max_edge = 0.22;
  CHECK(too_large(options));
  options.max_edge = 0.23;
  options.max_area = 0.0099;
  CHECK(too_large(options));
  options.max_area = 1;
  options.size = [](Point) { return 0.23; };
  CHECK_FALSE(too_large(options));
  options.size = [](Point p) { return p == Point{0.2, 0.1} ? 0.22 : 0.23; };
  CHECK(too_large(options));
  options.size = {};
  Entities entities = mesh.entities();
  entities.surfaces[region.index()].max_edge = 0.22;
  mesh.set_entities(entities);
  CHECK(too_large(options));
}

TEST_CASE("triangles are predicted from the field as from a bound, where they say the same") {
  const Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  RefineOptions bound, field, sources;
  bound.max_edge = 0.01;
  field.size = [](Point) { return 0.01; };
  const auto predicted = [&](const RefineOptions& options) {
    return SizeTest(mesh, options).predicted_triangles({0, 0}, {1, 0}, {0, 1}, SurfaceId(0U));
  };
  CHECK(predicted(bound) == doctest::Approx(0.5 / (std::sqrt(3.0) / 4 * 1e-4)));
  CHECK(predicted(field) == doctest::Approx(predicted(bound)));
  // h = s + g r around a corner: integral of (pi / 2) r / (0.433 (s + g r)^2) over r, cut at the
  // hypotenuse; between the quarter discs of radius 0.7071 and 1.
  sources.size = SizeField({{{0, 0}, 0.001}}, 0.5);
  const auto within = [](double r) {
    const double s = 0.001, g = 0.5, u = s + g * r;
    return std::acos(-1.0) / 2 / 0.4330127 / (g * g) * (std::log(u / s) + s / u - 1);
  };
  CHECK(predicted(sources) > 0.9 * within(0.7071));
  CHECK(predicted(sources) < 1.2 * within(1));
}

TEST_CASE("a field that gives no length above 0 is reported with the place") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  RefineOptions options;
  options.size = [](Point p) { return p.x < 0.5 ? 0.1 : -0.1; };
  CHECK_THROWS_WITH_AS(refine(mesh, options), doctest::Contains("size field at ("), InputError);
  options.size = [](Point) { return std::nan(""); };
  CHECK_THROWS_AS(refine(mesh, options), InputError);
}

TEST_CASE("sizes that need more than 1e8 triangles are refused, by bounds and by field") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  RefineOptions options;
  options.size = [](Point) { return 1e-5; };
  CHECK_THROWS_AS(refine(mesh, options), RefusedError);
  options.size = SizeField({{{0.5, 0.5}, 1e-5}}, 1e-6);
  CHECK_THROWS_AS(refine(mesh, options), RefusedError);
  CHECK(mesh.vertex_count() == 4);
}

TEST_CASE("the triangles around a point of a size file are as small as it asks, at any grading") {
  for (const double grading : {0.5, 100.0}) {
    CAPTURE(grading);
    const Point at{0.3, 0.4};
    Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
    RefineOptions options;
    options.size = SizeField({{at, 1e-3, true}}, grading);
    const RefineReport report = refine(mesh, options);
    CHECK(report.goal_reached);
    int around = 0;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(t));
      if (orient2d(a, b, at) < 0 || orient2d(b, c, at) < 0 || orient2d(c, a, at) < 0) continue;
      ++around;
      CHECK(std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)}) <=
            1e-6);
    }
    CHECK(around > 0);
  }
}

TEST_CASE("a size asked of triangles counts beside, and without, a size at points") {
  const Point at{0.3, 0.4};
  const auto is_around = [&](Point a, Point b, Point c) {
    return orient2d(a, b, at) >= 0 && orient2d(b, c, at) >= 0 && orient2d(c, a, at) >= 0;
  };
  for (const bool with_size : {false, true}) {
    CAPTURE(with_size);
    Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
    RefineOptions options;
    if (with_size) options.size = [](Point) { return 0.3; };
    options.size_in = [&](Point a, Point b, Point c) { return is_around(a, b, c) ? 0.01 : 1e9; };
    CHECK(refine(mesh, options).goal_reached);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(t));
      if (!is_around(a, b, c)) continue;
      CHECK(std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)}) <=
            1e-4);
    }
  }
}

#include "lepp/refine/size_point.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/refine/size_field.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

std::size_t obtuse_triangles(const Mesh& mesh) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const auto [a, b, c] = mesh.corners(TriangleId(i));
    found += is_obtuse(a, b, c) || is_obtuse(b, c, a) || is_obtuse(c, a, b) ? 1 : 0;
  }
  return found;
}

double longest_edge_of(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return std::sqrt(
      std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)}));
}

}  // namespace

TEST_CASE("constrained edges are cut into equal parts, of odd number too") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  RefineOptions options;
  options.max_edge = 0.29;  // wanted 0.203, parts up to 0.2233: five of 0.2
  cut_evenly(mesh, SizeTest(mesh, options), 1e-12, [] { return true; });
  CHECK(mesh.vertex_count() == 20);
  for (const Point p : mesh.points()) {
    for (const double x : {p.x, p.y}) CHECK(5 * x == doctest::Approx(std::round(5 * x)));
  }
  CHECK(validate(mesh).summary() == "valid");
}

TEST_CASE("equal parts stop when the caller says so") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  RefineOptions options;
  options.max_edge = 1e-3;
  cut_evenly(mesh, SizeTest(mesh, options), 1e-12, [&] { return mesh.vertex_count() < 50; });
  CHECK(mesh.vertex_count() == 50);
}

TEST_CASE("uniform meshes are near-equilateral, and no triangle is larger than asked for") {
  for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
    for (const bool by_area : {true, false}) {
      CAPTURE(static_cast<int>(effort));
      CAPTURE(by_area);
      Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
      RefineOptions options;
      options.effort = effort;
      if (by_area) options.max_area = 1e-4;
      else options.max_edge = 0.02;
      const RefineReport report = refine(mesh, options);
      CHECK(report.goal_reached);
      CHECK(validate(mesh, {.min_angle_deg = 30, .nonobtuse = true}).summary() == "valid");
      const double share =
          static_cast<double>(obtuse_triangles(mesh)) / static_cast<double>(mesh.triangle_count());
      CHECK(share < (effort == Effort::fast ? 0.1 : 0.02));
      double area = 0, edge = 0;
      for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
        const auto [a, b, c] = mesh.corners(TriangleId(i));
        area = std::max(area, signed_area(a, b, c));
        edge = std::max(edge, longest_edge_of(mesh, TriangleId(i)));
      }
      if (by_area) CHECK(area <= 1e-4);
      else CHECK(edge <= 0.02);
      if (by_area) CHECK(mesh.triangle_count() < 18'000);  // 10,000 of that area would do
    }
  }
}

TEST_CASE("the field holds at corners and centroid of every triangle, with every placement") {
  for (const Placement placement : {Placement::offcentre, Placement::best, Placement::centroid}) {
    CAPTURE(static_cast<int>(placement));
    Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
    RefineOptions options;
    options.placement = placement;
    options.size = SizeField({{{0.3, 0.4}, 0.004}, {{0.9, 0.9}, 0.01}}, 0.25);
    CHECK(refine(mesh, options).goal_reached);
    CHECK(validate(mesh, {.min_angle_deg = 30, .nonobtuse = true}).summary() == "valid");
    CHECK(mesh.vertex_count() < 5000);
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
      const auto [a, b, c] = mesh.corners(TriangleId(i));
      const Point centroid{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
      const double edge = longest_edge_of(mesh, TriangleId(i));
      for (const Point p : {a, b, c, centroid}) CHECK(edge <= options.size(p));
    }
  }
}

// Two unit squares side by side, each a surface of its own.
Pslg two_squares() {
  Pslg pslg = test::polygon({0, 0, 1, 0, 2, 0, 2, 1, 1, 1, 0, 1});
  pslg.segments.push_back({VertexId(1U), VertexId(4U), {}, 0, 1});
  pslg.entities.surfaces.resize(2);
  const SurfaceId left(0U), right(1U);
  pslg.entities.curves = {{1, {}, {}, {left}}, {2, {}, {}, {right}}, {3, {}, {}, {left, right}}};
  const std::size_t curve_of[] = {0, 1, 1, 1, 0, 0, 2};
  for (std::size_t i = 0; i < 7; ++i) pslg.segments[i].curve = CurveId(curve_of[i]);
  return pslg;
}

TEST_CASE("a region's longest edge holds there and leaves the other region coarse") {
  Mesh mesh = constrained_delaunay(two_squares()).mesh;
  Entities entities = mesh.entities();
  entities.surfaces[1].max_edge = 0.05;
  mesh.set_entities(entities);
  CHECK(refine(mesh).goal_reached);
  std::size_t of_region[] = {0, 0};
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    ++of_region[mesh.region(t).index()];
    if (mesh.region(t) == SurfaceId(1U)) CHECK(longest_edge_of(mesh, t) <= 0.05);
  }
  CHECK(of_region[0] > 0);
  CHECK(of_region[1] > 5 * of_region[0]);
}

TEST_CASE("vertices that cut an arc evenly lie on it") {
  Pslg pslg;
  pslg.points = {{1, 0}, {-1, 0}};
  pslg.segments = {{VertexId(0U), VertexId(1U), {}, 0, 1}, {VertexId(1U), VertexId(0U), {}, 0, 1}};
  const double half = std::acos(-1.0);
  pslg.entities.curves = {{1, {}, EllipseArc{{0, 0}, {1, 0}, {0, 1}, 0, half}, {}}};
  pslg.segments[0].curve = CurveId(0U);
  pslg.points.push_back({0, 1});  // halfway up the arc, so that the first chord is not the diameter
  pslg.segments[0] = {VertexId(0U), VertexId(2U), CurveId(0U), 0, 0.5};
  pslg.segments.push_back({VertexId(2U), VertexId(1U), CurveId(0U), 0.5, 1});
  Mesh mesh = constrained_delaunay(pslg).mesh;
  RefineOptions options;
  options.max_edge = 0.1;
  CHECK(refine(mesh, options).goal_reached);
  std::size_t on_arc = 0;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const Point p = mesh.point(VertexId(i));
    const double radius = std::sqrt(dot(p, p));
    CHECK(radius < 1 + 1e-12);
    on_arc += radius > 1 - 1e-12 && p.y > 1e-9 ? 1 : 0;
  }
  CHECK(on_arc > 30);
  CHECK(validate(mesh, {.min_angle_deg = 30, .nonobtuse = true}).summary() == "valid");
}

TEST_CASE("sizes are reached without a bound on angles, and where obtuse angles may stay") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  RefineOptions options;
  options.min_angle_deg = 0;
  options.obtuse = ObtuseRule::ignore;
  options.max_area = 1e-3;
  CHECK(refine(mesh, options).goal_reached);
  CHECK(validate(mesh).summary() == "valid");
}

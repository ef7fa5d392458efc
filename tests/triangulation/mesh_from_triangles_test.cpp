#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"

using namespace lepp;

namespace {

VertexId v(std::uint32_t i) { return VertexId(i); }

// Two triangles of the unit square; the first is clockwise.
TriangleSoup square() {
  TriangleSoup soup;
  soup.source = "soup";
  soup.base = 1;
  soup.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  soup.triangles = {{v(0), v(2), v(1)}, {v(0), v(2), v(3)}};
  return soup;
}

std::string error_of(const TriangleSoup& soup) {
  try {
    mesh_from_triangles(soup);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("triangles are turned counter-clockwise, joined, and their boundary constrained") {
  const Triangulation made = mesh_from_triangles(square());
  CHECK(validate(made.mesh).summary() == "valid");
  CHECK(total_area(made.mesh) == 1);
  CHECK(made.mesh.segments().size() == 4);
}

TEST_CASE("edges between regions, and given lines, are constrained") {
  TriangleSoup soup = square();
  soup.entities.surfaces = {{1, {}, 1, 1e9}, {2, {}, 2, 1e9}};
  SUBCASE("regions") { soup.regions = {SurfaceId(0U), SurfaceId(1U)}; }
  SUBCASE("a line") {
    soup.entities.curves = {{9, {}, StraightCurve{}, {}}};
    soup.segments = {{v(2), v(0), CurveId(0U), 0, 1}};
    CHECK(measure_entities(mesh_from_triangles(soup).mesh).curve_lengths[0] ==
          doctest::Approx(std::sqrt(2)));
  }
  const Mesh mesh = mesh_from_triangles(soup).mesh;
  CHECK(mesh.is_constrained(*mesh.find_edge(v(0), v(2))));
  CHECK(validate(mesh).summary() == "valid");
}

TEST_CASE("a line given many times: its edge has one set of owners, and each keeps its curve") {
  TriangleSoup soup = square();
  soup.entities.curves = {{9, {}, StraightCurve{}, {}}, {10, {}, StraightCurve{}, {}}};
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    soup.segments.push_back({v(i % 2 * 2), v(2 - i % 2 * 2), CurveId(i % 2), 0, 1});
  }
  const Mesh mesh = mesh_from_triangles(soup).mesh;
  CHECK(validate(mesh).summary() == "valid");
  const HalfEdge diagonal = *mesh.find_edge(v(0), v(2));
  CHECK(mesh.segments_of(diagonal).size() == 20'000);
  CHECK(mesh.constrained_edge(diagonal).segments == SegmentSetId(mesh.segments().size()));
  CHECK(measure_entities(mesh).curve_lengths[1] == doctest::Approx(std::sqrt(2)));
}

TEST_CASE("unused points are dropped with a count, lines that are no edge too") {
  TriangleSoup soup = square();
  soup.points.push_back({9, 9});
  soup.segments = {{v(1), v(3), {}, 0, 1}};
  const Triangulation made = mesh_from_triangles(soup);
  CHECK(made.mesh.vertex_count() == 4);
  CHECK(made.report.points_outside == 1);
  CHECK(made.report.segments_outside == 1);
  CHECK(made.report.warnings.size() == 2);
}

TEST_CASE("every way in which triangles are no mesh is an error with the user's numbers") {
  TriangleSoup soup = square();
  SUBCASE("no triangle") {
    soup.triangles.clear();
    CHECK(contains(error_of(soup), "no triangles"));
  }
  SUBCASE("a point that does not exist") {
    soup.triangles[1][2] = v(8);
    CHECK(contains(error_of(soup), "triangle 2"));
    CHECK(contains(error_of(soup), "point 9"));
  }
  SUBCASE("zero area") {
    soup.triangles[0] = {v(0), v(1), v(1)};
    CHECK(contains(error_of(soup), "triangle 1"));
    CHECK(contains(error_of(soup), "zero area"));
  }
  SUBCASE("three triangles on an edge") {
    soup.points.push_back({2, 0.25});
    soup.triangles.push_back({v(0), v(2), v(4)});
    CHECK(contains(error_of(soup), "edge 1-3"));
    CHECK(contains(error_of(soup), "three"));
  }
  SUBCASE("two triangles on one side of an edge") {
    soup.triangles[1] = {v(0), v(1), v(3)};
    soup.points[3] = {0.25, 2};
    CHECK(contains(error_of(soup), "triangles 1 and 2"));
    CHECK(contains(error_of(soup), "overlap"));
  }
  SUBCASE("a vertex that hangs in the middle of an edge") {
    soup.points.push_back({0.5, 0});
    soup.points.push_back({0.5, -1});
    soup.triangles.push_back({v(0), v(5), v(4)});
    CHECK(contains(error_of(soup), "boundary edges"));
  }
  SUBCASE("a coordinate that is not finite") {
    soup.points[1].x = std::numeric_limits<double>::quiet_NaN();
    CHECK(contains(error_of(soup), "point 2"));
  }
}

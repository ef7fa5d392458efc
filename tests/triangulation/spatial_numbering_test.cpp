#include "lepp/triangulation/spatial_numbering.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

// Points in no order, a chain through them, and Steiner points on it and beside it.
Mesh refined_mesh(std::mt19937_64& random, int points) {
  std::uniform_real_distribution<double> coordinate(0.05, 0.95);
  Pslg pslg = test::unit_square();
  test::add_chain(pslg, {{0.2, 0.02}, {0.5, 0.6}, {0.8, 0.98}}, false);
  for (int i = 0; i < points; ++i) pslg.points.push_back({coordinate(random), coordinate(random)});
  Mesh mesh = constrained_delaunay(pslg).mesh;
  RefineOptions options;
  options.effort = Effort::fast;
  refine(mesh, options);
  return mesh;
}

// What the mesh keeps about each constrained edge, by the places of its ends.
using Place = std::pair<double, double>;
std::map<std::pair<Place, Place>, std::tuple<std::uint32_t, double, double>> records(
    const Mesh& mesh) {
  std::map<std::pair<Place, Place>, std::tuple<std::uint32_t, double, double>> found;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{TriangleId(i), k};
      if (!mesh.is_constrained(e)) continue;
      const VertexId a = mesh.origin(e), b = mesh.destination(e);
      const ConstrainedEdge record = mesh.constrained_edge(e);
      const bool in_order = a < b;
      const Point p = mesh.point(a), q = mesh.point(b);
      found[{{p.x, p.y}, {q.x, q.y}}] = {record.segments.value,
                                         in_order ? record.t_low : record.t_high,
                                         in_order ? record.t_high : record.t_low};
    }
  }
  return found;
}

double way_through(const Mesh& mesh) {
  double length = 0;
  for (std::size_t v = 1; v < mesh.vertex_count(); ++v) {
    length += std::sqrt(squared_distance(mesh.points()[v - 1], mesh.points()[v]));
  }
  return length;
}

}  // namespace

TEST_CASE("a spatial numbering leaves the mesh the same but for its numbers, neighbours together") {
  std::mt19937_64 random(8);
  for (const int points : {0, 3, 40, 400}) {
    CAPTURE(points);
    const Mesh before = refined_mesh(random, points);
    Mesh mesh = before;
    SpatialNumbering numbering(mesh);
    CHECK(validate(mesh, {.delaunay = true}).summary() == "valid");
    CHECK(records(mesh) == records(before));
    if (points == 400) CHECK(way_through(mesh) < 0.3 * way_through(before));
    numbering.undo();
    CHECK(validate(mesh, {.delaunay = true}).summary() == "valid");
    CHECK(records(mesh) == records(before));
    for (std::size_t v = 0; before.is_input(VertexId(v)); ++v) {
      CHECK(mesh.points()[v] == before.points()[v]);
      CHECK(mesh.origins()[v].index == before.origins()[v].index);
    }
  }
}

TEST_CASE("input vertices keep their numbers in a mesh that is refined in spatial order") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> coordinate(0.05, 0.95);
  Pslg pslg = test::unit_square();
  test::add_chain(pslg, {{0.2, 0.02}, {0.8, 0.98}}, false);
  for (int i = 0; i < 21000; ++i) {
    pslg.points.push_back({coordinate(random), coordinate(random)});
  }
  Mesh mesh = constrained_delaunay(pslg).mesh;
  RefineOptions options;
  SUBCASE("to its end") {}
  SUBCASE("until the caller stops it") {
    options.progress = [](std::size_t vertices) { return vertices < 25000; };
  }
  SUBCASE("until a size of the caller's throws") {
    options.size = [calls = 0](Point) mutable -> double {
      if (++calls == 100000) throw std::runtime_error("no size here");
      return 0.01;
    };
  }
  try {
    const RefineReport report = refine(mesh, options);
    CHECK(report.steiner_points == mesh.vertex_count() - pslg.points.size());
  } catch (const std::runtime_error&) {
    CHECK(options.size);
  }
  for (std::size_t v = 0; v < pslg.points.size(); ++v) {
    REQUIRE(mesh.points()[v] == pslg.points[v]);
  }
  CHECK(validate(mesh, {.delaunay = true}).summary() == "valid");
}

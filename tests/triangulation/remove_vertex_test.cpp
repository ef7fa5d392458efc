#include "lepp/triangulation/remove_vertex.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>
#include <vector>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

using Edge = std::pair<Point, Point>;

std::vector<Edge> edges_of(const Mesh& mesh) {
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      edges.push_back(std::minmax(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e))));
    }
  }
  std::ranges::sort(edges);
  return edges;
}

VertexId insert(Mesh& mesh, Point p) {
  const auto place = locate(mesh, p);
  REQUIRE(place.has_value());
  if (!place->on_edge) return insert_in_triangle(mesh, place->triangle, p, {}).vertex;
  REQUIRE(can_split_edge(mesh, *place->on_edge, p));
  return insert_on_edge(mesh, *place->on_edge, p, origin_on(mesh, *place->on_edge)).vertex;
}

// Every triangle is told of: it has the corners it had, or it is in `changed`; by points, since
// the last vertex has another id.
void check_report(const Mesh& before, const Mesh& after, const Removal& removal) {
  for (std::size_t t = 0; t < after.triangle_count(); ++t) {
    if (std::ranges::binary_search(removal.changed, TriangleId(t))) continue;
    TriangleId was(t);
    for (const auto& [from, to] : removal.moved_triangles) {
      if (to == was) {
        was = from;
        break;
      }
    }
    REQUIRE(before.corners(was) == after.corners(TriangleId(t)));
  }
  REQUIRE((removal.changed.empty() || removal.changed.back().index() < after.triangle_count()));
  REQUIRE(removal.moved_triangles.size() <= 2);
}

Removal remove(Mesh& mesh, VertexId v) {
  const Mesh before = mesh;
  const auto removal = remove_vertex(mesh, v);
  REQUIRE(removal.has_value());
  REQUIRE(mesh.vertex_count() + 1 == before.vertex_count());
  if (removal->moved_vertex) {
    REQUIRE(mesh.point(v) == before.point(*removal->moved_vertex));
    REQUIRE(removal->moved_vertex->index() == mesh.vertex_count());
  } else {
    REQUIRE(v.index() == mesh.vertex_count());
  }
  REQUIRE(validate(mesh).summary() == "valid");
  check_report(before, mesh, *removal);
  return *removal;
}

// Removes all Steiner points in random order.
void remove_all(Mesh& mesh, std::size_t inputs, std::mt19937_64& random) {
  while (mesh.vertex_count() > inputs) {
    remove(mesh, VertexId(inputs + random() % (mesh.vertex_count() - inputs)));
  }
}

}  // namespace

TEST_CASE("insertions are undone by removals in any order") {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> uniform(0, 2);
  for (const Pslg& pslg : {test::l_shape(), test::random_star(random, 5)}) {
    Mesh mesh = constrained_delaunay(pslg).mesh;
    const auto edges = edges_of(mesh);
    const double area = total_area(mesh);
    const std::size_t inputs = mesh.vertex_count();
    for (int i = 0; i < 150; ++i) {
      const Point p{uniform(random) - 0.1, uniform(random) - 0.1};
      if (const auto place = locate(mesh, p); place && !place->on_edge) insert(mesh, p);
    }
    remove_all(mesh, inputs, random);
    CHECK(edges_of(mesh) == edges);
    CHECK(total_area(mesh) == doctest::Approx(area).epsilon(1e-12));
  }
}

TEST_CASE(
    "on grids, where all is collinear and cocircular, removal in any order ends at the start") {
  std::mt19937_64 random(32);
  for (int round = 0; round < 10; ++round) {
    const int n = 7;
    Mesh mesh = constrained_delaunay(test::polygon({0, 0, n, 0, n, n, 0, n})).mesh;
    std::vector<Point> grid;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        if (i % n != 0 || j % n != 0) grid.push_back({1. * i, 1. * j});
      }
    }
    std::ranges::shuffle(grid, random);
    for (const Point p : grid) insert(mesh, p);
    remove_all(mesh, 4, random);
    CHECK(mesh.triangle_count() == 2);
    CHECK(total_area(mesh) == n * n);
  }
}

TEST_CASE("a star that is not convex is filled along its reflex corners") {
  // The arms of a windmill: from the middle every corner is seen, every other corner is reflex.
  for (const int arms : {2, 3, 4, 7, 50}) {
    std::vector<double> coordinates;
    for (int i = 0; i < 2 * arms; ++i) {
      const double angle = std::numbers::pi * i / arms, radius = i % 2 == 0 ? 1 : 0.1;
      coordinates.insert(coordinates.end(), {radius * std::cos(angle), radius * std::sin(angle)});
    }
    Mesh mesh = constrained_delaunay(test::polygon(coordinates)).mesh;
    const auto edges = edges_of(mesh);
    const double area = total_area(mesh);
    insert(mesh, {1e-3, 2e-3});
    remove(mesh, VertexId(static_cast<std::size_t>(2 * arms)));
    CHECK(edges_of(mesh).size() == edges.size());
    CHECK(total_area(mesh) == doctest::Approx(area).epsilon(1e-14));
  }
}

TEST_CASE("a vertex on the only diagonal of its star is removed, the star convex or not") {
  // Exactly four triangles around the origin; it lies between (-2, 0) and (2, 0).
  for (const double x : {0.0, 1.0, -3.0}) {  // of the lower corner; beyond -2 the star is reflex
    Mesh mesh = constrained_delaunay(test::polygon({2, 0, 0, 1, -2, 0, x, -2})).mesh;
    insert(mesh, {0, 0});
    remove(mesh, VertexId(4U));
    CHECK(mesh.triangle_count() == 2);
  }
  Mesh dart = constrained_delaunay(test::polygon({4, 0, -4, 3, -1, 0, -4, -3})).mesh;
  insert(dart, {0, 0});
  REQUIRE(dart.triangle_count() == 4);
  remove(dart, VertexId(4U));
  CHECK(dart.find_edge(VertexId(0U), VertexId(2U)).has_value());
}

TEST_CASE("the halves of a segment become one again, with their tags and parameters") {
  std::mt19937_64 random(33);
  Pslg pslg = test::polygon({0, 0, 8, 0, 8, 8, 0, 8});
  pslg.entities.curves = {{5, {}, StraightCurve{}, {}}};
  test::add_chain(pslg, {{0, 0}, {8, 8}}, false);
  for (Segment& s : pslg.segments) s.curve = CurveId(0U);
  Mesh mesh = constrained_delaunay(pslg).mesh;
  const auto edges = edges_of(mesh);
  const std::size_t inputs = mesh.vertex_count();
  for (int round = 0; round < 5; ++round) {
    for (int i = 0; i < 60; ++i) {
      const HalfEdge e{TriangleId(random() % mesh.triangle_count()),
                       static_cast<std::uint32_t>(random() % 3)};
      if (mesh.is_constrained(e)) split_halfway(mesh, e, 1e-6);
    }
    REQUIRE(mesh.vertex_count() > inputs + 10);
    for (std::size_t v = inputs; v < mesh.vertex_count(); ++v) {
      REQUIRE(removability(mesh, VertexId(v)) == Removability::from_segment);
    }
    remove_all(mesh, inputs, random);
    CHECK(edges_of(mesh) == edges);
    for (const Segment& s : mesh.segments()) {
      const auto record = mesh.find_record(s.a, s.b);
      REQUIRE(record.has_value());
      CHECK(record->t_low == (s.a < s.b ? s.t_a : s.t_b));
      CHECK(record->t_high == (s.a < s.b ? s.t_b : s.t_a));
    }
  }
}

TEST_CASE("what must stay is refused with a reason, and the mesh is as it was") {
  Pslg pslg = test::polygon({0, 0, 4, 0, 4, 4, 0, 4});
  pslg.points.push_back({1, 1});
  pslg.points.push_back({2, 2.5});
  test::add_chain(pslg, {{0.5, 3}, {3, 3}}, false);
  Mesh mesh = constrained_delaunay(pslg).mesh;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    CHECK(removability(mesh, VertexId(v)) == Removability::input_vertex);
  }
  const Mesh before = mesh;
  CHECK_FALSE(remove_vertex(mesh, VertexId(4U)).has_value());
  CHECK(edges_of(mesh) == edges_of(before));
  CHECK(to_string(Removability::input_vertex) == "it is a point of the input");

  const HalfEdge bottom = *mesh.find_edge(VertexId(0U), VertexId(1U));
  const VertexId bent = insert_on_edge(mesh, bottom, {2, -0.25}, origin_on(mesh, bottom)).vertex;
  CHECK(removability(mesh, bent) == Removability::bent);
  CHECK_FALSE(remove_vertex(mesh, bent).has_value());
}

TEST_CASE("a vertex on a curve, where segments meet or where one ends is refused") {
  Pslg pslg;
  pslg.entities.curves = {{1, {}, EllipseArc{{0, 0}, {1, 0}, {0, 1}, 0, std::numbers::pi}, {}}};
  pslg.points = {{1, 0}, {0, 1}, {-1, 0}};
  pslg.segments = {{VertexId(0U), VertexId(1U), CurveId(0U), 0, 0.5},
                   {VertexId(1U), VertexId(2U), CurveId(0U), 0.5, 1},
                   {VertexId(2U), VertexId(0U), {}, 0, 1}};
  Mesh mesh = constrained_delaunay(pslg).mesh;
  const HalfEdge arc = *mesh.find_edge(VertexId(0U), VertexId(1U));
  const VertexId v = insert_on_edge(mesh, arc, {0.5, 0.5}, origin_on(mesh, arc), 0.25).vertex;
  CHECK(removability(mesh, v) == Removability::curved);
  const HalfEdge diameter = *mesh.find_edge(VertexId(2U), VertexId(0U));
  const VertexId m = insert_on_edge(mesh, diameter, {0, 0}, origin_on(mesh, diameter)).vertex;
  CHECK(removability(mesh, m) == Removability::from_segment);
  REQUIRE(mesh.find_edge(m, VertexId(1U)).has_value());
  mesh.constrain(*mesh.find_edge(m, VertexId(1U)), {SegmentSetId(2U), 0, 1});
  CHECK(removability(mesh, m) == Removability::end_of_segments);
  mesh.set_record(m, VertexId(0U), {SegmentSetId(1U), 0, 1});
  mesh.set_constrained_flag(*mesh.find_edge(m, VertexId(1U)), false);
  mesh.set_constrained_flag(*mesh.twin(*mesh.find_edge(m, VertexId(1U))), false);
  CHECK(removability(mesh, m) == Removability::different_segments);
}

#include "lepp/triangulation/edges_by_group.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

constexpr GroupId wall(0U), interface_(1U), sensor(2U), crack(3U), material(4U), nothing(5U);

///   5 ------- 4 ------- 3    boundary: curve 0, group wall
///   |   6     |         |    1-4: curves 1 and 2 at once, both in group interface, 2 in sensor too
///   |     7   |         |    6-7: curve 3, group crack, inside the left region
///   0 ------- 1 ------- 2    left is surface 1, right is surface 0
Mesh two_rooms() {
  Pslg pslg = test::polygon({0, 0, 2, 0, 4, 0, 4, 2, 2, 2, 0, 2});
  for (Segment& s : pslg.segments) s.curve = CurveId(0U);
  test::add_chain(pslg, {{0.5, 1.5}, {1, 0.75}}, false);
  pslg.segments.back().curve = CurveId(3U);
  for (const std::uint32_t curve : {1U, 2U}) {
    pslg.segments.push_back({VertexId(1U), VertexId(4U), CurveId(curve), 0, 1});
  }
  pslg.entities.groups = {{1, 1, "wall"},  {1, 2, "interface"}, {1, 3, "sensor"},
                          {1, 4, "crack"}, {2, 1, "material"},  {1, 5, "of no curve"}};
  pslg.entities.curves = {{1, {wall}, StraightCurve{}, {}},
                          {2, {interface_}, StraightCurve{}, {}},
                          {3, {interface_, sensor}, StraightCurve{}, {}},
                          {4, {crack}, StraightCurve{}, {}}};
  pslg.entities.surfaces = {{1, {material}}, {2, {material}}};
  pslg.seeds = {{{0.1, 0.1}, SurfaceId(1U)}, {{3.9, 0.1}, SurfaceId(0U)}};
  Mesh mesh = constrained_delaunay(pslg).mesh;
  REQUIRE(refine(mesh, {.min_angle_deg = 28, .max_edge = 0.3}).goal_reached);
  REQUIRE(validate(mesh).summary() == "valid");
  return mesh;
}

double length(const Mesh& mesh, std::span<const HalfEdge> edges) {
  double sum = 0;
  for (const HalfEdge e : edges) {
    sum += std::sqrt(squared_distance(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e))));
  }
  return sum;
}

}  // namespace

TEST_CASE("the edges of a group are the pieces of its curves, once each") {
  const Mesh mesh = two_rooms();
  const GroupedEdges edges = edges_by_group(mesh);
  CHECK(length(mesh, edges.of(wall)) == doctest::Approx(12).epsilon(1e-12));
  CHECK(length(mesh, edges.of(interface_)) == doctest::Approx(2).epsilon(1e-12));
  CHECK(length(mesh, edges.of(sensor)) == doctest::Approx(2).epsilon(1e-12));
  CHECK(length(mesh, edges.of(crack)) == doctest::Approx(std::hypot(0.5, 0.75)).epsilon(1e-12));
  for (const GroupId group : {wall, interface_, sensor, crack}) {
    std::set<std::pair<VertexId, VertexId>> seen;
    for (const HalfEdge e : edges.of(group)) {
      CHECK(mesh.is_constrained(e));
      CHECK(seen.insert(std::minmax(mesh.origin(e), mesh.destination(e))).second);
    }
  }
}

TEST_CASE("groups without curves have no edges") {
  const GroupedEdges edges = edges_by_group(two_rooms());
  CHECK(edges.of(material).empty());
  CHECK(edges.of(nothing).empty());
}

TEST_CASE("edges are ascending, and the same in every run") {
  const Mesh mesh = two_rooms();
  const GroupedEdges edges = edges_by_group(mesh);
  const GroupedEdges again = edges_by_group(two_rooms());
  for (const GroupId group : {wall, interface_, sensor, crack}) {
    CHECK(edges.of(group).size() > 2);
    CHECK(std::ranges::is_sorted(edges.of(group)));
    CHECK(std::ranges::equal(edges.of(group), again.of(group)));
  }
}

TEST_CASE("boundary edges run with the mesh on their left, interface edges with the lower region") {
  const Mesh mesh = two_rooms();
  const GroupedEdges edges = edges_by_group(mesh);
  for (const HalfEdge e : edges.of(wall)) CHECK(mesh.is_boundary(e));
  for (const HalfEdge e : edges.of(interface_)) {
    CHECK(mesh.region(e.triangle) == SurfaceId(0U));
    CHECK(mesh.point(mesh.origin(e)).y > mesh.point(mesh.destination(e)).y);  // region 0: right
  }
  for (const HalfEdge e : edges.of(crack)) CHECK(e.triangle < mesh.twin(e)->triangle);
}

TEST_CASE("a mesh without groups has an empty index") {
  const Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  CHECK(mesh.entities().groups.empty());
  CHECK_NOTHROW(edges_by_group(mesh));
}

#include "lepp/triangulation/validate.hpp"

#include <doctest/doctest.h>

#include <set>

#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/hand_made.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

Mesh sound() { return constrained_delaunay(test::example_1()).mesh; }

// A refined mesh with all claims, for damages that need interior vertices.
Mesh refined() {
  Mesh mesh = constrained_delaunay(test::l_shape()).mesh;
  RefineOptions options;
  options.max_edge = 0.4;
  REQUIRE(refine(mesh, options).goal_reached);
  return mesh;
}

std::set<std::string> broken_rules(const Mesh& mesh, MeshClaims claims = {}) {
  std::set<std::string> rules;
  for (const MeshViolation& violation : validate(mesh, claims).violations)
    rules.insert(violation.rule);
  return rules;
}

using Rules = std::set<std::string>;

HalfEdge inner_edge(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!mesh.is_constrained(e)) return e;
    }
  }
  FAIL("no inner edge");
  return {};
}

HalfEdge boundary_edge(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (mesh.is_boundary({TriangleId(t), i})) return {TriangleId(t), i};
    }
  }
  FAIL("no boundary edge");
  return {};
}

}  // namespace

TEST_CASE("sound meshes are valid, with every claim that holds") {
  CHECK(validate(sound()).summary() == "valid");
  CHECK(validate(refined(), {.min_angle_deg = 30, .nonobtuse = true}).summary() == "valid");
}

TEST_CASE("M1 fails, and only M1, on a vertex of no triangle") {
  Mesh mesh = sound();
  mesh.add_vertex({50, 50}, {});
  CHECK(broken_rules(mesh) == Rules{"M1"});
}

TEST_CASE("M1 fails, and only M1, on a region that does not exist") {
  Mesh mesh = sound();
  mesh.set_region(TriangleId(0U), SurfaceId(7U));
  CHECK(broken_rules(mesh) == Rules{"M1"});
}

TEST_CASE("M2 fails, and only M2, when a vertex is moved across an edge") {
  Mesh mesh = refined();
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.origin_of(VertexId(v)).kind != VertexOrigin::Kind::interior) continue;
    mesh.move_vertex(VertexId(v), {-5, -5});
    break;
  }
  CHECK(broken_rules(mesh) == Rules{"M2"});
}

TEST_CASE("M3 fails, and only M3, when one side forgets its neighbour") {
  Mesh mesh = sound();
  mesh.unlink(inner_edge(mesh));
  CHECK(broken_rules(mesh) == Rules{"M3"});
}

TEST_CASE("M4 fails, and only M4, on a boundary edge that is not constrained") {
  Mesh mesh = test::from_triangles({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
  mesh.set_segments({});
  for (std::uint32_t i = 0; i < 3; ++i) mesh.set_constrained_flag({TriangleId(0U), i}, false);
  CHECK(broken_rules(mesh) == Rules{"M4"});
}

TEST_CASE("M4 fails, and only M4, when the sides of an edge disagree") {
  // The edge between two regions, constrained on one side only.
  Mesh mesh =
      test::from_triangles({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}, {0, 1});
  const HalfEdge e = *mesh.find_edge(VertexId(2U), VertexId(0U));
  REQUIRE(validate(mesh).valid());
  mesh.set_constrained_flag(std::max(e, *mesh.twin(e)), false);
  CHECK(broken_rules(mesh) == Rules{"M4"});
}

TEST_CASE("M1 fails, and only M1, on a segment between vertices that do not exist") {
  Mesh mesh = test::from_triangles({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
  mesh.set_segments({{VertexId(0U), VertexId(9U), {}, 0, 1}});
  CHECK(broken_rules(mesh) == Rules{"M1"});
}

TEST_CASE("M5 fails, and only M5, when a segment's chain has a gap") {
  Mesh mesh = refined();
  const HalfEdge e = boundary_edge(mesh);
  mesh.erase_record(mesh.origin(e), mesh.destination(e));
  CHECK(broken_rules(mesh) == Rules{"M5"});
}

TEST_CASE("M6 fails, and only M6, on an edge that is not locally Delaunay") {
  const Mesh mesh =
      test::from_triangles({{-2, 0}, {0, -1}, {2, 0}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK(broken_rules(mesh) == Rules{"M6"});
  CHECK(validate(mesh, {.delaunay = false}).valid());
}

TEST_CASE("M7 fails, and only M7, below the claimed bound; a reason that holds excuses") {
  const Mesh mesh = constrained_delaunay(test::polygon({0, 0, 10, 0, 10, 1})).mesh;
  CHECK(broken_rules(mesh, {.min_angle_deg = 30}) == Rules{"M7"});
  const Unfinished forced{TriangleId(0U), Reason::input_angle};
  CHECK(validate(mesh, {.min_angle_deg = 30, .unfinished = {forced}}).valid());
}

TEST_CASE("M7 does not take a reason that blames the input without cause") {
  const Mesh mesh = constrained_delaunay(test::polygon({0, 0, 1, 0, 1, 2, 0, 2})).mesh;
  std::vector<Unfinished> claimed;
  for (std::size_t t = 0; t < 2; ++t) claimed.push_back({TriangleId(t), Reason::input_angle});
  CHECK(broken_rules(mesh, {.min_angle_deg = 30, .unfinished = claimed}) == Rules{"M7"});
}

TEST_CASE("an input angle excuses no obtuse angle") {
  const Mesh mesh = test::from_triangles({{0, 0}, {4, 0}, {3.6, 0.65}}, {{0, 1, 2}});
  const Unfinished claimed{TriangleId(0U), Reason::input_angle};
  CHECK(broken_rules(mesh, {.min_angle_deg = 30, .nonobtuse = true, .unfinished = {claimed}}) ==
        Rules{"M8"});
}

TEST_CASE("M8 fails, and only M8, on an obtuse angle opposite a constrained edge") {
  const Mesh mesh = test::from_triangles({{0, 0}, {4, 0}, {2, 1}}, {{0, 1, 2}});
  CHECK(broken_rules(mesh, {.nonobtuse = true}) == Rules{"M8"});
  const Mesh right = test::from_triangles({{0, 0}, {4, 0}, {2, 2}}, {{0, 1, 2}});
  CHECK(validate(right, {.nonobtuse = true}).valid());
}

TEST_CASE(
    "M9 fails, and only M9, on any angle above the claimed bound; a right angle is not above 90") {
  const Mesh mesh = test::from_triangles({{0, 0}, {4, 0}, {2, 1}}, {{0, 1, 2}});
  CHECK(broken_rules(mesh, {.max_angle_deg = 90}) == Rules{"M9"});
  CHECK(broken_rules(mesh, {.max_angle_deg = 126}) == Rules{"M9"});
  CHECK(validate(mesh, {.max_angle_deg = 127}).valid());
  const Unfinished claimed{TriangleId(0U), Reason::input_angle};
  CHECK(broken_rules(mesh, {.max_angle_deg = 90, .unfinished = {claimed}}) == Rules{"M9"});
  const Unfinished stopped{TriangleId(0U), Reason::budget};
  CHECK(validate(mesh, {.max_angle_deg = 90, .unfinished = {stopped}}).valid());
  const Mesh right = test::from_triangles({{0, 0}, {4, 0}, {2, 2}}, {{0, 1, 2}});
  CHECK(validate(right, {.max_angle_deg = 90}).valid());
}

#include "lepp/refine/clean_up.hpp"

#include <doctest/doctest.h>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "lepp/triangulation/unfinished.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

void add(Mesh& mesh, Point p) {
  Cavity cavity;
  REQUIRE(cavity.find(mesh, locate(mesh, p)->triangle, p));
  cavity.fill(mesh, p, {VertexOrigin::Kind::interior, 0});
}

void clean(Mesh& mesh, Effort effort) {
  RefineOptions options;
  options.effort = effort;
  CleanUp(mesh, options, default_size_floor(mesh)).run();
  CHECK(validate(mesh, {.min_angle_deg = 30, .nonobtuse = true}).summary() == "valid");
}

}  // namespace

TEST_CASE("a Steiner point inside that no bound needs is removed") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  add(mesh, {0.5, 0.5});
  clean(mesh, Effort::normal);
  CHECK(mesh.vertex_count() == 4);
}

TEST_CASE("a Steiner point on a segment is removed if the whole edge is not encroached") {
  Mesh mesh = constrained_delaunay(test::polygon({0, 0, 2, 0, 1, 1.8})).mesh;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{TriangleId(0U), i};
    if (mesh.point(mesh.origin(e)) == Point{0, 0}) split_halfway(mesh, e, 0);
  }
  REQUIRE(mesh.vertex_count() == 4);
  clean(mesh, Effort::normal);
  CHECK(mesh.vertex_count() == 3);
}

TEST_CASE("a Steiner point that an angle needs stays") {
  Mesh mesh = constrained_delaunay(test::polygon({0, 0, 2, 0, 2, 1, 0, 1})).mesh;
  RefineOptions options;
  options.effort = Effort::fast;
  REQUIRE(refine(mesh, options).goal_reached);
  const std::size_t before = mesh.vertex_count();
  REQUIRE(before > 4);
  clean(mesh, Effort::best);
  CHECK(mesh.vertex_count() > 4);
  CHECK(mesh.vertex_count() <= before);
}

TEST_CASE("one vertex takes the place of two") {
  Mesh mesh = constrained_delaunay(test::polygon({0, 0, 2, -1, 4, 0, 4, 2, 2, 3, 0, 2})).mesh;
  for (const Point p : {Point{1.6, 1}, Point{2.4, 1}}) add(mesh, p);
  Mesh normal = mesh;
  clean(mesh, Effort::best);
  CHECK(mesh.vertex_count() <= 7);
  clean(normal, Effort::normal);
  CHECK(normal.vertex_count() >= mesh.vertex_count());
}

#include "lepp/triangulation/relocate.hpp"

#include <doctest/doctest.h>

#include <random>

#include "lepp/triangulation/cavity.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

// A square with random vertices inside.
Mesh filled_square(std::mt19937_64& random, int vertices) {
  std::uniform_real_distribution<double> coordinate(0.01, 0.99);
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  Cavity cavity;
  for (int i = 0; i < vertices; ++i) {
    const Point p{coordinate(random), coordinate(random)};
    REQUIRE(cavity.find(mesh, locate(mesh, p)->triangle, p));
    cavity.fill(mesh, p, {VertexOrigin::Kind::interior, 0});
  }
  return mesh;
}

}  // namespace

TEST_CASE("a vertex moved anywhere it sees its link leaves a constrained Delaunay mesh") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> offset(-0.2, 0.2);
  Mesh mesh = filled_square(random, 60);
  Star star;
  std::size_t moved = 0;
  for (int i = 0; i < 600; ++i) {
    const VertexId v(4 + random() % 60);
    const HalfEdge e = mesh.leaving(v);
    REQUIRE(find_star(mesh, e.triangle, next_corner(e.edge), star));
    const Point p = mesh.point(v) + Point{offset(random), offset(random)};
    if (!sees_link(star, p)) continue;
    std::vector<TriangleId> changed;
    move_vertex(mesh, v, star, p, changed);
    CHECK(mesh.point(v) == p);
    CHECK(changed.size() >= star.size());
    ++moved;
  }
  CHECK(moved > 100);
  CHECK(validate(mesh).summary() == "valid");
}

TEST_CASE("a star goes once around its center, with the link counter-clockwise") {
  std::mt19937_64 random(6);
  const Mesh mesh = filled_square(random, 30);
  Star star;
  for (std::uint32_t i = 4; i < 34; ++i) {
    const HalfEdge e = mesh.leaving(VertexId(i));
    REQUIRE(find_star(mesh, e.triangle, next_corner(e.edge), star));
    std::size_t degree = 0;
    for_each_in_fan(mesh, VertexId(i), [&](TriangleId, std::uint32_t) { ++degree; });
    CHECK(star.size() == degree);
    CHECK(sees_link(star, mesh.point(VertexId(i))));
  }
}

TEST_CASE("a vertex with a constrained edge has no star") {
  const Mesh mesh = constrained_delaunay(test::l_shape()).mesh;
  Star star;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const HalfEdge e = mesh.leaving(VertexId(v));
    CHECK_FALSE(find_star(mesh, e.triangle, next_corner(e.edge), star));
  }
}

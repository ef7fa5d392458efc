#include "lepp/triangulation/encroached.hpp"

#include <doctest/doctest.h>

#include <random>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/split.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

std::vector<HalfEdge> constrained_edges(const Mesh& mesh) {
  std::vector<HalfEdge> edges;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (mesh.is_constrained(e)) edges.push_back(e);
    }
  }
  return edges;
}

}  // namespace

TEST_CASE("encroached means an obtuse angle opposite: a right angle does not count") {
  Pslg pslg = test::polygon({0, 0, 4, 0, 4, 4, 0, 4});
  SUBCASE("right") {
    pslg.points.push_back({2, 2});
    const Mesh mesh = constrained_delaunay(pslg).mesh;
    for (const HalfEdge e : constrained_edges(mesh)) CHECK_FALSE(is_encroached(mesh, e));
    CHECK_FALSE(EncroachedEdges(mesh).next(mesh).has_value());
  }
  SUBCASE("obtuse") {
    pslg.points.push_back({2, 1.9999999});
    const Mesh mesh = constrained_delaunay(pslg).mesh;
    const auto e = EncroachedEdges(mesh).next(mesh);
    REQUIRE(e.has_value());
    CHECK(mesh.point(mesh.origin(*e)).y == 0);
    CHECK(mesh.point(mesh.destination(*e)).y == 0);
    CHECK(is_encroached(mesh, *e));
  }
}

TEST_CASE("edges_encroached_by foretells what an insertion encroaches") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int foretold = 0;
  for (int i = 0; i < 400; ++i) {
    const Mesh mesh = constrained_delaunay(test::random_star(random)).mesh;
    const Point p{uniform(random), uniform(random)};
    const auto place = locate(mesh, p);
    if (!place || place->on_edge) continue;
    std::size_t expected = 0;
    Mesh copy = mesh;
    const Insertion done = insert_in_triangle(copy, place->triangle, p, {});
    for (const HalfEdge e : constrained_edges(copy)) {
      if (copy.apex(e) == done.vertex && faces_obtuse_angle(copy, e)) ++expected;
    }
    REQUIRE(edges_encroached_by(mesh, place->triangle, p).size() == expected);
    foretold += expected > 0 ? 1 : 0;
  }
  CHECK(foretold > 20);
}

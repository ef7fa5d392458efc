#include "lepp/triangulation/lepp.hpp"

#include <doctest/doctest.h>

#include <random>
#include <set>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

// Proposition 1 of the paper, for one triangle.
void check_proposition_1(const Mesh& mesh, TriangleId start) {
  const LeppPath path = lepp_path(mesh, start);
  REQUIRE(path.triangles.front() == start);
  REQUIRE(path.terminal.triangle == path.triangles.back());
  const std::set<TriangleId> distinct(path.triangles.begin(), path.triangles.end());
  REQUIRE(distinct.size() == path.triangles.size());  // (a) finite, nothing twice
  for (std::size_t i = 0; i + 1 < path.triangles.size(); ++i) {
    const HalfEdge here = longest_edge(mesh, path.triangles[i]);
    const HalfEdge there = longest_edge(mesh, path.triangles[i + 1]);
    REQUIRE(mesh.twin(here)->triangle == path.triangles[i + 1]);
    REQUIRE(edge_key(mesh, here) < edge_key(mesh, there));  // (b) strictly growing
  }
  const bool boundary = mesh.is_constrained(path.terminal);
  const auto across = mesh.twin(path.terminal);
  REQUIRE((boundary || longest_edge(mesh, across->triangle) == *across));  // (c)
  REQUIRE(terminal_edge(mesh, start) == path.terminal);
}

void check_all(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) check_proposition_1(mesh, TriangleId(t));
}

Mesh mesh_of_points(const std::vector<Point>& points) {
  Pslg pslg;
  pslg.points = points;
  return constrained_delaunay(pslg).mesh;
}

}  // namespace

TEST_CASE("Proposition 1 holds for 1e5 triangles of random points") {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> uniform;
  std::vector<Point> points;
  for (int i = 0; i < 50'100; ++i) points.push_back({uniform(random), uniform(random)});
  const Mesh mesh = mesh_of_points(points);
  REQUIRE(mesh.triangle_count() > 100'000);
  check_all(mesh);
}

TEST_CASE("Proposition 1 holds where all edges tie: square, rotated and equilateral grids") {
  std::vector<Point> square, equilateral;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) {
      square.push_back({1.0 * i, 1.0 * j});
      equilateral.push_back({i + 0.5 * (j % 2), j * 0.8660254037844386});
    }
  }
  check_all(mesh_of_points(square));
  check_all(mesh_of_points(test::rotated_grid(60)));
  check_all(mesh_of_points(equilateral));
}

TEST_CASE("the longest edge does not depend on the order of the points") {
  std::vector<Point> points{{0, 0}, {1, 0}, {0.5, 0.75}};
  const Mesh one = mesh_of_points(points);
  std::swap(points[0], points[2]);
  const Mesh other = mesh_of_points(points);
  const TriangleId t(0U);
  CHECK(edge_key(one, longest_edge(one, t)) == edge_key(other, longest_edge(other, t)));
}

TEST_CASE("an interface ends the path although a triangle lies beyond") {
  Pslg pslg = test::polygon({0, 0, 1, -0.4, 2, 0, 1, 0.4});
  test::add_chain(pslg, {{0, 0}, {2, 0}}, false);
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const LeppPath path = lepp_path(mesh, TriangleId(t));
    CHECK(path.triangles.size() == 1);
    CHECK_FALSE(mesh.is_boundary(path.terminal));
    CHECK(mesh.is_constrained(path.terminal));
  }
}

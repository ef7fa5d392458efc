#include "lepp/triangulation/split_constrained.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

// A polygon around the origin with a spoke to each corner: `n` wedges of a full circle. Spokes have
// different lengths.
Pslg wheel(std::uint32_t n) {
  Pslg pslg;
  pslg.points.push_back({0, 0});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, radius = 1 + 0.5 * (i % 7) / 7.0;
    pslg.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  for (std::uint32_t i = 1; i <= n; ++i) {
    pslg.segments.push_back({VertexId(0U), VertexId(i), std::nullopt, 0, 1});
    pslg.segments.push_back({VertexId(i), VertexId(i % n + 1), std::nullopt, 0, 1});
  }
  return pslg;
}

// Cuts the fan at the origin by way of spoke `i`, and returns how many spokes it cut.
std::size_t cut_spoke(Mesh& mesh, std::uint32_t i) {
  return split_constrained_edge(mesh, *mesh.find_edge(VertexId(0U), VertexId(i)), 0)
      .vertices.size();
}

}  // namespace

TEST_CASE("all spokes of a full circle are cut at one radius, whichever comes first") {
  for (const std::uint32_t first : {1U, 4U, 9U}) {
    CAPTURE(first);
    Mesh mesh = constrained_delaunay(wheel(9)).mesh;
    CHECK(cut_spoke(mesh, first) == 9);
    CHECK(validate(mesh, {.delaunay = false}).summary() == "valid");
    const double radius = std::sqrt(squared_distance({0, 0}, mesh.point(VertexId(10U))));
    for (std::size_t v = 10; v < mesh.vertex_count(); ++v) {
      CHECK(std::sqrt(squared_distance({0, 0}, mesh.point(VertexId(v)))) ==
            doctest::Approx(radius));
    }
  }
}

TEST_CASE("an open fan is cut on both sides of the spoke that comes first") {
  Pslg pslg = wheel(12);  // keep three quarters of the circle
  pslg.segments.erase(pslg.segments.begin() + 19, pslg.segments.end());
  for (const std::uint32_t first : {1U, 5U, 10U}) {
    CAPTURE(first);
    Mesh mesh = constrained_delaunay(pslg).mesh;
    CHECK(cut_spoke(mesh, first) == 10);
    CHECK(validate(mesh, {.delaunay = false}).summary() == "valid");
  }
}

TEST_CASE("cutting a fan of thousands of spokes takes time in proportion") {
  Mesh mesh = constrained_delaunay(wheel(4000)).mesh;
  CHECK(cut_spoke(mesh, 1) == 4000);
}

TEST_CASE("a cut of a boundary edge never lies outside it, so the area never grows") {
  test::Random random(5);
  std::size_t on_the_line = 0, cuts = 0;
  for (int round = 0; round < 2000; ++round) {
    const auto coordinate = [&] { return 40 + random.real(); };
    const Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    Point c{coordinate(), coordinate()};
    if (orient2d(a, b, c) <= 0) c = a + b - c;
    Mesh mesh = constrained_delaunay(test::polygon({a.x, a.y, b.x, b.y, c.x, c.y})).mesh;
    const HalfEdge e = *mesh.find_edge(VertexId(0U), VertexId(1U));
    const double length = std::sqrt(squared_distance(a, b));
    const ConstrainedSplit done = round % 2 == 0
                                      ? split_halfway(mesh, e, 0)
                                      : split_at_distance(mesh, e, VertexId(1U), 0.3 * length, 0);
    if (done.vertices.empty()) continue;
    ++cuts;
    const Point p = mesh.point(done.vertices.front());
    CHECK(orient2d(a, b, p) >= 0);
    const Point meant = round % 2 == 0 ? midpoint(a, b) : b + 0.3 * (a - b);
    CHECK(std::abs(p.x - meant.x) < 5e-14);
    CHECK(std::abs(p.y - meant.y) < 5e-14);
    if (orient2d(a, b, p) == 0) ++on_the_line;
  }
  CHECK(cuts > 1990);
  CHECK(on_the_line < cuts / 2);
}

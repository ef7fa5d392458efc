#include "lepp/bisection/forest.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "bisection/random_forest.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// Shapes of triangles, told apart by the squared ratios of their sides.
std::size_t count_shapes(const Mesh& mesh) {
  std::vector<std::array<double, 2>> shapes;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    std::array sides{squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)};
    std::ranges::sort(sides);
    const std::array shape{sides[0] / sides[2], sides[1] / sides[2]};
    const bool is_new = std::ranges::none_of(shapes, [&](const std::array<double, 2>& known) {
      return std::abs(known[0] - shape[0]) < 1e-6 && std::abs(known[1] - shape[1]) < 1e-6;
    });
    if (is_new) shapes.push_back(shape);
  }
  return shapes.size();
}

Mesh mesh_of(const Pslg& pslg) { return constrained_delaunay(pslg).mesh; }

std::size_t shapes_of(const Pslg& pslg, BisectionRule rule, int rounds) {
  Forest forest(mesh_of(pslg), rule);
  for (int i = 0; i < rounds; ++i) forest.bisect(all_triangles(forest.mesh()));
  return count_shapes(forest.mesh());
}

}  // namespace

TEST_CASE("descendants of a right isosceles triangle have one shape, of an equilateral one three") {
  CHECK(shapes_of(polygon({0, 0, 1, 0, 0, 1}), BisectionRule::longest_edge, 8) == 1);
  const double height = std::sqrt(3.0) / 2;
  CHECK(shapes_of(polygon({0, 0, 1, 0, 0.5, height}), BisectionRule::longest_edge, 8) == 3);
}

TEST_CASE("newest vertices leave at most four shapes in each root") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> coordinate(0, 1);
  for (int i = 0; i < 50; ++i) {
    const Point p{coordinate(random), coordinate(random)};
    if (p.y < 0.05) continue;
    CHECK(shapes_of(polygon({0, 0, 1, 0, p.x, p.y}), BisectionRule::newest_vertex, 8) <= 4);
  }
}

TEST_CASE("a cut keeps ids: the first half has the id of the whole, vertices stay") {
  const Mesh start = mesh_of(unit_square());
  Forest forest(start);
  const TriangleId t(0U);
  const Refinement done = forest.bisect(std::array{t});
  REQUIRE(done.vertices.size() == 1);
  REQUIRE(done.triangles.size() == 2);  // the diagonal is the longest edge of both
  CHECK(done.vertices[0].vertex == VertexId(4U));
  CHECK(forest.mesh().point(VertexId(4U)) == Point{0.5, 0.5});
  CHECK(done.triangles[0].whole == t);
  CHECK(done.triangles[0].other == TriangleId(2U));
  CHECK(forest.generation(t) == 1);
  CHECK(forest.root(TriangleId(2U)) == t);
  CHECK(forest.sibling(t) == TriangleId(2U));
  CHECK(forest.mesh().origin_of(VertexId(4U)).kind == VertexOrigin::Kind::interior);
}

TEST_CASE("a triangle that is marked twice, or cut with its neighbour, is cut once") {
  Forest forest(mesh_of(unit_square()));
  const std::array marked{TriangleId(0U), TriangleId(1U), TriangleId(0U)};
  CHECK(forest.bisect(marked).vertices.size() == 1);
  CHECK(forest.mesh().triangle_count() == 4);
}

TEST_CASE("an edge with no double well inside is refused, and all that needs it cut") {
  const double next = std::nextafter(1.0, 2.0);
  Pslg pslg = polygon({1, 1, next, 1, 1, next});
  Forest forest(mesh_of(pslg));
  const Refinement done = forest.bisect(std::array{TriangleId(0U)});
  CHECK(done.vertices.empty());
  CHECK(done.refused == std::vector{TriangleId(0U)});
  CHECK(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
  CHECK(forest.bisect(std::array{TriangleId(0U)}).refused.size() == 1);  // nothing sticks
}

TEST_CASE("vertices on a bent boundary follow the curve if asked to, else the chord") {
  Pslg pslg = polygon({1, 0, 0, 1, -1, 0, 0, -1});
  const double pi = std::acos(-1.0);
  pslg.entities.curves.push_back({});
  pslg.entities.curves[0].geometry = EllipseArc{{0, 0}, {1, 0}, {0, 1}, 0, 2 * pi};
  for (std::size_t i = 0; i < 4; ++i) {
    pslg.segments[i].curve = CurveId(0U);
    pslg.segments[i].t_a = 0.25 * static_cast<double>(i);
    pslg.segments[i].t_b = 0.25 * static_cast<double>(i + 1);
  }
  const Mesh start = mesh_of(pslg);
  for (const bool follow : {false, true}) {
    Forest forest(start);
    for (int i = 0; i < 8; ++i) {
      forest.bisect(all_triangles(forest.mesh()), {.follow_curves = follow});
    }
    const Mesh& mesh = forest.mesh();
    CHECK(validate(mesh, {.delaunay = false}).summary() == "valid");
    double farthest = 0;
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
      if (mesh.origins()[i].kind == VertexOrigin::Kind::interior) continue;
      farthest =
          std::max(farthest, std::abs(1 - std::sqrt(dot(mesh.points()[i], mesh.points()[i]))));
    }
    CHECK((follow ? farthest < 1e-12 : farthest > 0.2));
    while (!forest.coarsen(all_triangles(forest.mesh())).vertices.empty()) {
    }
    CHECK(forest.mesh().vertex_count() == start.vertex_count());
  }
}

TEST_CASE("a vertex on a bent interface is the same from whichever side it is asked for") {
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> angle(0, 1), radius(0.3, 2.5);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    Pslg pslg = polygon({-4, 0, 0, -4, 4, 0, 0, 4});
    const double start = angle(random), sweep = 0.5 + angle(random), r = radius(random);
    const auto on_circle = [&](double a) { return Point{r * std::cos(a), r * std::sin(a)}; };
    pslg.points.push_back(on_circle(start));
    pslg.points.push_back(on_circle(start + sweep));
    pslg.entities.curves.push_back({});
    pslg.entities.curves[0].geometry = EllipseArc{{0, 0}, {r, 0}, {0, r}, start, sweep};
    pslg.segments.push_back({VertexId(4U), VertexId(5U), CurveId(0U), 0, 1});
    const Mesh mesh = mesh_of(pslg);
    HalfEdge bent = *mesh.find_edge(VertexId(4U), VertexId(5U));
    std::vector<Point> middles;
    for (int side = 0; side < 2; ++side, bent = *mesh.twin(bent)) {
      Forest forest(mesh);
      while (forest.mesh().find_edge(VertexId(4U), VertexId(5U))) {
        const HalfEdge e = side == 0 ? *forest.mesh().find_edge(VertexId(4U), VertexId(5U))
                                     : *forest.mesh().find_edge(VertexId(5U), VertexId(4U));
        const Refinement done =
            forest.bisect(std::array{e.triangle}, {.follow_curves = true, .threads = 1});
        REQUIRE(!done.vertices.empty());
        for (const NewVertex& v : done.vertices) {
          if (std::minmax({v.a, v.b}) != std::minmax({VertexId(4U), VertexId(5U)})) continue;
          middles.push_back(forest.mesh().point(v.vertex));
        }
      }
    }
    REQUIRE(middles.size() == 2);
    CHECK(middles[0] == middles[1]);
  }
}

TEST_CASE("a limit on vertices is met exactly, and the mesh conforms") {
  std::mt19937_64 random(15);
  const Mesh start = integer_mesh(random, 20);
  for (const std::size_t more : {0U, 1U, 7U, 50U}) {
    Forest forest(start);
    const std::size_t limit = start.vertex_count() + more;
    const Refinement done = forest.bisect(all_triangles(start), {.max_vertices = limit});
    const bool enough = forest.mesh().vertex_count() < limit;
    CHECK(done.limited != enough);
    CHECK(done.vertices.size() == forest.mesh().vertex_count() - start.vertex_count());
    CHECK(forest.mesh().vertex_count() <= limit);
    CHECK(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
    const Refinement rest = forest.bisect(all_triangles(start));  // no mark is forgotten
    CHECK_FALSE(rest.limited);
    for (const TriangleId t : all_triangles(start)) CHECK(forest.generation(t) >= 1);
  }
}

TEST_CASE("regions, segments and their parameters go to the parts") {
  std::mt19937_64 random(12);
  const Mesh start = integer_mesh(random, 20);
  Forest forest(start);
  for (int i = 0; i < 4; ++i) forest.bisect(all_triangles(forest.mesh()));
  const Mesh& mesh = forest.mesh();
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    CHECK(mesh.region(TriangleId(t)) == start.region(forest.root(TriangleId(t))));
  }
  CHECK(validate(mesh, {.delaunay = false}).summary() == "valid");  // M5: segments are chains
}

TEST_CASE("a log replayed gives every vertex between its ends, and triangle counts") {
  std::mt19937_64 random(13);
  Forest forest(integer_mesh(random, 10));
  for (int round = 0; round < 10; ++round) {
    std::vector<Point> points(forest.mesh().points().begin(), forest.mesh().points().end());
    std::size_t triangles = forest.mesh().triangle_count();
    if (round % 3 != 2) {
      const Refinement done = forest.bisect(some_triangles(random, forest.mesh(), 8));
      for (const NewVertex& v : done.vertices) {
        REQUIRE(v.vertex.index() == points.size());
        points.push_back(midpoint(points[v.a.index()], points[v.b.index()]));
      }
      for (const Halves& h : done.triangles) {
        REQUIRE(h.other.index() == triangles++);
        REQUIRE(h.whole.index() < h.other.index());
      }
    } else {
      const Coarsening done = forest.coarsen(all_triangles(forest.mesh()));
      for (const NewVertex& v : done.vertices) {
        CHECK(points[v.vertex.index()] == midpoint(points[v.a.index()], points[v.b.index()]));
        points[v.vertex.index()] = points.back();
        points.pop_back();
      }
      triangles -= done.triangles.size();
    }
    REQUIRE(std::ranges::equal(points, forest.mesh().points()));
    REQUIRE(triangles == forest.mesh().triangle_count());
  }
}

TEST_CASE("coarsening brings back ids at a vertex where two parts of the domain only touch") {
  Pslg pslg = polygon({0, 0, 2, -1, 2, 1});
  for (const Point p : {Point{-2, 1}, Point{-2, -1}}) pslg.points.push_back(p);
  for (const auto& [a, b] : {std::pair{0U, 3U}, {3U, 4U}, {4U, 0U}}) {
    pslg.segments.push_back({VertexId(a), VertexId(b), {}, 0, 1});
  }
  const Mesh start = mesh_of(pslg);
  REQUIRE(start.triangle_count() == 2);
  Forest forest(start);
  for (int i = 0; i < 4; ++i) forest.bisect(all_triangles(forest.mesh()));
  while (!forest.coarsen(all_triangles(forest.mesh())).vertices.empty()) {
  }
  const Mesh& mesh = forest.mesh();
  CHECK(std::ranges::equal(mesh.points(), start.points()));
  REQUIRE(mesh.triangle_count() == start.triangle_count());
  for (const TriangleId t : all_triangles(start)) CHECK(mesh.vertices(t) == start.vertices(t));
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {  // any fan will do
    CHECK(mesh.origin(mesh.leaving(VertexId(v))) == VertexId(v));
  }
  CHECK(validate(mesh, {.delaunay = false}).summary() == "valid");
}

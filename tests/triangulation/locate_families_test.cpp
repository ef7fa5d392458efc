// locate(), Locator and batches against a look at every triangle, on every family of inputs.

#include <doctest/doctest.h>

#include <algorithm>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/locator.hpp"
#include "lepp/triangulation/split.hpp"
#include "support/gen_pslg.hpp"
#include "support/random.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

std::optional<Mesh> mesh_of(Family family, std::uint64_t seed) {
  try {
    return constrained_delaunay(generate_pslg(family, seed), {.crossings = Crossings::split}).mesh;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// Vertices, places on edges and inside triangles, and others anywhere in and around the mesh.
std::vector<Point> queries(const Mesh& mesh, Random& random) {
  std::vector<Point> points;
  Point low = mesh.point(VertexId(0U)), high = low;
  for (const Point p : mesh.points()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Point size = high - low;
  for (int i = 0; i < 12; ++i) {
    const TriangleId t(
        std::size_t{random.below(static_cast<std::uint32_t>(mesh.triangle_count()))});
    const auto [a, b, c] = mesh.corners(t);
    points.insert(points.end(), {a, midpoint(b, c), midpoint(midpoint(a, b), c)});
    points.push_back(
        {low.x + random.real(-0.1, 1.1) * size.x, low.y + random.real(-0.1, 1.1) * size.y});
  }
  for (Point& p : points) p = in_supported_range(p);
  return points;
}

std::vector<TriangleId> holders(const Mesh& mesh, Point p) {
  std::vector<TriangleId> found;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    if (orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0) {
      found.emplace_back(t);
    }
  }
  return found;
}

bool is_right(const Mesh& mesh, Point p, const std::optional<Location>& place) {
  const auto found = holders(mesh, p);
  if (!place) return found.empty();
  if (std::ranges::find(found, place->triangle) == found.end()) return false;
  bool on_edge = false, at_vertex = false;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{place->triangle, i};
    const bool here = orient2d(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)), p) == 0;
    if (place->on_edge == e && !here) return false;
    on_edge = on_edge || here;
    const VertexId v = mesh.vertex(place->triangle, i);
    if ((mesh.point(v) == p) != (place->at_vertex == v)) return false;
    at_vertex = at_vertex || mesh.point(v) == p;
  }
  return place->on_edge.has_value() == on_edge && place->at_vertex.has_value() == at_vertex;
}

}  // namespace

TEST_CASE("locate, Locator and batches agree with a look at every triangle") {
  Random random(20);
  int meshes = 0, outside = 0, at_vertices = 0, on_edges = 0;
  for (std::size_t family = 0; family < family_names.size(); ++family) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      CAPTURE(family_names[family]);
      CAPTURE(seed);
      const auto mesh = mesh_of(Family(family), seed);
      if (!mesh) continue;
      ++meshes;
      const auto points = queries(*mesh, random);
      const Locator locator(*mesh);
      REQUIRE(locator.size() <= 4 * mesh->triangle_count());
      const auto places = locate(*mesh, points);
      REQUIRE(places.size() == points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        CAPTURE(points[i].x);
        CAPTURE(points[i].y);
        const TriangleId hint(
            std::size_t{random.below(static_cast<std::uint32_t>(mesh->triangle_count()))});
        REQUIRE(is_right(*mesh, points[i], locate(*mesh, points[i], hint)));
        REQUIRE(is_right(*mesh, points[i], locator.locate(points[i])));
        REQUIRE(is_right(*mesh, points[i], places[i]));
        outside += places[i] ? 0 : 1;
        at_vertices += places[i] && places[i]->at_vertex ? 1 : 0;
        on_edges += places[i] && places[i]->on_edge && !places[i]->at_vertex ? 1 : 0;
      }
    }
  }
  CHECK(meshes > 500);
  CHECK(outside > 1000);
  CHECK(at_vertices > 1000);
  CHECK(on_edges > 1000);
}

#include "lepp/triangulation/half_edges_by_origin.hpp"

#include <doctest/doctest.h>

using namespace lepp;

namespace {

// `n` triangles around vertex 0, not linked to one another.
Mesh wheel(std::uint32_t n) {
  Mesh mesh;
  for (std::uint32_t v = 0; v <= n; ++v) mesh.add_vertex({1.0 * v, 0}, {});
  for (std::uint32_t i = 1; i <= n; ++i) {
    mesh.add_triangle(VertexId(0U), VertexId(i), VertexId(i % n + 1), SurfaceId(0U));
  }
  return mesh;
}

}  // namespace

TEST_CASE("half-edges are found by their ends, around small vertices and hubs") {
  for (const std::uint32_t n : {3U, 40U}) {
    const Mesh mesh = wheel(n);
    const HalfEdgesByOrigin leaving(mesh);
    CHECK(leaving.repeated().empty());
    for (std::uint32_t i = 1; i <= n; ++i) {
      CHECK(leaving.has(VertexId(0U), VertexId(i)));
      CHECK(leaving.has(VertexId(i), VertexId(0U)));
      CHECK(leaving.has(VertexId(i), VertexId(i % n + 1)));
      if (n > 3) CHECK_FALSE(leaving.has(VertexId(i % n + 1), VertexId(i)));
    }
  }
}

TEST_CASE("a side that two triangles have is found, around small vertices and hubs") {
  for (const std::uint32_t n : {3U, 40U}) {
    Mesh mesh = wheel(n);
    const VertexId extra = mesh.add_vertex({0, 1}, {});
    const TriangleId t = mesh.add_triangle(VertexId(0U), VertexId(2U), extra, SurfaceId(0U));
    const auto repeated = HalfEdgesByOrigin(mesh).repeated();
    REQUIRE(repeated.size() == 1);
    CHECK(repeated[0].triangle == t);
    CHECK(mesh.origin(repeated[0]) == VertexId(0U));
    CHECK(mesh.destination(repeated[0]) == VertexId(2U));
  }
}

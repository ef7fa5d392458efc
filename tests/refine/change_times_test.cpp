#include "lepp/refine/change_times.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/shapes.hpp"

using namespace lepp;

TEST_CASE("a vertex is due until something was tried there, and again once its star changes") {
  const Mesh mesh = constrained_delaunay(test::unit_square()).mesh;  // two triangles
  ChangeTimes times(mesh);
  const auto [a, b, c] = mesh.vertices(TriangleId(0U));
  CHECK(times.is_due(a));
  CHECK_FALSE(times.was_tried_beside(a, b));
  times.tried(a);
  CHECK_FALSE(times.is_due(a));
  CHECK(times.is_due(b));
  CHECK(times.was_tried_beside(b, a));
  times.changed(std::array{TriangleId(0U)});
  CHECK(times.is_due(a));
  CHECK_FALSE(times.was_tried_beside(b, a));
}

TEST_CASE("a change at one of two vertices makes a try beside the other worth while again") {
  const Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  ChangeTimes times(mesh);
  VertexId alone, shared;  // a corner of one triangle, and one of both
  for (const VertexId v : mesh.vertices(TriangleId(0U))) {
    const auto& other = mesh.vertices(TriangleId(1U));
    (std::ranges::find(other, v) == other.end() ? alone : shared) = v;
  }
  times.tried(alone);
  CHECK(times.was_tried_beside(shared, alone));
  times.changed(std::array{TriangleId(1U)});
  CHECK_FALSE(times.is_due(alone));
  CHECK(times.is_due(shared));
  CHECK_FALSE(times.was_tried_beside(shared, alone));
}

TEST_CASE("the last vertex keeps its times when it takes the place of a removed one") {
  const Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  ChangeTimes times(mesh);
  times.tried(VertexId(3U));
  times.removed(VertexId(1U));
  CHECK_FALSE(times.is_due(VertexId(1U)));
  CHECK(times.is_due(VertexId(2U)));
  times.added();
  CHECK(times.is_due(VertexId(3U)));
}

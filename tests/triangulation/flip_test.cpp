#include "lepp/triangulation/flip.hpp"

#include <doctest/doctest.h>

#include "lepp/triangulation/validate.hpp"
#include "support/hand_made.hpp"

using namespace lepp;

namespace {

// A flat rhombus cut along its long diagonal, which is not Delaunay.
Mesh rhombus() {
  return test::from_triangles({{-2, 0}, {0, -1}, {2, 0}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
}

HalfEdge diagonal(const Mesh& mesh) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (!mesh.is_boundary({TriangleId(0U), i})) return {TriangleId(0U), i};
  }
  FAIL("no diagonal");
  return {};
}

}  // namespace

TEST_CASE("flip turns one diagonal into the other and keeps the mesh whole") {
  Mesh mesh = rhombus();
  CHECK_FALSE(is_locally_delaunay(mesh, diagonal(mesh)));
  CHECK(is_flippable(mesh, diagonal(mesh)));
  const HalfEdge flipped = flip(mesh, diagonal(mesh));
  const VertexId from = mesh.origin(flipped), to = mesh.destination(flipped);
  CHECK(std::minmax({from, to}) == std::pair(VertexId(1U), VertexId(3U)));
  CHECK(is_locally_delaunay(mesh, flipped));
  CHECK(validate(mesh).summary() == "valid");
}

TEST_CASE("flipping twice gives the diagonal back") {
  Mesh mesh = rhombus();
  flip(mesh, flip(mesh, diagonal(mesh)));
  const HalfEdge e = diagonal(mesh);
  CHECK(std::minmax({mesh.origin(e), mesh.destination(e)}) ==
        std::pair(VertexId(0U), VertexId(2U)));
  CHECK(validate(mesh, {.delaunay = false}).summary() == "valid");
}

TEST_CASE("a reflex quadrilateral cannot be flipped") {
  const Mesh mesh = test::from_triangles({{0, 0}, {4, 0}, {1, 1}, {0, 4}}, {{0, 1, 2}, {0, 2, 3}});
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{TriangleId(0U), i};
    if (!mesh.is_boundary(e)) CHECK_FALSE(is_flippable(mesh, e));
  }
}

TEST_CASE("make_delaunay restores M6 and leaves constrained edges alone") {
  Mesh mesh = rhombus();
  make_delaunay(mesh);
  CHECK(validate(mesh).summary() == "valid");
  Mesh held =
      test::from_triangles({{-2, 0}, {0, -1}, {2, 0}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}, {0, 1});
  make_delaunay(held);
  CHECK(held.find_edge(VertexId(0U), VertexId(2U)).has_value());
  CHECK(validate(held).summary() == "valid");
}

#include "lepp/refine/clear_around.hpp"

#include <doctest/doctest.h>

#include <array>

#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

TEST_CASE("clearing around a triangle removes the Steiner points near it and no others") {
  Mesh mesh = constrained_delaunay(test::l_shape()).mesh;
  RefineOptions options;
  options.max_edge = 0.1;
  REQUIRE(refine(mesh, options).goal_reached);
  const std::size_t before = mesh.vertex_count();
  const std::array center{TriangleId(0U)};
  const std::size_t removed = clear_around(mesh, center, 50);
  CHECK(removed > 10);
  CHECK(removed < 100);
  CHECK(mesh.vertex_count() == before - removed);
  CHECK(validate(mesh).summary() == "valid");
}

TEST_CASE("clearing around all of a mesh gives the mesh of the input back") {
  Mesh mesh = constrained_delaunay(test::l_shape()).mesh;
  RefineOptions options;
  options.max_edge = 0.2;
  refine(mesh, options);
  const std::array center{TriangleId(0U)};
  clear_around(mesh, center, mesh.triangle_count());
  CHECK(mesh.vertex_count() == 6);
  CHECK(validate(mesh).summary() == "valid");
}

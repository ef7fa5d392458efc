#include "lepp/triangulation/boundary_meetings.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/arch.hpp"

using namespace lepp;

TEST_CASE("a curve that bulges over its neighbour is seen in the boundary, not in the triangles") {
  Mesh mesh = test::blocks_below_an_arch();
  CHECK(has_bent_boundary(mesh));
  CHECK_FALSE(first_boundary_meeting(mesh));
  const HalfEdge top = *mesh.find_edge(VertexId(2U), VertexId(3U));
  REQUIRE(split_halfway(mesh, top, 0).vertices.size() == 1);
  CHECK(validate(mesh).summary() == "valid");
  const auto meeting = first_boundary_meeting(mesh);
  REQUIRE(meeting);
  CHECK(meeting->first < meeting->second);
}

TEST_CASE("meshes that touch themselves in vertices have no meeting") {
  Pslg pslg = test::unit_square();
  test::add_chain(pslg, {{2, 1}, {2, 2}, {1, 2}}, false);
  pslg.segments.push_back({VertexId(2U), VertexId(4U), {}, 0, 1});
  pslg.segments.push_back({VertexId(6U), VertexId(2U), {}, 0, 1});
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  CHECK(mesh.triangle_count() == 4);
  CHECK_FALSE(has_bent_boundary(mesh));
  CHECK_FALSE(first_boundary_meeting(mesh));
}

#include "lepp/io/places.hpp"

#include <doctest/doctest.h>

#include "io/sample_meshes.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "support/arch.hpp"

using namespace lepp;

TEST_CASE("each connected part has a place of its region") {
  const auto places = places_of_parts(test::two_squares_mesh());
  REQUIRE(places.size() == 2);
  for (const Place& place : places) {
    CHECK(place.at.y > 0);
    CHECK(place.at.y < 1);
    CHECK((place.at.x < 1) == (place.region == SurfaceId(0U)));
  }
}

TEST_CASE("each hole has a place, also one that touches another or the outer boundary") {
  CHECK(places_of_holes(test::two_squares_mesh()).empty());
  Pslg pslg = test::square_with_hole();
  CHECK(places_of_holes(constrained_delaunay(pslg).mesh).size() == 1);
  // A second hole that touches the first at (2, 2) and the boundary at (3, 3).
  pslg.points.push_back({2.75, 2.25});
  const auto segment = [&](std::uint32_t a, std::uint32_t b) {
    pslg.segments.push_back({VertexId(a), VertexId(b), std::nullopt, 0, 1});
  };
  segment(6, 8);
  segment(8, 2);
  segment(2, 6);
  pslg.holes.push_back({2.58, 2.41});
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  pslg.holes = places_of_holes(mesh);
  CHECK(pslg.holes.size() == 2);
  CHECK(total_area(constrained_delaunay(pslg).mesh) == total_area(mesh));
}

TEST_CASE("an island in a hole is not taken for a hole") {
  Pslg pslg = test::square_with_hole();
  pslg.points.insert(pslg.points.end(), {{1.25, 1.25}, {1.75, 1.25}, {1.5, 1.75}});
  for (std::uint32_t i = 0; i < 3; ++i) {
    pslg.segments.push_back({VertexId(8 + i), VertexId(8 + (i + 1) % 3), std::nullopt, 0, 1});
  }
  pslg.holes = {{1.1, 1.9}};
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  REQUIRE(total_area(mesh) == doctest::Approx(8.125));
  const auto holes = places_of_holes(mesh);
  REQUIRE(holes.size() == 1);
  pslg.holes = holes;
  CHECK(total_area(constrained_delaunay(pslg).mesh) == doctest::Approx(8.125));
}

TEST_CASE("where the boundary meets itself, no hole is placed, and the message says where") {
  Mesh mesh = test::blocks_below_an_arch();
  mesh.set_source("arch.geo", 0);
  split_halfway(mesh, *mesh.find_edge(VertexId(2U), VertexId(3U)), 0);
  try {
    places_of_holes(mesh);
    FAIL("found places");
  } catch (const InputError& error) {
    CHECK(error.where().starts_with("arch.geo, boundary near ("));
    CHECK(error.remedy().starts_with("write .msh"));
  }
}

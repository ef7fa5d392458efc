#include "lepp/triangulation/sharp_vertex.hpp"

#include <doctest/doctest.h>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

// Spokes of the given lengths and directions (degrees) from the middle of a large square.
Mesh spokes(const std::vector<std::pair<double, double>>& length_and_angle) {
  Pslg pslg = test::polygon({-10, -10, 10, -10, 10, 10, -10, 10});
  const VertexId center(pslg.points.size());
  pslg.points.push_back({0, 0});
  for (const auto& [length, angle_deg] : length_and_angle) {
    const double angle = angle_deg * std::numbers::pi / 180;
    pslg.points.push_back({length * std::cos(angle), length * std::sin(angle)});
    pslg.segments.push_back({center, VertexId(pslg.points.size() - 1), {}, 0, 1});
  }
  return constrained_delaunay(pslg).mesh;
}

constexpr VertexId center{4U};

Fan fan_of_spoke(const Mesh& mesh, std::uint32_t spoke) {
  return fan_at(mesh, *mesh.find_edge(center, VertexId(5 + spoke)), center);
}

}  // namespace

TEST_CASE("a fan links constrained edges through wedges below 60 degrees") {
  const Mesh mesh = spokes({{1, 0}, {1, 50}, {1, 100}, {1, 200}});
  CHECK(fan_of_spoke(mesh, 0).edges.size() == 3);
  CHECK(fan_of_spoke(mesh, 2).edges.size() == 3);
  CHECK_FALSE(fan_of_spoke(mesh, 3).exists());
}

TEST_CASE("a full circle of wedges is one fan that lists each edge once") {
  const Mesh mesh =
      spokes({{1, 0}, {1, 45}, {1, 90}, {1, 135}, {1, 180}, {1, 225}, {1, 270}, {1, 315}});
  CHECK(fan_of_spoke(mesh, 3).edges.size() == 8);
}

TEST_CASE("an edge far longer than the shortest of its fan is cut at that one's radius") {
  Mesh mesh = spokes({{1, 0}, {3, 30}});
  const ConstrainedSplit done =
      split_constrained_edge(mesh, *mesh.find_edge(center, VertexId(6U)), 1e-9);
  REQUIRE(done.vertices.size() == 1);
  CHECK(squared_distance({0, 0}, mesh.point(done.vertices[0])) ==
        doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("otherwise every edge of the fan is cut at half the shortest") {
  Mesh mesh = spokes({{1, 0}, {1.2, 30}, {1.1, 60}});
  const ConstrainedSplit done =
      split_constrained_edge(mesh, *mesh.find_edge(center, VertexId(6U)), 1e-9);
  REQUIRE(done.vertices.size() == 3);
  for (const VertexId v : done.vertices) {
    CHECK(squared_distance({0, 0}, mesh.point(v)) == doctest::Approx(0.25).epsilon(1e-12));
  }
}

TEST_CASE("the edge between equal radii of a sharp wedge is seditious") {
  Mesh mesh = spokes({{1, 0}, {1, 20}});
  split_constrained_edge(mesh, *mesh.find_edge(center, VertexId(5U)), 1e-9);
  int seditious = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    seditious += shortest_edge_is_seditious(mesh, TriangleId(t)) ? 1 : 0;
  }
  CHECK(seditious >= 1);
  const Mesh wide = spokes({{1, 0}, {1, 80}});
  for (std::size_t t = 0; t < wide.triangle_count(); ++t) {
    CHECK_FALSE(shortest_edge_is_seditious(wide, TriangleId(t)));
  }
}

//          w           the kite's edge uw is seditious, whatever else touches u and w from outside
//   c  <   |   > x
//          u
TEST_CASE(
    "an edge is seditious by the segments on its own side of a corner where the mesh touches") {
  Pslg pslg = test::polygon({0, 0, 5, -0.5, 6, 0, 5, 0.5, 1, -3, 9, -3, 9, 3, 1, 3});
  pslg.segments.clear();
  const auto ring = [&](std::initializer_list<std::uint32_t> corners) {
    for (auto it = corners.begin(); it != corners.end(); ++it) {
      const auto next = it + 1 == corners.end() ? corners.begin() : it + 1;
      pslg.segments.push_back({VertexId(*it), VertexId(*next), {}, 0, 1});
    }
  };
  ring({1, 4, 5});  // below u
  ring({0, 1, 2, 3});
  ring({3, 6, 7});  // above w
  Mesh mesh = constrained_delaunay(pslg).mesh;
  REQUIRE(mesh.triangle_count() == 4);
  std::vector<std::uint32_t> number{3, 2, 1, 0};
  for (int order = 0; order < 2; ++order) {
    int seditious = 0;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      seditious += shortest_edge_is_seditious(mesh, TriangleId(t)) ? 1 : 0;
    }
    CHECK(seditious == 2);
    mesh.renumber_triangles(number);
  }
}

TEST_CASE("corners in wedges below 60 degrees are marked, each wedge on its own") {
  Pslg pslg = test::polygon({0, 0, 10, 0, 10, 3});  // 16.7 degrees at the origin
  test::add_chain(pslg, {{4, 0.2}, {6, 0.9}}, false);
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  const auto bits = corners_in_sharp_wedges(mesh);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const bool at_origin = mesh.point(mesh.vertex(TriangleId(t), i)) == Point{0, 0};
      CHECK((bits[t] >> i & 1) == (at_origin ? 1 : 0));
    }
  }
}

TEST_CASE("separate features of the input closer than the floor are found, others not") {
  Pslg pslg = test::unit_square();
  pslg.points.push_back({0.5, 1e-13});
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  int found = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    found += at_input_feature(mesh, TriangleId(t), 1e-12) ? 1 : 0;
    CHECK_FALSE(at_input_feature(mesh, TriangleId(t), 1e-14));
  }
  CHECK(found == 1);
}

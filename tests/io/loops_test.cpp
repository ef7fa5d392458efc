#include "lepp/io/loops.hpp"

#include <doctest/doctest.h>

#include "io/sample_meshes.hpp"

using namespace lepp;

namespace {

// A loop is closed if each edge starts where the one before it ends.
bool is_closed(const Mesh& mesh, const MeshOutline& outline, const Loop& loop) {
  const auto ends = [&](const LoopEdge& e) {
    const HalfEdge half = outline.edges[e.edge];
    const std::pair forward(mesh.origin(half), mesh.destination(half));
    return e.along ? forward : std::pair(forward.second, forward.first);
  };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (ends(loop[i]).second != ends(loop[(i + 1) % loop.size()]).first) return false;
  }
  return !loop.empty();
}

double area(const Mesh& mesh, const MeshOutline& outline, const Loop& loop) {
  double twice = 0;
  for (const auto& [edge, along] : loop) {
    const HalfEdge e = outline.edges[edge];
    const double c = cross(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)));
    twice += along ? c : -c;
  }
  return twice / 2;
}

void check_loops(const Mesh& mesh, const MeshOutline& outline) {
  for (const OutlinePart& part : outline.parts) {
    for (std::size_t i = 0; i < part.loops.size(); ++i) {
      CHECK(is_closed(mesh, outline, part.loops[i]));
      CHECK((area(mesh, outline, part.loops[i]) > 0) == (i == 0));  // the outer one first
    }
  }
}

}  // namespace

TEST_CASE("two squares with a crack are two parts with a loop each, and the crack is embedded") {
  const Mesh mesh = test::two_squares_mesh();
  const MeshOutline outlined = outline(mesh);
  CHECK(outlined.edges.size() == 8);
  REQUIRE(outlined.parts.size() == 2);
  for (const OutlinePart& part : outlined.parts) {
    REQUIRE(part.loops.size() == 1);
    CHECK(part.loops[0].size() == 4);
    CHECK(area(mesh, outlined, part.loops[0]) == doctest::Approx(1));
    CHECK(part.embedded.size() == (part.region == SurfaceId(0U) ? 1 : 0));
  }
  check_loops(mesh, outlined);
}

TEST_CASE("a hole is a second loop, clockwise") {
  const Mesh mesh = constrained_delaunay(test::square_with_hole()).mesh;
  const MeshOutline outlined = outline(mesh);
  REQUIRE(outlined.parts.size() == 1);
  REQUIRE(outlined.parts[0].loops.size() == 2);
  CHECK(area(mesh, outlined, outlined.parts[0].loops[1]) == doctest::Approx(-1));
  check_loops(mesh, outlined);
}

TEST_CASE("holes that touch each other and the boundary are loops of their own") {
  Pslg pslg = test::square_with_hole();
  pslg.points.push_back({2.75, 2.25});
  for (const auto& [a, b] : {std::pair(6U, 8U), {8U, 2U}, {2U, 6U}}) {
    pslg.segments.push_back({VertexId(a), VertexId(b), std::nullopt, 0, 1});
  }
  pslg.holes.push_back({2.58, 2.41});
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  const MeshOutline outlined = outline(mesh);
  REQUIRE(outlined.parts.size() == 1);
  CHECK(outlined.parts[0].loops.size() == 3);
  check_loops(mesh, outlined);
}

TEST_CASE("a slit that starts at the boundary is embedded, not part of the loop") {
  Pslg pslg = test::square_with_hole();
  pslg.points.push_back({0.5, 0.5});
  pslg.segments.push_back({VertexId(0U), VertexId(8U), std::nullopt, 0, 1});
  const MeshOutline outlined = outline(constrained_delaunay(pslg).mesh);
  REQUIRE(outlined.parts.size() == 1);
  CHECK(outlined.parts[0].loops[0].size() == 4);
  CHECK(outlined.parts[0].embedded.size() == 1);
}

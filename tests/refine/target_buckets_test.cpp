#include "lepp/refine/target_buckets.hpp"

#include <doctest/doctest.h>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/flip.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

// Two needles and a fat triangle, apart.
Mesh three_triangles() {
  Pslg pslg = test::polygon({0, 0, 1, 0, 0.5, 20});           // 3 degrees
  test::add_chain(pslg, {{5, 0}, {6, 0}, {5.5, 2.2}}, true);  // 26 degrees
  test::add_chain(pslg, {{8, 0}, {9, 0}, {8.5, 0.9}}, true);
  return constrained_delaunay(pslg).mesh;
}

double left_end(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return std::min({a.x, b.x, c.x});
}

}  // namespace

TEST_CASE("targets come worst bucket first, whatever the order they were added in") {
  const Mesh mesh = three_triangles();
  REQUIRE(mesh.triangle_count() == 3);
  const RefineOptions options;
  for (const bool forwards : {true, false}) {
    TargetBuckets targets(mesh, options);
    for (std::uint32_t i = 0; i < 3; ++i) targets.add(mesh, TriangleId(forwards ? i : 2 - i));
    const auto first = targets.next(mesh), second = targets.next(mesh);
    REQUIRE(first);
    REQUIRE(second);
    CHECK(left_end(mesh, *first) == 0);
    CHECK(left_end(mesh, *second) == 5);
    CHECK_FALSE(targets.next(mesh));
  }
}

TEST_CASE("too large comes before too flat") {
  const Mesh mesh = three_triangles();
  RefineOptions options;
  options.max_area = 9;
  TargetBuckets targets(mesh, options);
  for (std::uint32_t i = 0; i < 3; ++i) targets.add(mesh, TriangleId(i));
  CHECK(left_end(mesh, *targets.next(mesh)) == 0);
  CHECK(left_end(mesh, *targets.next(mesh)) == 5);
  CHECK_FALSE(targets.next(mesh));
}

TEST_CASE("a triangle that has changed since does not come up") {
  Mesh mesh = constrained_delaunay(test::polygon({0, 0, 10, 0, 10, 1, 0, 1})).mesh;
  TargetBuckets targets(mesh, {});
  targets.add(mesh, TriangleId(0U));
  targets.add(mesh, TriangleId(1U));
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{TriangleId(0U), i};
    if (!mesh.is_constrained(e)) {
      flip(mesh, e);
      break;
    }
  }
  CHECK_FALSE(targets.next(mesh));
}

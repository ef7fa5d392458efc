// What users see of the trees: nodes, their parents and halves, and levels.

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <random>

#include "bisection/random_forest.hpp"
#include "lepp/geometry/triangle_measures.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

double area(const Forest& forest, NodeId n) {
  const auto [a, b, c] = forest.vertices(n);
  const Mesh& mesh = forest.mesh();
  return signed_area(mesh.point(a), mesh.point(b), mesh.point(c));
}

Forest made(std::uint64_t seed, BisectionRule rule) {
  std::mt19937_64 random(seed);
  Forest forest(integer_mesh(random, 6), rule);
  for (int i = 0; i < 5; ++i) {
    forest.bisect(some_triangles(random, forest.mesh(), 8));
    if (i == 3) forest.coarsen(all_triangles(forest.mesh()));
  }
  return forest;
}

void for_forests(auto check) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    check(made(seed, seed % 2 == 0 ? BisectionRule::longest_edge : BisectionRule::newest_vertex));
  }
}

}  // namespace

TEST_CASE("from each triangle parents lead to its root, and each is a half of its parent") {
  for_forests([](const Forest& forest) {
    for (const TriangleId t : all_triangles(forest.mesh())) {
      NodeId n = forest.node(t);
      CHECK(forest.triangle(n) == t);
      CHECK_FALSE(forest.children(n).has_value());
      CHECK(forest.vertices(n) == forest.mesh().vertices(t));
      CHECK(forest.generation(n) == forest.generation(t));
      while (const auto parent = forest.parent(n)) {
        const auto halves = forest.children(*parent);
        REQUIRE(halves.has_value());
        CHECK((halves->at(0) == n || halves->at(1) == n));
        CHECK_FALSE(forest.triangle(*parent).has_value());
        CHECK(forest.generation(n) == forest.generation(*parent) + 1);
        n = *parent;
      }
      CHECK(n.value == forest.root(t).value);
    }
  });
}

TEST_CASE("two halves fill what they are halves of, and the roots are the mesh of the start") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    std::mt19937_64 random(seed);
    const Mesh start = integer_mesh(random, 6);
    const Forest forest = made(seed, BisectionRule::longest_edge);
    for (const TriangleId t : all_triangles(start)) {
      CHECK(forest.vertices(NodeId(t.value)) == start.vertices(t));
    }
    for (const TriangleId t : all_triangles(forest.mesh())) {
      for (auto n = forest.parent(forest.node(t)); n; n = forest.parent(*n)) {
        const auto [first, second] = *forest.children(*n);
        CHECK(area(forest, first) + area(forest, second) == area(forest, *n));  // exact here
        CHECK(area(forest, first) > 0);
      }
    }
  }
}

TEST_CASE("a level fills the domain with nodes cut at most so often, in an order that stays") {
  for_forests([](const Forest& forest) {
    double whole = 0;
    for (const NodeId n : forest.level(0)) whole += area(forest, n);
    CHECK(forest.level(0).size() == forest.root_count());
    for (std::uint32_t g = 0; g < 12; ++g) {
      double sum = 0;
      for (const NodeId n : forest.level(g)) {
        sum += area(forest, n);
        CHECK(forest.generation(n) <= g);
        CHECK((forest.generation(n) == g || forest.triangle(n).has_value()));
      }
      CHECK(sum == whole);
    }
    CHECK(forest.level(1000).size() == forest.mesh().triangle_count());
  });
}

TEST_CASE("nodes keep their ids while other triangles are cut and joined") {
  std::mt19937_64 random(7);
  Forest forest(integer_mesh(random, 6));
  forest.bisect(all_triangles(forest.mesh()));
  const std::vector<NodeId> level = forest.level(1);
  std::map<NodeId, std::array<VertexId, 3>> corners;
  for (const NodeId n : level) corners[n] = forest.vertices(n);
  for (int i = 0; i < 3; ++i) forest.bisect(some_triangles(random, forest.mesh(), 5));
  CHECK(forest.level(1) == level);
  for (const auto& [n, vertices] : corners) CHECK(forest.vertices(n) == vertices);
}

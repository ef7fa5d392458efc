#include "lepp/bisection/vertices_made.hpp"

#include <doctest/doctest.h>

#include <random>

#include "bisection/random_forest.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE(
    "vertices come after those they lie between, also after coarsening, and roots make none") {
  std::mt19937_64 random(41);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    Forest forest(integer_mesh(random, i));
    CHECK(vertices_made(forest).empty());
    for (int round = 0; round < 6; ++round) {
      forest.bisect(some_triangles(random, forest.mesh(), 8));
      if (round % 2 == 0) continue;
      forest.coarsen(some_triangles(random, forest.mesh(), forest.mesh().triangle_count()));
    }
    const std::vector<NewVertex> made = vertices_made(forest);
    const std::size_t vertices = forest.mesh().vertex_count();
    REQUIRE(made.size() + forest.root_vertex_count() == vertices);
    std::vector<bool> is_later(vertices, false);
    for (const NewVertex& v : made) is_later[v.vertex.index()] = true;
    for (const auto& [v, a, b] : made) {
      REQUIRE(is_later[v.index()]);  // each is made once
      REQUIRE_FALSE(is_later[a.index()]);
      REQUIRE_FALSE(is_later[b.index()]);
      REQUIRE(forest.mesh().point(v) == midpoint(forest.mesh().point(a), forest.mesh().point(b)));
      is_later[v.index()] = false;
    }
  }
}

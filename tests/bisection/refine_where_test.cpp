#include "lepp/bisection/refine_where.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "bisection/disc_counts.hpp"
#include "lepp/triangulation/validate.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

DiscCounts refined(Forest& forest, const Disc& disc, double eps) {
  const DiscCounts counts = refine_disc(forest, disc, eps);
  CHECK(counts.finished);
  CHECK(counts.left == 0);
  return counts;
}

}  // namespace

TEST_CASE("Definition 2: every triangle that meets the region gets a diameter below eps") {
  Forest forest(quality_square());
  refined(forest, {{0.3, 0.4}, 0.1}, 0.01);
  CHECK(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
}

// n = 2 r / eps. tests/bench/theorem2.cpp draws it.
TEST_CASE("Theorem 2: O(n^2) vertices inside the disc, O(n log n) outside") {
  Forest forest(quality_square());
  const Disc disc{{0.3, 0.4}, 0.1};
  std::vector<double> inside, outside;
  double n = 0, eps = 0.08;
  for (int halving = 0; halving <= 6; ++halving, eps /= 2) {
    const DiscCounts counts = refined(forest, disc, eps);
    n = 2 * disc.radius / eps;
    inside.push_back(static_cast<double>(counts.inside) / (n * n));
    outside.push_back(static_cast<double>(counts.outside) / (n * std::log2(n)));
  }
  const auto last_three = std::minmax({inside[4], inside[5], inside[6]});
  CHECK(last_three.second < 1.15 * last_three.first);
  CHECK(outside[6] < 1.2 * outside[3]);
}

TEST_CASE("a limit on vertices is met exactly; it and the caller's stop leave a conforming mesh") {
  const auto always = [](const Mesh& mesh, TriangleId t) { return diameter(mesh, t) > 1e-3; };
  Forest forest(quality_square());
  WhereOptions options;
  SUBCASE("limit") { options.bisect.max_vertices = 1000; }
  SUBCASE("stop") {
    options.progress = [](std::size_t vertices) { return vertices < 1000; };
  }
  CHECK_FALSE(refine_where(forest, always, options).finished);
  CHECK(forest.mesh().vertex_count() >= 1000);
  if (options.bisect.max_vertices > 0) CHECK(forest.mesh().vertex_count() == 1000);
  CHECK(forest.mesh().vertex_count() < 10000);
  CHECK(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
}

TEST_CASE("a report has the refused triangles however it ends, each once") {
  const double ulp = 0x1p-52;  // of coordinates from 1 to 2
  const Mesh start = constrained_delaunay(polygon({1, 1, 1 + ulp, 1, 1 + 64 * ulp,  //
                                                   1 + 64 * ulp, 1, 1 + ulp}))
                         .mesh;
  Forest forest(start);
  WhereOptions options;
  SUBCASE("nothing left that can be cut") {}
  SUBCASE("limit") { options.bisect.max_vertices = 60; }
  SUBCASE("stop") {
    options.progress = [](std::size_t vertices) { return vertices < 60; };
  }
  const RefineWhereReport report = refine_where(
      forest, [](const Mesh&, TriangleId) { return true; }, options);
  CHECK_FALSE(report.finished);
  REQUIRE_FALSE(report.done.refused.empty());
  CHECK(std::ranges::adjacent_find(report.done.refused) == report.done.refused.end());
}

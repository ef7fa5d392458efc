#include "lepp/bisection/refine_where.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "bisection/random_forest.hpp"
#include "lepp/bisection/region.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/validate.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// Counts by place after every triangle that meets a disc has a diameter below eps.
struct Counts {
  std::size_t inside = 0, outside = 0;
};

Counts refine_disc(Forest& forest, const Disc& disc, double eps) {
  const auto is_to_be_cut = [&](const Mesh& mesh, TriangleId t) {
    return !(diameter(mesh, t) < eps) && meets(disc, mesh.corners(t));
  };
  CHECK(refine_where(forest, is_to_be_cut).finished);
  const Mesh& mesh = forest.mesh();
  std::size_t left = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    left += is_to_be_cut(mesh, TriangleId(t)) ? 1 : 0;
  }
  CHECK(left == 0);
  Counts counts;
  for (std::size_t v = forest.root_vertex_count(); v < mesh.vertex_count(); ++v) {
    const Point d = mesh.points()[v] - disc.center;
    (dot(d, d) <= disc.radius * disc.radius ? counts.inside : counts.outside) += 1;
  }
  return counts;
}

Mesh quality_square() {
  Mesh mesh = constrained_delaunay(unit_square()).mesh;
  RefineOptions options;
  options.max_edge = 0.4;
  refine(mesh, options);
  return mesh;
}

}  // namespace

TEST_CASE("Definition 2: every triangle that meets the region gets a diameter below eps") {
  Forest forest(quality_square());
  refine_disc(forest, {{0.3, 0.4}, 0.1}, 0.01);
  CHECK(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
}

// n = 2 r / eps.
TEST_CASE("Theorem 2: O(n^2) vertices inside the disc, O(n log n) outside") {
  Forest forest(quality_square());
  const Disc disc{{0.3, 0.4}, 0.1};
  std::vector<double> inside, outside;
  double n = 0, eps = 0.04;
  for (int halving = 0; halving <= 6; ++halving, eps /= 2) {
    const Counts counts = refine_disc(forest, disc, eps);
    n = 2 * disc.radius / eps;
    inside.push_back(static_cast<double>(counts.inside) / (n * n));
    outside.push_back(static_cast<double>(counts.outside) / (n * std::log2(n)));
  }
  const auto last_three = std::minmax({inside[4], inside[5], inside[6]});
  CHECK(last_three.second < 1.15 * last_three.first);
  CHECK(outside[6] < 1.2 * outside[3]);
}

TEST_CASE("a limit on vertices and the caller's stop leave a conforming mesh, and say so") {
  const auto always = [](const Mesh& mesh, TriangleId t) { return diameter(mesh, t) > 1e-3; };
  Forest forest(quality_square());
  WhereOptions options;
  SUBCASE("limit") { options.max_vertices = 1000; }
  SUBCASE("stop") {
    options.progress = [](std::size_t vertices) { return vertices < 1000; };
  }
  CHECK_FALSE(refine_where(forest, always, options).finished);
  CHECK(forest.mesh().vertex_count() >= 1000);
  CHECK(forest.mesh().vertex_count() < 10000);
  CHECK(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
}

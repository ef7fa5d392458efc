#include "lepp/bisection/remesh_transfer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "bisection/remeshed.hpp"
#include "lepp/bisection/forest.hpp"
#include "lepp/bisection/transfer.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using namespace lepp::test;
using Keep = TriangleTransferOptions::Keep;

TEST_CASE("P0 to another mesh: integrals stay in each region, constants and bounds too") {
  Random random(3);
  for (int i = 0; i < 10; ++i) {
    const Mesh before = random_mesh(divided_square(), random.real(0.1, 0.4), random);
    const Mesh after = random_mesh(divided_square(), random.real(0.1, 0.4), random);
    for (const bool by_region : {true, false}) {
      const auto transfer = triangle_transfer(before, after, {.by_region = by_region});
      const std::vector<double> any = noise(before.triangle_count(), random);
      std::vector<double> moved = any;
      transfer_triangles(transfer, moved);
      const auto was = integrals_by_region(before, any), is = integrals_by_region(after, moved);
      CHECK(std::abs(was[0] - is[0]) < 1e-13);
      CHECK(std::abs(was[1] - is[1]) < 1e-13);
      const auto [low, high] = std::ranges::minmax(any);
      const auto [new_low, new_high] = std::ranges::minmax(moved);
      CHECK(new_low >= low - 1e-13);
      CHECK(new_high <= high + 1e-13);

      std::vector<double> ones(before.triangle_count(), 1.0);
      transfer_triangles(transfer, ones);
      CHECK(largest_difference(ones, std::vector<double>(ones.size(), 1.0)) < 1e-13);
    }
  }
}

TEST_CASE("P0: what is in one region only does not leak into the other one") {
  Random random(4);
  for (const Pslg& pslg : {divided_square(), disc_in_ring()}) {
    const Mesh before = random_mesh(pslg, 0.3, random), after = random_mesh(pslg, 0.1, random);
    std::vector<double> values;
    for (std::size_t t = 0; t < before.triangle_count(); ++t) {
      values.push_back(before.region(TriangleId(t)) == SurfaceId(0U) ? 1 : 0);
    }
    transfer_triangles(triangle_transfer(before, after), values);
    for (std::size_t t = 0; t < after.triangle_count(); ++t) {
      if (after.region(TriangleId(t)) == SurfaceId(1U)) CHECK(values[t] == 0);
      else CHECK(values[t] > 0.5);
    }
  }
}

TEST_CASE("P0 where circles have moved: integrals stay in each region, or values do, as asked") {
  Random random(5);
  for (const double h : {0.6, 0.2, 0.04}) {
    for (const double h_before : {0.6, 0.1}) {
      CAPTURE(h);
      CAPTURE(h_before);
      const Mesh before = random_mesh(disc_in_ring(), h_before, random);
      const Mesh after = random_mesh(disc_in_ring(), h, random);
      const std::vector<double> any = noise(before.triangle_count(), random);
      std::vector<double> moved = any;
      transfer_triangles(triangle_transfer(before, after), moved);
      const auto was = integrals_by_region(before, any), is = integrals_by_region(after, moved);
      CHECK(std::abs(was[0] - is[0]) < 1e-13);
      CHECK(std::abs(was[1] - is[1]) < 1e-13);

      const auto by_values = triangle_transfer(before, after, {.keep = Keep::values});
      moved = any;
      transfer_triangles(by_values, moved);
      const auto [low, high] = std::ranges::minmax(any);
      const auto [new_low, new_high] = std::ranges::minmax(moved);
      CHECK(new_low >= low - 1e-14);
      CHECK(new_high <= high + 1e-14);
      std::vector<double> ones(before.triangle_count(), 1.0);
      transfer_triangles(by_values, ones);
      CHECK(largest_difference(ones, std::vector<double>(ones.size(), 1.0)) < 1e-14);
    }
  }
}

TEST_CASE("P0 from a bisected mesh and back is what the logs of bisect() and coarsen() say") {
  Random random(6);
  Forest forest(random_mesh(divided_square(), 0.3, random));
  const Mesh before = forest.mesh();
  const Refinement done = forest.bisect(some_triangles(before, random, 3));
  const std::vector<double> any = noise(before.triangle_count(), random);
  std::vector<double> by_log = any, by_mesh = any;
  transfer_triangles(done, by_log);
  transfer_triangles(triangle_transfer(before, forest.mesh()), by_mesh);
  CHECK(largest_difference(by_log, by_mesh) < 1e-13);
  transfer_triangles(triangle_transfer(forest.mesh(), before), by_mesh);  // means of equal halves
  CHECK(largest_difference(any, by_mesh) < 1e-13);
}

TEST_CASE("meshes of different regions are refused, unless all are taken for one") {
  Random random(10);
  Pslg one_region = divided_square();
  one_region.seeds = {{{0.1, 0.1}, SurfaceId(0U)}, {{0.5, 0.9}, SurfaceId(0U)}};
  const Mesh before = random_mesh(one_region, 0.3, random);
  const Mesh after = random_mesh(divided_square(), 0.3, random);
  CHECK_THROWS_AS(triangle_transfer(before, after), InputError);
  CHECK_THROWS_AS(triangle_transfer(after, before), InputError);
  std::vector<double> ones(before.triangle_count(), 1.0);
  transfer_triangles(triangle_transfer(before, after, {.by_region = false}), ones);
  CHECK(largest_difference(ones, std::vector<double>(ones.size(), 1.0)) < 1e-13);
}

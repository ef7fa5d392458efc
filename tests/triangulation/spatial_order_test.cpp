#include "lepp/triangulation/spatial_order.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace lepp;

namespace {

double length_of(const std::vector<Point>& points, const std::vector<std::uint32_t>& order) {
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    length += std::sqrt(squared_distance(points[order[i - 1]], points[order[i]]));
  }
  return length;
}

bool is_permutation_of_indices(std::vector<std::uint32_t> order, std::size_t count) {
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] != i) return false;
  }
  return order.size() == count;
}

}  // namespace

TEST_CASE("spatial order visits every point once, and neighbours are near each other") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform;
  std::vector<Point> points;
  for (int i = 0; i < 10000; ++i) points.push_back({uniform(random), uniform(random)});
  const auto order = spatial_order(points);
  CHECK(is_permutation_of_indices(order, points.size()));
  // A shortest path takes about 0.71 sqrt(n area); a Hilbert curve is a quarter to a half longer.
  CHECK(length_of(points, order) < 1.1 * std::sqrt(10000.0));
}

TEST_CASE("equal points stand side by side, the smaller index first") {
  std::mt19937_64 random(6);
  std::vector<Point> points;
  for (int i = 0; i < 5000; ++i) {
    points.push_back({static_cast<double>(random() % 30), 1e-9 * static_cast<double>(random() % 3)});
  }
  const auto order = spatial_order(points);
  CHECK(is_permutation_of_indices(order, points.size()));
  std::size_t changes = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const bool equal = points[order[i - 1]] == points[order[i]];
    if (equal) CHECK(order[i - 1] < order[i]);
    else ++changes;
  }
  CHECK(changes == 89);  // 90 distinct points
}

TEST_CASE("clusters of any scale are ordered inside, too") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform;
  std::vector<Point> points{{1e60, 1e60}};
  for (int i = 0; i < 5000; ++i) points.push_back({1e-30 * uniform(random), 1e-30 * uniform(random)});
  const auto order = spatial_order(points);
  CHECK(is_permutation_of_indices(order, points.size()));
  std::vector<std::uint32_t> cluster;
  for (const std::uint32_t i : order) {
    if (i != 0) cluster.push_back(i);
  }
  CHECK(length_of(points, cluster) < 1.2e-30 * std::sqrt(5000.0));
}

TEST_CASE("no points, one point, and one point many times") {
  CHECK(spatial_order({}).empty());
  CHECK(spatial_order(std::vector<Point>{{3, 4}}) == std::vector<std::uint32_t>{0});
  const auto order = spatial_order(std::vector<Point>(1000, {3, 4}));
  CHECK(std::ranges::is_sorted(order));
  CHECK(is_permutation_of_indices(order, 1000));
}

#include "lepp/bisection/transfer.hpp"

#include <doctest/doctest.h>

#include <Eigen/SparseCore>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "lepp/bisection/transfer_matrix.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/fields.hpp"
#include "support/shapes.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

double integral(const std::vector<double>& densities, const std::vector<double>& areas) {
  return std::inner_product(densities.begin(), densities.end(), areas.begin(), 0.0);
}

std::vector<double> times(const Eigen::SparseMatrix<double>& matrix, const std::vector<double>& x) {
  REQUIRE(static_cast<std::size_t>(matrix.cols()) == x.size());
  const Eigen::VectorXd y =
      matrix * Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  return {y.begin(), y.end()};
}

Forest random_forest(std::uint64_t seed) {
  std::mt19937_64 shape(seed);
  return Forest(constrained_delaunay(random_star(shape, static_cast<int>(seed % 3))).mesh,
                seed % 2 == 0 ? BisectionRule::longest_edge : BisectionRule::newest_vertex);
}

// Calls round(forest, random) for random domains, some refined already.
void for_random_forests(auto round) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Forest forest = random_forest(seed);
    for (int i = 0; i < 3; ++i) forest.bisect(some_triangles(forest.mesh(), random, 3));
    round(forest, random);
  }
}

}  // namespace

TEST_CASE("vertex values of a linear function stay those of it through bisect and coarsen") {
  for_random_forests([](Forest& forest, Random& random) {
    std::vector<double> values = at_vertices(forest.mesh(), linear);
    for (int i = 0; i < 8; ++i) {
      if (random.one_in(2)) {
        transfer_vertices(forest.bisect(some_triangles(forest.mesh(), random, 3)), values);
      } else {
        transfer_vertices(forest.coarsen(some_triangles(forest.mesh(), random, 1)), values);
      }
      CHECK(largest_difference(values, at_vertices(forest.mesh(), linear)) < 1e-14);
    }
  });
}

TEST_CASE(
    "points transfer to the points of the mesh, bit for bit but for rounding at the boundary") {
  std::size_t inside = 0, moved = 0;
  for_random_forests([&](Forest& forest, Random& random) {
    std::vector<Point> points(forest.mesh().points().begin(), forest.mesh().points().end());
    const Refinement done = forest.bisect(some_triangles(forest.mesh(), random, 2));
    for (const auto& [v, a, b] : done.vertices) {  // in turn, from what the mesh has
      const Point between = midpoint(points[a.index()], points[b.index()]);
      const Point p = forest.mesh().point(v);
      points.push_back(p);
      if (p == between) continue;
      ++moved;
      CHECK(std::max(std::abs(p.x - between.x), std::abs(p.y - between.y)) < 1e-15);
      CHECK(orient2d(points[a.index()], points[b.index()], between) != 0);
      inside += forest.mesh().is_boundary(forest.mesh().leaving(v)) ? 0 : 1;
    }
    CHECK(std::ranges::equal(points, forest.mesh().points()));
    transfer_vertices(forest.coarsen(some_triangles(forest.mesh(), random, 1)), points);
    CHECK(std::ranges::equal(points, forest.mesh().points()));
  });
  CHECK(inside == 0);
  CHECK(moved > 0);
}

TEST_CASE("triangle values keep their integral through random rounds of bisect and coarsen") {
  for_random_forests([](Forest& forest, Random& random) {
    std::vector<double> densities = noise(forest.mesh().triangle_count(), random);
    const double before = integral(densities, areas_of(forest.mesh()));
    for (int i = 0; i < 10; ++i) {
      if (random.one_in(2)) {
        transfer_triangles(forest.bisect(some_triangles(forest.mesh(), random, 3)), densities);
      } else {
        std::vector<double> areas = areas_of(forest.mesh());
        transfer_triangles(forest.coarsen(some_triangles(forest.mesh(), random, 1)), densities,
                           areas);
        CHECK(largest_difference(areas, areas_of(forest.mesh())) < 1e-15);
      }
      CHECK(std::abs(integral(densities, areas_of(forest.mesh())) - before) < 1e-12);
    }
  });
}

TEST_CASE("halves of equal area need no areas; tags are inherited, triangle by triangle") {
  for_random_forests([](Forest& forest, Random& random) {
    std::vector<std::uint32_t> roots;
    for (std::size_t i = 0; i < forest.mesh().triangle_count(); ++i) {
      roots.push_back(forest.root(TriangleId(i)).value);
    }
    transfer_triangles(forest.bisect(some_triangles(forest.mesh(), random, 2)), roots);
    REQUIRE(roots.size() == forest.mesh().triangle_count());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      REQUIRE(roots[i] == forest.root(TriangleId(i)).value);
    }
    std::vector<double> densities = noise(roots.size(), random), weighted = densities;
    std::vector<double> areas = areas_of(forest.mesh());
    const Coarsening coarsening = forest.coarsen(some_triangles(forest.mesh(), random, 1));
    REQUIRE(!coarsening.triangles.empty());
    transfer_triangles(coarsening, densities);
    transfer_triangles(coarsening, weighted, areas);
    CHECK(largest_difference(densities, weighted) < 1e-12);
  });
}

TEST_CASE("matrices of a refinement do what replaying its log does") {
  for_random_forests([](Forest& forest, Random& random) {
    const std::size_t vertices = forest.mesh().vertex_count();
    const std::size_t triangles = forest.mesh().triangle_count();
    const Refinement done = forest.bisect(some_triangles(forest.mesh(), random, 2));
    REQUIRE(!done.vertices.empty());
    const auto P = prolongation(done, vertices);
    CHECK(static_cast<std::size_t>(P.rows()) == forest.mesh().vertex_count());

    std::vector<double> values = noise(vertices, random);
    const std::vector<double> by_matrix = times(P, values);
    transfer_vertices(done, values);
    CHECK(largest_difference(values, by_matrix) < 1e-15);

    std::vector<double> loads = noise(forest.mesh().vertex_count(), random);
    const std::vector<double> restricted = times(restriction(done, vertices), loads);
    const double whole = std::accumulate(loads.begin(), loads.end(), 0.0);
    restrict_loads(done, loads);
    CHECK(largest_difference(loads, restricted) < 1e-13);
    CHECK(std::abs(std::accumulate(loads.begin(), loads.end(), 0.0) - whole) < 1e-12);

    std::vector<double> densities = noise(triangles, random);
    const std::vector<double> inherited = times(triangle_prolongation(done, triangles), densities);
    transfer_triangles(done, densities);
    CHECK(densities == inherited);
  });
}

TEST_CASE("matrices of a coarsening do what replaying its log does") {
  for_random_forests([](Forest& forest, Random& random) {
    const std::size_t vertices = forest.mesh().vertex_count();
    std::vector<double> areas = areas_of(forest.mesh());
    const Coarsening done = forest.coarsen(some_triangles(forest.mesh(), random, 1));
    REQUIRE(!done.vertices.empty());

    std::vector<double> values = noise(vertices, random);
    const std::vector<double> injected = times(injection(done, vertices), values);
    transfer_vertices(done, values);
    CHECK(values == injected);

    std::vector<double> densities = noise(areas.size(), random);
    const std::vector<double> means = times(triangle_averaging(done, areas), densities);
    transfer_triangles(done, densities, areas);
    CHECK(largest_difference(densities, means) < 1e-14);
  });
}

TEST_CASE("vertices between vertices of the same call: weights of an eighth and more") {
  Forest forest(constrained_delaunay(unit_square()).mesh);
  Refinement all;  // as if it were one call
  const std::size_t before = forest.mesh().vertex_count();
  for (int i = 0; i < 6; ++i) {
    const Refinement one = forest.bisect(all_triangles(forest.mesh()));
    all.vertices.insert(all.vertices.end(), one.vertices.begin(), one.vertices.end());
  }
  const auto P = prolongation(all, before);
  std::vector<double> values = {1, 2, 4, 8};
  const std::vector<double> by_matrix = times(P, values);
  transfer_vertices(all, values);
  CHECK(values == by_matrix);  // sums of few powers of two: no rounding
  const Eigen::VectorXd row_sums = P * Eigen::VectorXd::Ones(P.cols());
  CHECK(row_sums.minCoeff() == 1);
  CHECK(row_sums.maxCoeff() == 1);
}

TEST_CASE("a call that changes nothing is the identity") {
  Forest forest(constrained_delaunay(unit_square()).mesh);
  std::vector<double> values = {1, 2, 3, 4};
  const Coarsening done = forest.coarsen(std::vector{TriangleId(0U)});
  transfer_vertices(done, values);
  CHECK(values == std::vector<double>{1, 2, 3, 4});
  CHECK(times(injection(done, 4), values) == values);
  CHECK(times(prolongation({}, 4), values) == values);
}

TEST_CASE("a matrix with more rows, columns or entries than 32 bits count is refused") {
  const std::size_t most = std::numeric_limits<int>::max();
  CHECK_NOTHROW(transfer_detail::check_count(most));
  CHECK_THROWS_AS(transfer_detail::check_count(most + 1), RefusedError);
  CHECK_THROWS_AS(prolongation({}, most + 1), RefusedError);
  VertexTransfer transfer;
  transfer.vertices_before = most + 1;
  CHECK_THROWS_AS(interpolation(transfer), RefusedError);
}

TEST_CASE("through coarsening the caller says what two values make: amounts, vectors, sets") {
  for_random_forests([](Forest& forest, Random& random) {
    std::vector<double> amounts = areas_of(forest.mesh()), sums = amounts;
    std::vector<std::vector<std::uint32_t>> lists(amounts.size());
    std::vector<bool> marks(amounts.size());
    for (std::size_t i = 0; i < lists.size(); ++i) {
      lists[i] = {static_cast<std::uint32_t>(i)};
      marks[i] = random.one_in(4);
    }
    const std::vector<bool> marks_before = marks;
    const Coarsening coarsening = forest.coarsen(some_triangles(forest.mesh(), random, 1));
    transfer_triangles(coarsening, amounts, std::plus<>());
    CHECK(largest_difference(amounts, areas_of(forest.mesh())) < 1e-12);
    transfer_triangles(coarsening, lists, [](auto a, const auto& b) {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    });
    transfer_triangles(coarsening, marks, std::logical_or<bool>());
    REQUIRE(lists.size() == forest.mesh().triangle_count());
    REQUIRE(marks.size() == lists.size());
    std::size_t all = 0;
    for (std::size_t i = 0; i < lists.size(); ++i) {
      double sum = 0;
      bool marked = false;
      for (const std::uint32_t old : lists[i]) {
        sum += sums[old];
        marked = marked || marks_before[old];
      }
      CHECK(std::abs(sum - amounts[i]) < 1e-12);
      CHECK(marks[i] == marked);
      all += lists[i].size();
    }
    CHECK(all == sums.size());
  });
}

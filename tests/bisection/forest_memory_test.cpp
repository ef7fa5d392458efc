// Each allocation of a call fails in turn. What is left must be a forest one can go on with.

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "bisection/random_forest.hpp"
#include "lepp/bisection/transfer.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/failing_memory.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

std::vector<std::array<Point, 3>> triangles_of(const Mesh& mesh) {
  std::vector<std::array<Point, 3>> all;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    auto corners = mesh.corners(TriangleId(t));
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    all.push_back(corners);
  }
  std::ranges::sort(all);
  return all;
}

bool have_same_triangles(const Mesh& a, const Mesh& b) {
  if (!std::ranges::equal(a.points(), b.points())) return false;
  for (std::size_t t = 0; t < std::max(a.triangle_count(), b.triangle_count()); ++t) {
    if (t >= a.triangle_count() || t >= b.triangle_count()) return false;
    if (a.vertices(TriangleId(t)) != b.vertices(TriangleId(t))) return false;
  }
  return true;
}

void coarsen_all(Forest& forest) {
  while (!forest.coarsen(all_triangles(forest.mesh())).vertices.empty()) {
  }
}

struct Interrupted {
  Forest forest;
  Refinement done;
};

// \return how often a part of the work was done
std::size_t check_interrupted_bisect(const Forest& start, std::span<const TriangleId> marked,
                                     unsigned threads) {
  Forest undisturbed = start;
  undisturbed.bisect(marked);
  const auto expected = triangles_of(undisturbed.mesh());
  std::size_t partly = 0;
  const std::size_t failures = fail_in_turn(
      [&] {
        return Interrupted{start, {}};
      },
      [&](Interrupted& i) { i.forest.bisect(marked, {.threads = threads}, i.done); },
      [&](Interrupted& i) {
        const Mesh& mesh = i.forest.mesh();
        REQUIRE(validate(mesh, {.delaunay = false}).summary() == "valid");
        std::vector<Point> points(start.mesh().points().begin(), start.mesh().points().end());
        transfer_vertices(i.done, points);  // the log has what was done
        REQUIRE(std::ranges::equal(points, mesh.points()));
        REQUIRE(mesh.triangle_count() == start.mesh().triangle_count() + i.done.triangles.size());
        partly += i.done.triangles.empty() ? 0 : 1;
        std::vector<TriangleId> left(marked.begin(), marked.end());
        std::erase_if(left,
                      [&](TriangleId t) { return i.forest.generation(t) > start.generation(t); });
        i.forest.bisect(left);  // and no state sticks
        REQUIRE(triangles_of(mesh) == expected);
        coarsen_all(i.forest);
        REQUIRE(mesh.triangle_count() == start.root_count());
      });
  CHECK(failures > 10);
  return partly;
}

}  // namespace

TEST_CASE("memory that ends during bisect leaves a conforming mesh, a true log and no marks") {
  std::mt19937_64 random(21);
  const Mesh mesh = integer_mesh(random, 20);
  Forest fresh(mesh), used(mesh);
  for (int i = 0; i < 3; ++i) used.bisect(some_triangles(random, used.mesh(), 10));
  used.coarsen(some_triangles(random, used.mesh(), used.mesh().triangle_count()));
  CHECK(check_interrupted_bisect(fresh, some_triangles(random, mesh, 12), 1) > 0);
  CHECK(check_interrupted_bisect(used, some_triangles(random, used.mesh(), 12), 1) > 0);
}

TEST_CASE("memory that ends while two threads bisect, or one is asked for, likewise") {
  std::mt19937_64 random(22);
  Forest forest(integer_mesh(random, 20));
  while (forest.mesh().triangle_count() < 1500) forest.bisect(all_triangles(forest.mesh()));
  check_interrupted_bisect(forest, all_triangles(forest.mesh()), 2);
}

TEST_CASE("memory that ends before coarsen leaves all as it was") {
  std::mt19937_64 random(23);
  Forest start(integer_mesh(random, 20));
  for (int i = 0; i < 4; ++i) start.bisect(some_triangles(random, start.mesh(), 10));
  const auto marked = all_triangles(start.mesh());
  Forest undisturbed = start;
  undisturbed.coarsen(marked);
  const std::size_t failures =
      fail_in_turn([&] { return start; }, [&](Forest& forest) { forest.coarsen(marked); },
                   [&](Forest& forest) {
                     REQUIRE(have_same_triangles(forest.mesh(), start.mesh()));
                     forest.coarsen(marked);
                     REQUIRE(have_same_triangles(forest.mesh(), undisturbed.mesh()));
                   });
  CHECK(failures >= 4);
}

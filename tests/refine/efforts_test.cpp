// What every effort and placement promises, on random inputs.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>

#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

constexpr std::array efforts{Effort::fast, Effort::normal, Effort::best};
constexpr std::array placements{Placement::centroid, Placement::midpoint, Placement::offcentre,
                                Placement::best};

// Random points in a square with a free segment: much for relocation and clean-up to do.
Pslg random_points(std::mt19937_64& random, int points) {
  std::uniform_real_distribution<double> coordinate(0.05, 0.95);
  Pslg pslg = test::unit_square();
  test::add_chain(pslg, {{0.2, 0.02}, {0.8, 0.98}}, false);
  for (int i = 0; i < points; ++i) pslg.points.push_back({coordinate(random), coordinate(random)});
  return pslg;
}

std::string check(const Mesh& mesh, const RefineOptions& options, const RefineReport& report) {
  MeshClaims claims;
  claims.min_angle_deg = options.min_angle_deg;
  claims.nonobtuse = options.obtuse == ObtuseRule::split_first;
  claims.unfinished = report.unfinished;
  return validate(mesh, claims).summary();
}

}  // namespace

TEST_CASE("every effort and placement: valid, each reason holds, two runs give equal bytes") {
  std::mt19937_64 random(41);
  for (int i = 0; i < 12; ++i) {
    const Pslg pslg = i % 2 == 0 ? random_points(random, 40) : test::random_star(random);
    const Mesh start = constrained_delaunay(pslg).mesh;
    for (const Effort effort : efforts) {
      for (const Placement placement : placements) {
        CAPTURE(i);
        CAPTURE(static_cast<int>(effort));
        CAPTURE(static_cast<int>(placement));
        RefineOptions options;
        options.effort = effort;
        options.placement = placement;
        options.max_vertices = 5000;
        if (i % 3 == 2) options.obtuse = ObtuseRule::ignore;
        Mesh mesh = start, again = start;
        const RefineReport report = refine(mesh, options);
        CHECK(check(mesh, options, report) == "valid");
        CHECK(mesh.vertex_count() == start.vertex_count() + report.steiner_points);
        const RefineReport same = refine(again, options);
        CHECK(std::ranges::equal(mesh.points(), again.points()));
        CHECK(std::ranges::equal(mesh.triangles(), again.triangles(), {}, &Triangle::vertices,
                                 &Triangle::vertices));
        CHECK(report.unfinished == same.unfinished);
      }
    }
  }
}

TEST_CASE("more effort takes fewer vertices, and fewer than the centroid rule") {
  std::mt19937_64 random(42);
  std::size_t total[4] = {};
  for (int i = 0; i < 5; ++i) {
    const Mesh start = constrained_delaunay(random_points(random, 300)).mesh;
    for (std::size_t k = 0; k < 4; ++k) {
      RefineOptions options;
      if (k == 3) options.placement = Placement::centroid;
      else options.effort = efforts[k];
      Mesh mesh = start;
      CHECK(refine(mesh, options).goal_reached);
      total[k] += mesh.vertex_count() - start.vertex_count();
    }
  }
  CHECK(total[0] < total[3]);
  CHECK(total[1] < 0.9 * static_cast<double>(total[0]));
  CHECK(total[2] < 0.95 * static_cast<double>(total[1]));
}

TEST_CASE("36 degrees is reached with normal effort, 40 with the best") {
  std::mt19937_64 random(43);
  for (const auto& [effort, bound] : {std::pair{Effort::normal, 36.0}, {Effort::best, 40.0}}) {
    Mesh mesh = constrained_delaunay(random_points(random, 200)).mesh;
    RefineOptions options;
    options.effort = effort;
    options.min_angle_deg = bound;
    CHECK(refine(mesh, options).goal_reached);
    CHECK(measure(mesh).min_angle_deg >= bound - 1e-9);
    CHECK(measure(mesh).obtuse_constrained.exact == 0);
  }
}

TEST_CASE("clean-up keeps the sizes that were asked for") {
  for (const Effort effort : efforts) {
    Mesh mesh = constrained_delaunay(test::l_shape()).mesh;
    RefineOptions options;
    options.effort = effort;
    options.max_edge = 0.11;
    options.max_area = 0.004;
    const RefineReport report = refine(mesh, options);
    CHECK(report.goal_reached);
    CHECK(report.unfinished.empty());
    CHECK(check(mesh, options, report) == "valid");
  }
}

TEST_CASE("vertices and edges of the input stay, with every effort") {
  std::mt19937_64 random(44);
  for (const Effort effort : efforts) {
    const Pslg pslg = random_points(random, 100);
    Mesh mesh = constrained_delaunay(pslg).mesh;
    RefineOptions options;
    options.effort = effort;
    refine(mesh, options);
    for (std::size_t p = 0; p < pslg.points.size(); ++p) {
      CHECK(mesh.point(VertexId(p)) == pslg.points[p]);
      CHECK(mesh.is_input(VertexId(p)));
    }
  }
}

// The point that serves an obtuse target best may lie so far off that the target stays.
TEST_CASE("a target that outlives an insertion comes up again: no obtuse triangle is left") {
  std::mt19937_64 random(43);
  RefineOptions options;
  options.max_angle_deg = 90;
  Mesh mesh = constrained_delaunay(random_points(random, 400)).mesh;
  const RefineReport report = refine(mesh, options);
  CHECK(report.goal_reached);
  CHECK(check(mesh, options, report) == "valid");
  CHECK(measure(mesh).max_angle_deg <= 90 + 1e-9);
}

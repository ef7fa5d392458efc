#include "lepp/refine/refine.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

const std::vector<double> pentagon{-0.3372, 0.5042,  -0.4814, 0.3712, -0.1441,
                                   0.0723,  -0.1222, -0.4167, 0.3889, -0.1868};
const std::vector<double> heptagon{0.37042,  0.33151,  0.53195, 0.58458,  0.25813,
                                   0.57079,  0.20484,  0.64505, -0.15678, 0.00179,
                                   -0.10132, -0.16080, 0.40345, -0.21862};

RefineOptions paper_options() {
  RefineOptions options;
  options.placement = Placement::midpoint;
  options.obtuse = ObtuseRule::ignore;
  return options;
}

// Refines and checks mesh and report against each other.
RefineReport refine_and_check(Mesh& mesh, const RefineOptions& options) {
  const std::size_t before = mesh.vertex_count();
  const RefineReport report = refine(mesh, options);
  MeshClaims claims;
  claims.min_angle_deg = options.min_angle_deg;
  claims.nonobtuse = options.obtuse == ObtuseRule::split_first;
  claims.unfinished = report.unfinished;
  CHECK(validate(mesh, claims).summary() == "valid");
  CHECK(mesh.vertex_count() - before == report.steiner_points);
  bool forced = true;
  for (const Unfinished& u : report.unfinished) forced = forced && is_forced_by_input(u.reason);
  CHECK(report.goal_reached == forced);
  return report;
}

double longest_edge_of(const Mesh& mesh) {
  double longest = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    longest =
        std::max({longest, squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  }
  return std::sqrt(longest);
}

}  // namespace

TEST_CASE("refine reaches the angle bound it was given, and makes boundaries nonobtuse") {
  for (const double bound : {0.0, 20.0, 25.66, 28.0, 30.0, 33.0}) {
    CAPTURE(bound);
    for (const Pslg& pslg : {test::l_shape(), test::example_1(), test::polygon(pentagon)}) {
      Mesh mesh = constrained_delaunay(pslg).mesh;
      RefineOptions options;
      options.min_angle_deg = bound;
      CHECK(refine_and_check(mesh, options).goal_reached);
      CHECK(measure(mesh).min_angle_deg >= bound - 1e-9);
      CHECK(measure(mesh).obtuse_constrained.exact == 0);
    }
  }
}

TEST_CASE("a 57 x 1 strip takes exactly 94 insertions with the constrained second-longest rule") {
  for (const Placement placement : {Placement::centroid, Placement::midpoint}) {
    Mesh mesh = constrained_delaunay(test::polygon({0, 0, 57, 0, 57, 1, 0, 1})).mesh;
    RefineOptions options = paper_options();
    options.placement = placement;
    CHECK(refine_and_check(mesh, options).steiner_points == 94);
    CHECK(mesh.triangle_count() == 96);
    CHECK(measure(mesh).min_angle_deg == doctest::Approx(41.69).epsilon(1e-3));
  }
}

TEST_CASE("the rectangles on which terminal midpoints alone run for ever take few insertions") {
  const std::vector<std::pair<double, double>> height_and_bound{{2, 30}, {2.5, 22}, {4, 15}};
  for (const auto& [height, bound] : height_and_bound) {
    Mesh mesh = constrained_delaunay(test::polygon({0, 0, 1, 0, 1, height, 0, height})).mesh;
    RefineOptions options = paper_options();
    options.min_angle_deg = bound;
    CHECK(refine_and_check(mesh, options).goal_reached);
    CHECK(mesh.vertex_count() < 20);
  }
}

TEST_CASE("the pentagon takes 6 insertions by rule C") {
  Mesh mesh = constrained_delaunay(test::polygon(pentagon)).mesh;
  CHECK(refine_and_check(mesh, paper_options()).steiner_points == 6);
}

TEST_CASE("the heptagon: midpoints run into the budget with a valid mesh, centroids end") {
  Mesh mesh = constrained_delaunay(test::polygon(heptagon)).mesh;
  RefineOptions options = paper_options();
  options.max_vertices = 3000;
  const RefineReport report = refine_and_check(mesh, options);
  CHECK_FALSE(report.goal_reached);
  CHECK(mesh.vertex_count() == 3000);
  REQUIRE_FALSE(report.unfinished.empty());
  CHECK(report.unfinished.front().reason == Reason::budget);

  Mesh centroid = constrained_delaunay(test::polygon(heptagon)).mesh;
  CHECK(refine_and_check(centroid, {}).goal_reached);
  CHECK(centroid.vertex_count() < 25);
}

TEST_CASE("random polygons with input angles of any size: the goal is reached, each reason holds") {
  const unsigned seed = 2026;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i);
    Mesh mesh = constrained_delaunay(test::random_star(random)).mesh;
    REQUIRE(refine_and_check(mesh, {}).goal_reached);
  }
}

TEST_CASE("interfaces that meet at random angles: the goal is reached") {
  const unsigned seed = 2027;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (const int interfaces : {2, 4, 6}) {
    for (int i = 0; i < 60; ++i) {
      CAPTURE(interfaces);
      CAPTURE(i);
      const Pslg star = test::random_star(random, interfaces);
      if (!validate(star).empty()) continue;  // an interface leaves the polygon
      Mesh mesh = constrained_delaunay(star).mesh;
      REQUIRE(refine_and_check(mesh, {}).goal_reached);
    }
  }
}

TEST_CASE("at any bound up to 45 degrees refine returns with a valid mesh") {
  std::mt19937_64 random(45);
  for (const double bound : {36.0, 40.0, 45.0}) {
    for (int i = 0; i < 10; ++i) {
      Mesh mesh = constrained_delaunay(test::random_star(random)).mesh;
      RefineOptions options;
      options.min_angle_deg = bound;
      options.max_vertices = 2000;
      refine_and_check(mesh, options);
      CHECK(mesh.vertex_count() <= 2000 + 20);
    }
  }
}

TEST_CASE("an obtuse angle that the budget leaves is no input angle: the goal is not reached") {
  Mesh mesh = constrained_delaunay(test::polygon({0, 0, 4, 0, 3.6, 0.65})).mesh;
  RefineOptions options;
  options.max_vertices = 3;
  const RefineReport report = refine(mesh, options);
  CHECK_FALSE(report.goal_reached);
  REQUIRE(report.unfinished.size() == 1);
  CHECK(report.unfinished[0].reason == Reason::budget);
}

TEST_CASE("sizes: longest edge, largest area, and area per region") {
  Pslg pslg = test::polygon({0, 0, 2, 0, 2, 1, 0, 1});
  test::add_chain(pslg, {{1, 0}, {1, 1}}, false);
  const double none = std::numeric_limits<double>::infinity();
  pslg.entities.surfaces = {{1, {}, 1, 0.001}, {2, {}, 2, none}};
  pslg.seeds = {{{0.5, 0.5}, SurfaceId(0U)}, {{1.5, 0.5}, SurfaceId(1U)}};
  Mesh mesh = constrained_delaunay(pslg).mesh;
  RefineOptions options;
  SUBCASE("edge") {
    options.max_edge = 0.1;
    CHECK(refine_and_check(mesh, options).goal_reached);
    CHECK(longest_edge_of(mesh) <= 0.1);
  }
  SUBCASE("area per region") {
    CHECK(refine_and_check(mesh, options).goal_reached);
    std::size_t left = 0, right = 0;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(t));
      const bool in_left = mesh.region(TriangleId(t)) == SurfaceId(0U);
      (in_left ? left : right) += 1;
      if (in_left) CHECK(signed_area(a, b, c) <= 0.001);
    }
    CHECK(left >= 1000);
    CHECK(right < left / 4);
  }
}

TEST_CASE("options out of range and sizes beyond any memory are refused before work starts") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  for (const double angle : {-1.0, 46.0, std::numeric_limits<double>::quiet_NaN()}) {
    RefineOptions options;
    options.min_angle_deg = angle;
    CHECK_THROWS_AS(refine(mesh, options), InputError);
  }
  RefineOptions tiny;
  tiny.max_edge = 1e-9;
  CHECK_THROWS_AS(refine(mesh, tiny), RefusedError);
  tiny.max_edge = -1;
  CHECK_THROWS_AS(refine(mesh, tiny), InputError);
  CHECK(mesh.vertex_count() == 4);
}

TEST_CASE("the caller can stop it, and gets a valid mesh and the reason") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  RefineOptions options;
  options.max_edge = 0.01;
  options.progress = [](std::size_t vertices) { return vertices < 500; };
  const RefineReport report = refine_and_check(mesh, options);
  CHECK(mesh.vertex_count() == 500);
  REQUIRE_FALSE(report.unfinished.empty());
  CHECK(report.unfinished.front().reason == Reason::cancelled);
}

// A fan of two degrees, where several attempts are made.
TEST_CASE("once the caller has stopped it, it asks no more, and says that it was cancelled") {
  Pslg pslg = test::unit_square();
  test::add_chain(pslg, {{0.9, 0.5}, {0.2, 0.5}, {0.9, 0.5 + 0.7 * 0.035}}, false);
  const Mesh start = constrained_delaunay(pslg).mesh;
  for (const std::size_t most : {std::size_t{20}, std::size_t{500}, std::size_t{5000}}) {
    CAPTURE(most);
    Mesh mesh = start;
    RefineOptions options;
    options.max_angle_deg = 90;
    std::size_t asked = 0, asked_again = 0;
    bool stopped = false;
    options.progress = [&](std::size_t) {
      asked_again += stopped ? 1 : 0;
      stopped = ++asked >= most;
      return !stopped;
    };
    const RefineReport report = refine(mesh, options);
    CHECK(asked_again == 0);
    if (!stopped) continue;
    REQUIRE_FALSE(report.unfinished.empty());
    CHECK(std::ranges::any_of(report.unfinished,
                              [](const Unfinished& u) { return u.reason == Reason::cancelled; }));
    CHECK_FALSE(report.goal_reached);
    CHECK(validate(mesh, {.unfinished = report.unfinished}).summary() == "valid");
  }
}

TEST_CASE("two runs give the same mesh") {
  const auto run = [] {
    Mesh mesh = constrained_delaunay(test::example_1()).mesh;
    refine(mesh, {});
    return std::vector<Point>(mesh.points().begin(), mesh.points().end());
  };
  CHECK(run() == run());
}

TEST_CASE("improve works on the caller's targets with the caller's indicator only") {
  // Two long strips; only triangles of the first are targets.
  Pslg pslg = test::polygon({0, 0, 30, 0, 30, 1, 0, 1});
  test::add_chain(pslg, {{0, 5}, {30, 5}, {30, 6}, {0, 6}}, true);
  Mesh mesh = constrained_delaunay(pslg).mesh;
  std::vector<TriangleId> targets;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.corners(TriangleId(t))[0].y < 2) targets.emplace_back(t);
  }
  QualityIndicator aspect;
  aspect.q = [](const Mesh& m, TriangleId t) {  // 1 for an equilateral triangle
    const auto [a, b, c] = m.corners(t);
    const double sides = squared_distance(a, b) + squared_distance(b, c) + squared_distance(c, a);
    return 4 * std::sqrt(3.0) * signed_area(a, b, c) / sides;
  };
  aspect.epsilon = 0.7;
  const RefineReport report = improve(mesh, targets, aspect);
  CHECK(report.goal_reached);
  CHECK(report.unfinished.empty());
  CHECK(validate(mesh).summary() == "valid");
  std::size_t above = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.corners(TriangleId(t))[0].y > 2) ++above;
    else CHECK(aspect.q(mesh, TriangleId(t)) >= 0.7);
  }
  CHECK(above == 2);
}

TEST_CASE("every vertex and segment of the input survives refinement") {
  std::mt19937_64 random(8);
  for (int i = 0; i < 50; ++i) {
    const Pslg pslg = test::random_star(random);
    Mesh mesh = constrained_delaunay(pslg).mesh;
    refine(mesh, {});
    for (std::size_t p = 0; p < pslg.points.size(); ++p) {
      CHECK(mesh.point(VertexId(p)) == pslg.points[p]);
    }
    CHECK(mesh.segments().size() == pslg.segments.size());  // chains: M5, checked by validate
    CHECK(validate(mesh).summary() == "valid");
  }
}

#include "lepp/nonobtuse/nonobtuse.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

Mesh refined_by_paper(const Pslg& pslg) {
  Mesh mesh = constrained_delaunay(pslg).mesh;
  RefineOptions options;
  options.placement = Placement::midpoint;
  options.obtuse = ObtuseRule::ignore;
  options.max_vertices = 5000;
  refine(mesh, options);
  return mesh;
}

double smallest_input_angle(const Pslg& polygon) {
  double smallest = 180;
  const std::size_t n = polygon.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = polygon.points[(i + n - 1) % n], b = polygon.points[i],
                c = polygon.points[(i + 1) % n];
    smallest = std::min(smallest, angles_deg(a, b, c)[1]);
  }
  return smallest;
}

// Triangle BAC with angle beta at B = (0, 0), |BC| = 1 and |BA| a little below 2 cos(beta): obtuse
// at C, BA and BC on the boundary. Its smallest side CA is interior: an equilateral triangle ACX
// lies beyond.
Pslg wedge(double beta_deg) {
  const double beta = beta_deg * std::numbers::pi / 180;
  const Point a{2 * std::cos(beta) - 1e-9, 0}, c{std::cos(beta), std::sin(beta)};
  const Point ac = c - a;
  const Point x = midpoint(a, c) + std::sqrt(0.75) * Point{ac.y, -ac.x};
  return test::polygon({0, 0, a.x, a.y, x.x, x.y, c.x, c.y});
}

}  // namespace

TEST_CASE("Example 1 of the paper: 21 obtuse angles go with 17 insertions") {
  Mesh mesh = refined_by_paper(test::example_1());
  const Quality before = measure(mesh);
  CHECK(before.vertices == doctest::Approx(98).epsilon(0.03));
  CHECK(before.triangles == doctest::Approx(127).epsilon(0.03));
  CHECK(std::abs(static_cast<double>(before.obtuse_constrained.exact) - 21) <= 3);
  const NonobtuseReport report = make_boundary_nonobtuse(mesh);
  CHECK(report.goal_reached);
  CHECK(std::abs(static_cast<double>(report.steiner_points) - 17) <= 3);
  const Quality after = measure(mesh);
  CHECK(after.obtuse_constrained.exact == 0);
  CHECK(after.min_angle_deg > 30);
  CHECK(after.mean_min_angle_deg == doctest::Approx(44.86).epsilon(0.02));
  CHECK(after.mean_max_angle_deg == doctest::Approx(80.8).epsilon(0.02));
  CHECK(validate(mesh, {.min_angle_deg = 30, .nonobtuse = true}).summary() == "valid");
}

TEST_CASE("Theorem 4 and Corollary 1: one insertion per obtuse angle, or per pair of them") {
  const unsigned seed = 44;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  int met = 0;
  for (int i = 0; met < 150 && i < 20000; ++i) {
    const Pslg pslg = test::random_star(random);
    if (smallest_input_angle(pslg) < 45) continue;
    Mesh mesh = refined_by_paper(pslg);
    if (measure(mesh).min_angle_deg < 30 - 1e-9) continue;  // midpoints did not end
    const std::size_t obtuse = measure(mesh).obtuse_constrained.exact;
    const NonobtuseReport report = make_boundary_nonobtuse(mesh);
    REQUIRE(report.goal_reached);
    REQUIRE(report.two_edge == 0);
    REQUIRE(report.steiner_points == obtuse);  // all on the boundary
    REQUIRE(report.one_edge_boundary == obtuse);
    REQUIRE(measure(mesh).obtuse_constrained.exact == 0);
    REQUIRE(validate(mesh, {.nonobtuse = true}).summary() == "valid");
    met += obtuse > 0 ? 1 : 0;
  }
  CHECK(met == 150);
}

TEST_CASE("Corollary 1 with interfaces: N1b + N1i/2 <= insertions <= N1b + N1i") {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform;
  int with_interfaces = 0;
  for (int i = 0; i < 60; ++i) {
    Pslg pslg = test::polygon({0, 0, 8 + uniform(random), 0, 8, 2, 0, 2 + uniform(random)});
    test::add_chain(pslg, {{1 + uniform(random), 1}, {6 + uniform(random), 1.1}}, false);
    Mesh mesh = refined_by_paper(pslg);
    const NonobtuseReport report = make_boundary_nonobtuse(mesh);
    REQUIRE(report.goal_reached);
    const double boundary = static_cast<double>(report.one_edge_boundary);
    const double interface = static_cast<double>(report.one_edge_interface);
    const double inserted = static_cast<double>(report.steiner_points);
    REQUIRE(report.two_edge == 0);
    REQUIRE(boundary + interface / 2 <= inserted);
    REQUIRE(inserted <= boundary + interface);
    with_interfaces += report.one_edge_interface > 0 ? 1 : 0;
  }
  CHECK(with_interfaces > 10);
}

TEST_CASE("Theorem 5: above 32.53 degrees the obtuse angle goes with exactly two points") {
  for (const double beta : {33.0, 36.0, 40.0, 44.0}) {
    CAPTURE(beta);
    Mesh mesh = constrained_delaunay(wedge(beta)).mesh;
    const NonobtuseReport report = make_boundary_nonobtuse(mesh);
    CHECK(report.goal_reached);
    CHECK(report.two_edge == 1);
    CHECK(report.steiner_points == 2);
  }
}

TEST_CASE("Theorem 5: below that, C alone costs a logarithmic number of points on NA") {
  // B, N and A on the lower side, N where the isosceles triangle puts it; C a lone vertex above.
  // Bound: log2((L - l/2) / (2 l sin beta)), rounded up, with l = |BC| = 1 and L = |BA|.
  const std::vector<std::pair<double, std::size_t>> at_most{{1, 6},  {2, 5},  {5, 4},
                                                            {10, 3}, {15, 2}, {20, 2}};
  for (const auto& row : at_most) {
    const auto& beta_deg = row.first;
    const auto& bound = row.second;
    CAPTURE(beta_deg);
    const double beta = beta_deg * std::numbers::pi / 180, longest = 2 * std::cos(beta) - 1e-9;
    Pslg pslg = test::polygon({0, 0, 0.5, 0, longest, 0, longest, 3, 0, 3});
    pslg.points.push_back({std::cos(beta), std::sin(beta)});
    Mesh mesh = constrained_delaunay(pslg).mesh;
    const NonobtuseReport report = make_boundary_nonobtuse(mesh);
    CHECK(report.goal_reached);
    std::size_t on_na = 0;
    for (std::size_t v = pslg.points.size(); v < mesh.vertex_count(); ++v) {
      if (mesh.point(VertexId(v)).y == 0) ++on_na;
    }
    CHECK(on_na >= 1);
    CHECK(on_na <= bound);
    const double formula = std::ceil(std::log2((longest - 0.5) / (2 * std::sin(beta))));
    CHECK(static_cast<double>(bound) >= formula);
  }
}

TEST_CASE("narrow wedges of two constrained edges end nonobtuse") {
  for (const double beta : {1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0}) {
    CAPTURE(beta);
    Mesh mesh = constrained_delaunay(wedge(beta)).mesh;
    const NonobtuseReport report = make_boundary_nonobtuse(mesh);
    CHECK(report.goal_reached);
    CHECK(report.two_edge >= 1);
    CHECK(validate(mesh, {.nonobtuse = true}).summary() == "valid");
  }
}

TEST_CASE("the isosceles triangle leaves the angles that theory gives, and 32.5342 is the limit") {
  // Two insertions allowed: M and N. Then the angle at C in the mesh's triangle of C and A.
  const auto angle_after = [](double beta_deg) {
    const Pslg pslg = wedge(beta_deg);
    Mesh mesh = constrained_delaunay(pslg).mesh;
    make_boundary_nonobtuse(mesh, {.max_vertices = pslg.points.size() + 2});
    const VertexId a(1U), c(3U), n(5U);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto& v = mesh.vertices(TriangleId(t));
      const auto has = [&](VertexId x) { return std::ranges::find(v, x) != v.end(); };
      if (has(a) && has(c) && has(n)) {
        return angles_deg(mesh.point(n), mesh.point(c), mesh.point(a))[1];
      }
    }
    return 0.0;
  };
  const std::vector<std::pair<double, double>> table{{5, 165.0},  {10, 150.3}, {15, 135.9},
                                                     {20, 122.1}, {25, 108.9}, {30, 96.2},
                                                     {35, 84.1},  {40, 72.5}};
  for (const auto& row : table) {
    const auto& beta = row.first;
    const auto& expected = row.second;
    CAPTURE(beta);
    CHECK(angle_after(beta) == doctest::Approx(expected).epsilon(1e-3));
  }
  CHECK(angle_after(32.5342) == doctest::Approx(90).epsilon(1e-5));
}

TEST_CASE("Proposition 2: insertions are linear in the number of obtuse angles") {
  std::size_t most = 0;
  for (const double length : {30.0, 60.0, 120.0, 240.0}) {
    CAPTURE(length);
    Pslg pslg = test::polygon({0, 0, length, 0, length, 1, 0, 1});
    test::add_chain(pslg, {{0.18 * length, 0.439}, {0.81 * length, 0.447}}, false);
    Mesh mesh = refined_by_paper(pslg);
    const std::size_t obtuse = measure(mesh).obtuse_constrained.exact;
    const NonobtuseReport report = make_boundary_nonobtuse(mesh);
    CHECK(report.goal_reached);
    CHECK(obtuse > most);
    CHECK(report.steiner_points <= obtuse);
    most = obtuse;
  }
}

TEST_CASE("fans of interfaces: the paper's rules end with no obtuse angle") {
  std::mt19937_64 random(99);
  for (int i = 0; i < 40; ++i) {
    const Pslg star = test::random_star(random, 4);
    if (!validate(star).empty()) continue;
    Mesh mesh = refined_by_paper(star);
    REQUIRE(make_boundary_nonobtuse(mesh).goal_reached);
    REQUIRE(validate(mesh, {.nonobtuse = true}).summary() == "valid");
  }
}

TEST_CASE("the budget stops it with a valid mesh and the list of what is left") {
  Mesh mesh = refined_by_paper(test::example_1());
  const NonobtuseReport report =
      make_boundary_nonobtuse(mesh, {.max_vertices = mesh.vertex_count() + 3});
  CHECK_FALSE(report.goal_reached);
  CHECK_FALSE(report.obtuse.empty());
  CHECK(validate(mesh).summary() == "valid");
}

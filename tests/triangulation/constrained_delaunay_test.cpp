#include "lepp/triangulation/constrained_delaunay.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

Triangulation valid_cdt(const Pslg& pslg, const TriangulationOptions& options = {}) {
  Triangulation made = constrained_delaunay(pslg, options);
  CHECK(validate(made.mesh).summary() == "valid");
  return made;
}

std::string error_of(const Pslg& pslg) {
  try {
    constrained_delaunay(pslg);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a square has two triangles and its area") {
  const Mesh mesh = valid_cdt(test::unit_square()).mesh;
  CHECK(mesh.triangle_count() == 2);
  CHECK(total_area(mesh) == 1);
}

TEST_CASE("holes, nested holes and what lies in them") {
  Pslg pslg = test::polygon({0, 0, 8, 0, 8, 8, 0, 8});
  test::add_chain(pslg, {{1, 1}, {7, 1}, {7, 7}, {1, 7}}, true);
  test::add_chain(pslg, {{2, 2}, {6, 2}, {6, 6}, {2, 6}}, true);
  test::add_chain(pslg, {{3, 3}, {5, 3}, {5, 5}, {3, 5}}, true);
  SUBCASE("no hole points: rings are interfaces") { CHECK(total_area(valid_cdt(pslg).mesh) == 64); }
  SUBCASE("ring, hole, island, hole") {
    pslg.holes = {{1.5, 1.5}, {4, 4}};
    const Mesh mesh = valid_cdt(pslg).mesh;
    CHECK(total_area(mesh) == 64 - 36 + 16 - 4);
    CHECK(mesh.vertex_count() == 16);
  }
}

TEST_CASE("regions: each area gets the surface of the seed in it, others the default one") {
  Pslg pslg = test::polygon({0, 0, 2, 0, 2, 1, 0, 1});
  test::add_chain(pslg, {{1, 0}, {1, 1}}, false);
  pslg.entities.surfaces = {{4, {}, 4, 1e9}, {5, {}, 5, 1e9}};
  pslg.seeds = {{{0.5, 0.5}, SurfaceId(0U)}, {{1.5, 0.5}, SurfaceId(1U)}};
  const Mesh mesh = valid_cdt(pslg).mesh;
  CHECK(measure_entities(mesh).surface_areas == std::vector<double>{1, 1});
  pslg.seeds.pop_back();
  const Mesh half = valid_cdt(pslg).mesh;
  CHECK(half.entities().surfaces.size() == 3);
  CHECK(measure_entities(half).surface_areas == std::vector<double>{1, 0, 1});
}

TEST_CASE("surfaces known by their boundaries: inside one is in, inside none is out") {
  // Two squares that share an edge, one with a square hole, drawn by curves with bounds.
  Pslg pslg = test::polygon({0, 0, 3, 0, 3, 3, 0, 3});
  test::add_chain(pslg, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, true);
  test::add_chain(pslg, {{3, 0}, {6, 0}, {6, 3}, {3, 3}}, false);
  const SurfaceId left(0U), right(1U);
  pslg.entities.surfaces = {{10, {}, 10, 1e9}, {20, {}, 20, 1e9}};
  pslg.entities.curves = {{1, {}, StraightCurve{}, {left}},
                          {2, {}, StraightCurve{}, {left, right}},
                          {3, {}, StraightCurve{}, {right}}};
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    pslg.segments[s].curve = CurveId(s == 1 ? 1U : s < 8 ? 0U : 2U);
  }
  SUBCASE("areas") {
    const Mesh mesh = valid_cdt(pslg).mesh;
    CHECK(measure_entities(mesh).surface_areas == std::vector<double>{8, 9});
  }
  SUBCASE("a boundary with a gap names the surface") {
    pslg.segments.pop_back();
    CHECK(contains(error_of(pslg), "surface 20"));
    CHECK(contains(error_of(pslg), "not closed"));
  }
  SUBCASE("overlapping surfaces are refused by name") {
    for (std::size_t s = 4; s < 8; ++s) pslg.segments[s].curve = CurveId(2U);
    pslg.entities.curves[2].bounds = {right};
    CHECK(contains(error_of(pslg), "surfaces 10 and 20"));
  }
}

TEST_CASE("dangling and isolated segments, and lone points, are kept") {
  Pslg pslg = test::unit_square();
  test::add_chain(pslg, {{0.25, 0.25}, {0.5, 0.3}, {0.7, 0.7}}, false);
  test::add_chain(pslg, {{0, 0.5}, {0.2, 0.6}}, false);
  pslg.points.push_back({0.9, 0.1});
  const Triangulation made = valid_cdt(pslg);
  CHECK(made.mesh.vertex_count() == pslg.points.size());
  CHECK(made.report.points_outside == 0);
  CHECK(total_area(made.mesh) == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE("several components, and points outside all of them") {
  Pslg pslg = test::unit_square();
  test::add_chain(pslg, {{5, 0}, {6, 0}, {6, 1}, {5, 1}}, true);
  pslg.points.push_back({3, 0.5});
  const Triangulation made = valid_cdt(pslg);
  CHECK(total_area(made.mesh) == 2);
  CHECK(made.report.points_outside == 1);
  CHECK_FALSE(made.report.vertex_of_point.back());
}

TEST_CASE("without a closed area the domain is the convex hull") {
  Pslg pslg = test::unit_square();
  pslg.segments.resize(1);
  const Triangulation made = valid_cdt(pslg);
  CHECK(made.report.convex_hull);
  CHECK(total_area(made.mesh) == 1);
}

TEST_CASE("duplicate points are merged and reported with the user's numbers") {
  Pslg pslg = test::unit_square();
  pslg.base = 1;
  pslg.points.push_back({1, 1});
  pslg.segments[2].a = VertexId(4U);
  const Triangulation made = valid_cdt(pslg);
  CHECK(made.report.duplicate_points == 1);
  CHECK(made.report.first_duplicate == std::pair<std::int64_t, std::int64_t>{3, 5});
  CHECK(made.mesh.vertex_count() == 4);
  CHECK(made.report.vertex_of_point[4] == VertexId(2U));
}

TEST_CASE("a point on a segment cuts it; overlapping segments share edges and keep their tags") {
  const double coordinates[] = {0, 0, 3, 0, 3, 1, 0, 1, 1, 0, 2, 0};
  const std::uint32_t segments[] = {0, 1, 1, 2, 2, 3, 3, 0, 4, 5};
  const int tags[] = {1, 2, 3, 4, 5};
  const Pslg pslg = pslg_from_arrays(coordinates, segments, tags);
  const Triangulation made = valid_cdt(pslg);
  const auto lengths = measure_entities(made.mesh).curve_lengths;
  CHECK(lengths == std::vector<double>{3, 1, 3, 1, 1});
  CHECK(made.report.overlapping_edges == 1);
  CHECK(made.report.points_on_segments == 2);
}

TEST_CASE("crossing segments are refused with both ids and the point, or split") {
  Pslg pslg = test::unit_square();
  pslg.base = 1;
  pslg.segments.push_back({VertexId(0U), VertexId(2U), {}, 0, 1});
  pslg.segments.push_back({VertexId(1U), VertexId(3U), {}, 0, 1});
  const std::string message = error_of(pslg);
  CHECK(contains(message, "segment 5 and segment 6 cross"));
  CHECK(contains(message, "(0.5, 0.5)"));
  const Triangulation made = valid_cdt(pslg, {Crossings::split});
  CHECK(made.mesh.vertex_count() == 5);
  CHECK(made.report.crossings_split == 1);
}

TEST_CASE("inputs without area, and holes that leak, are refused") {
  Pslg line;
  line.source = "line";
  for (int i = 0; i < 10; ++i) line.points.push_back({0.1 * i, 0.3 * i});
  CHECK(contains(error_of(line), "one line"));
  Pslg single;
  single.points = {{1, 1}};
  CHECK(contains(error_of(single), "fewer than 3"));
  Pslg leaky = test::unit_square();
  leaky.holes = {{0.5, 0.5}};
  CHECK(contains(error_of(leaky), "removes what is left of the domain"));
  leaky.segments.pop_back();
  CHECK(contains(error_of(leaky), "not enclosed"));
}

TEST_CASE("a hole or seed at the end of a segment is on it, whichever triangle it is found in") {
  // A square with one segment inside that ends at (2, 1), a vertex of many triangles.
  const std::vector<double> xy{0, 0, 4, 0, 4, 4, 0, 4, 1, 1, 2, 1};
  const std::vector<std::uint32_t> ends{0, 1, 1, 2, 2, 3, 3, 0, 4, 5};
  for (const Point p : {Point{2, 1}, Point{1, 1}, Point{1.5, 1}, Point{4, 4}}) {
    CAPTURE(p.x);
    Pslg hole = pslg_from_arrays(xy, ends);
    hole.holes = {p};
    CHECK(contains(error_of(hole), "lies on a segment"));
    Pslg seed = pslg_from_arrays(xy, ends);
    seed.entities.surfaces.emplace_back();
    seed.seeds = {{p, SurfaceId(0U)}};
    CHECK(contains(error_of(seed), "lies on a segment"));
  }
}

TEST_CASE("random PSLGs with coincidences, rotations and offsets: M1 to M6, or a named error") {
  const unsigned seed = 71;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  int made = 0;
  for (int i = 0; i < 5000; ++i) {
    CAPTURE(i);
    Pslg pslg;
    const std::size_t points = 4 + random() % 20, segments = random() % 12;
    const auto cells = static_cast<double>(1 + random() % 16);
    const int form = static_cast<int>(random() % 4);
    for (std::size_t p = 0; p < points; ++p) {
      const double x = std::floor(cells * static_cast<double>(random() % 1000) / 999);
      const double y = std::floor(cells * static_cast<double>(random() % 1000) / 999);
      if (form == 0) pslg.points.push_back({x, y});
      if (form == 1) pslg.points.push_back({0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y});
      if (form == 2) pslg.points.push_back({x + 1e7, y - 1e7 - 0.1});
      if (form == 3) pslg.points.push_back({0.1 * x, 0.3 * y});
    }
    for (std::size_t s = 0; s < segments; ++s) {
      pslg.segments.push_back({VertexId(random() % points), VertexId(random() % points), {}, 0, 1});
    }
    try {
      const Triangulation result = constrained_delaunay(pslg, {Crossings::split});
      REQUIRE(validate(result.mesh).summary() == "valid");
      ++made;
    } catch (const InputError& error) {
      REQUIRE_FALSE(error.problem().empty());
    }
  }
  CHECK(made > 4500);
}

TEST_CASE("a triangulation by brute force has the same Delaunay edges") {
  const unsigned seed = 72;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 500; ++i) {
    Pslg pslg;
    for (int p = 0; p < 9; ++p) pslg.points.push_back({uniform(random), uniform(random)});
    const Mesh mesh = constrained_delaunay(pslg).mesh;
    // In general position a triple is a Delaunay triangle iff its circumcircle is empty.
    std::size_t empty = 0;
    const auto at = [&](std::size_t v) { return pslg.points[v]; };
    for (std::size_t a = 0; a < 9; ++a) {
      for (std::size_t b = a + 1; b < 9; ++b) {
        for (std::size_t c = b + 1; c < 9; ++c) {
          const int turn = orient2d(at(a), at(b), at(c));
          bool alone = true;
          for (std::size_t d = 0; d < 9; ++d) {
            alone = alone && (d == a || d == b || d == c ||
                              turn * incircle(at(a), at(b), at(c), at(d)) <= 0);
          }
          if (alone) ++empty;
        }
      }
    }
    REQUIRE(mesh.triangle_count() == empty);
  }
}

TEST_CASE("two regions in one area are refused, and both are named") {
  Pslg pslg = test::unit_square();
  pslg.entities.surfaces.resize(2);
  pslg.seeds = {{{0.25, 0.25}, SurfaceId(0U)}, {{0.75, 0.5}, SurfaceId(1U)}};
  CHECK_THROWS_WITH_AS(constrained_delaunay(pslg), doctest::Contains("region 1 at (0.75, 0.5)"),
                       InputError);
  pslg.seeds[1].surface = SurfaceId(0U);
  CHECK(validate(constrained_delaunay(pslg).mesh).summary() == "valid");
}

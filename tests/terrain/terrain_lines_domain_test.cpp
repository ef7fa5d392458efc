#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "lepp/geometry/error.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/random.hpp"
#include "terrain/coverage.hpp"
#include "terrain/grids.hpp"

using namespace lepp;
using test::grid_of;

namespace {

double area_of(const TerrainDomain& domain) {
  const Mesh mesh = constrained_delaunay(domain.pslg).mesh;
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    area += 0.5 * cross(b - a, c - a);
  }
  return area;
}

/// World coordinates of these grids are columns and lines.
const HeightGrid square = grid_of({"12345", "23456", "34567", "45678", "56789"});

ClipPolygon box(double west, double south, double east, double north) {
  return {{{{west, south}, {east, south}, {east, north}, {west, north}}}};
}

/// The height at a point of the domain.
double height_of(const TerrainDomain& domain, Point p) {
  for (std::size_t i = 0; i < domain.pslg.points.size(); ++i) {
    if (domain.pslg.points[i] == p) return domain.fixed_heights[i];
  }
  FAIL("no such point");
  return 0;
}

std::size_t segments_of_curve(const TerrainDomain& domain, std::uint32_t curve) {
  std::size_t count = 0;
  for (const Segment& s : domain.pslg.segments) count += s.curve == CurveId(curve);
  return count;
}

}  // namespace

TEST_CASE("a clip polygon keeps what is inside it, its corners become vertices") {
  const TerrainDomain domain = terrain_domain(square, {.clip = {box(0.5, 1.25, 2.5, 9)}});
  CHECK(area_of(domain) == doctest::Approx(2 * 2.75));
  CHECK(domain.pslg.points.size() == 4);
  CHECK(validate(domain.pslg).empty());
}

TEST_CASE("a line that begins and ends far beyond the grid is cut by the outline") {
  for (const double far : {1e9, 1e16, 1e20, 1e50}) {
    CAPTURE(far);
    const Breakline line{{{-far, 2.5}, {far, 2.5}}, {7, 7}, "line"};
    const TerrainDomain domain = terrain_domain(square, {.breaklines = {line}});
    CHECK(segments_of_curve(domain, 1) == 1);
    CHECK(height_of(domain, {0, 2.5}) == 7);
    CHECK(height_of(domain, {4, 2.5}) == 7);
  }
}

TEST_CASE("clip polygons are united: overlaps, neighbours, holes, islands in holes") {
  const auto area = [](std::vector<ClipPolygon> clip) {
    return area_of(terrain_domain(square, {.clip = std::move(clip)}));
  };
  CHECK(area({box(0, 0, 2, 2), box(1, 1, 3, 3)}) == doctest::Approx(7));
  CHECK(area({box(0, 0, 2, 2), box(2, 0, 4, 2)}) == doctest::Approx(8));
  ClipPolygon ring = box(0, 0, 4, 4);
  ring.rings.push_back(box(1, 1, 3, 3).rings[0]);
  CHECK(area({ring}) == doctest::Approx(12));
  CHECK(area({ring, box(1.5, 1.5, 2, 2)}) == doctest::Approx(12.25));
  CHECK(area({ring, box(1, 1, 3, 3)}) == doctest::Approx(16));
  ring.rings.push_back(box(1.5, 1.5, 2, 2).rings[0]);
  CHECK(area({ring}) == doctest::Approx(12.25));
  CHECK(area({box(0, 0, 2, 2), box(0, 0, 2, 2)}) == doctest::Approx(4));
}

TEST_CASE("where clip polygons share a side, nothing of it is left") {
  const TerrainDomain domain =
      terrain_domain(square, {.clip = {box(-1, -1, 2, 5), box(2, -1, 5, 5)}});
  CHECK(area_of(domain) == doctest::Approx(16));
  for (const Segment& s : domain.pslg.segments) {
    const Point a = domain.pslg.points[s.a.index()], b = domain.pslg.points[s.b.index()];
    CHECK((a.x != 2 || b.x != 2));
  }
}

TEST_CASE("a clip polygon along the rim in world coordinates leaves no sliver there") {
  HeightGrid grid = square;
  grid.step_x = 1.0 / 1200;
  grid.step_y = -1.0 / 1200;
  grid.cell_width = grid.cell_height = 1;
  grid.origin = {-84.1, 36.7};
  ClipPolygon rim{{{}}};
  for (const Point corner : {Point{0, 0}, Point{4, 0}, Point{4, 4}, Point{0, 4}}) {
    rim.rings[0].push_back(grid.to_world(corner));
  }
  const TerrainDomain domain = terrain_domain(grid, {.clip = {rim}});
  CHECK(domain.pslg.points.size() == 4);
  CHECK(area_of(domain) == 16);
}

TEST_CASE("a clip polygon beside the data is an error, as is one without area or with a NaN") {
  CHECK_THROWS_AS(terrain_domain(square, {.clip = {box(5, 5, 6, 6)}}), InputError);
  CHECK_THROWS_AS(terrain_domain(square, {.clip = {{{{{0, 0}, {1, 1}, {0, 0}}}}}}), InputError);
  CHECK_THROWS_AS(terrain_domain(square, {.clip = {box(0, 0, NAN, 1)}}), InputError);
}

TEST_CASE("a clip polygon that is too small or thin is said to be so, by its own name") {
  const auto message = [](const ClipPolygon& polygon) -> std::string {
    try {
      terrain_domain(square, {.clip = {polygon}});
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != text.npos;
  };
  CHECK(has(message(box(1.2, 1.2, 1.205, 1.205)), "nothing is left of the clip polygons"));
  CHECK(has(message(box(1.2, 1.2, 2.8, 1.203)), "nothing is left of the clip polygons"));
  CHECK(has(message(box(5, 5, 6, 6)), "where the grid has data"));
  CHECK(message(box(1.2, 1.2, 1.4, 1.4)).empty());
  ClipPolygon flat{{{{0, 0}, {1, 1}, {0, 0}}}, "clip.geojson, feature 0"};
  CHECK(has(message(flat), "clip.geojson, feature 0, ring 1"));
}

TEST_CASE("a hard breakline has its heights, also where it enters the domain and is crossed") {
  const Breakline first{{{-2, 2}, {2, 2}, {2, 6}}, {0, 8, 8}, ""};
  const Breakline second{{{1, 1}, {1, 3}}, {50, 70}, ""};
  const Breakline soft{{{3, 1}, {3, 3}}, {}, ""};
  const TerrainDomain domain = terrain_domain(square, {.breaklines = {first, second, soft}});
  CHECK(validate(domain.pslg).empty());
  CHECK(height_of(domain, {0, 2}) == 4);  // halfway along the first segment
  CHECK(height_of(domain, {2, 2}) == 8);
  CHECK(height_of(domain, {2, 4}) == 8);
  CHECK(height_of(domain, {1, 1}) == 50);
  CHECK(height_of(domain, {1, 2}) == 6);  // of the first line, not 60
  CHECK(std::isnan(height_of(domain, {3, 1})));
  CHECK(std::isnan(height_of(domain, {0, 0})));
  CHECK(segments_of_curve(domain, 1) == 3);
  CHECK(segments_of_curve(domain, 2) == 2);
  CHECK(segments_of_curve(domain, 3) == 1);
  REQUIRE(domain.warnings.size() == 1);
  CHECK(domain.warnings[0] ==
        "1 of 3 breaklines lie partly outside the domain; those parts are left out");
}

TEST_CASE("a breakline over a hole or beside the grid loses those parts") {
  const HeightGrid holed = grid_of({"123456", "234567", "34..78", "45..89", "567890", "678901"});
  const Breakline across{{{-1, 2}, {6, 2}}, {}, ""}, beside{{{7, 0}, {7, 3}}, {}, ""};
  const TerrainDomain domain = terrain_domain(holed, {.breaklines = {across, beside}});
  CHECK(segments_of_curve(domain, 1) == 2);
  CHECK(segments_of_curve(domain, 2) == 0);
  CHECK(height_of(domain, {1, 2}) != 0);  // a vertex: the hole begins there
  REQUIRE(domain.warnings.size() == 2);
  CHECK(domain.warnings[0] == "1 of 2 breaklines lie outside the domain and are left out");
}

TEST_CASE("a breakline through a sample that stands alone crosses the square around it") {
  const HeightGrid alone = grid_of({"11...", "11.2.", "....."});
  const TerrainDomain domain = terrain_domain(alone, {.breaklines = {{{{2, 1}, {4, 1}}, {}, ""}}});
  CHECK(segments_of_curve(domain, 1) == 1);
  CHECK(area_of(domain) == 1 + 0.125);
}

TEST_CASE("a line crosses the square around a sample in a corner of the grid beyond the grid") {
  const HeightGrid corner = grid_of({"..11", "..11", "....", "1..."});
  const TerrainDomain domain =
      terrain_domain(corner, {.breaklines = {{{{-0.5, -0.4}, {0.3, 0.3}}, {}, ""}}});
  CHECK(segments_of_curve(domain, 1) == 1);
  CHECK(area_of(domain) == doctest::Approx(1 + 0.125));
}

TEST_CASE("lines that make no sense are named") {
  const auto fails = [](const Breakline& line) {
    try {
      terrain_domain(square, {.breaklines = {line}});
    } catch (const InputError& error) {
      return error.where();
    }
    return std::string();
  };
  CHECK(fails({{{0, 0}, {1, NAN}}, {}, ""}) == "breakline 1");
  CHECK(fails({{{0, 0}, {1, 1e300}}, {}, ""}) == "breakline 1");
  CHECK(fails({{{0, 0}, {1e-300, 1e50}}, {}, ""}) == "");
  CHECK(fails({{{0, 0}, {1, 1}}, {1}, "dyke"}) == "dyke");
  CHECK(fails({{{0, 0}, {1, 1}}, {1, INFINITY}, "dyke"}) == "dyke");
  CHECK(fails({{{1, 1}, {1, 1}, {2, 1}, {2, 1}}, {1, 1, 2, 2}, ""}) == "");
}

TEST_CASE("lines anywhere lose no sample and cover none without data") {
  constexpr std::uint64_t seed = 6;
  CAPTURE(seed);
  test::Random random(seed);
  for (int i = 0; i < 120; ++i) {
    CAPTURE(i);
    const double share = random.real(0.5, 1);
    std::vector<std::string> rows(12, std::string(12, '.'));
    for (std::string& row : rows) {
      for (char& c : row) {
        if (random.real() < share) c = '5';
      }
    }
    // A slope, so that the outline has long slanting segments.
    for (int line = 0; line < 12; ++line) {
      for (int column = 0; column < 12; ++column) {
        if (column + line > 14) rows[11 - line][column] = '.';
        else if (column + line > 11) rows[11 - line][column] = '5';
      }
    }
    const HeightGrid grid = grid_of(rows, i % 2 == 0 ? 1 : 0.3);
    const auto somewhere = [&] { return Point{random.real(-2, 14), random.real(-1, 5)}; };
    DomainOptions options;
    for (int k = 0; k < 4; ++k) options.breaklines.push_back({{somewhere(), somewhere()}, {}, ""});
    const TerrainDomain domain = terrain_domain(grid, options);
    REQUIRE(validate(domain.pslg).empty());
    const auto found = test::coverage(grid, constrained_delaunay(domain.pslg).mesh);
    REQUIRE(found.lost == 0);
    REQUIRE(found.covered == 0);
  }
}

TEST_CASE("short lines in a large grid: the outline far from them is joined to that near them") {
  constexpr std::uint64_t seed = 8;
  CAPTURE(seed);
  test::Random random(seed);
  for (int i = 0; i < 4; ++i) {
    CAPTURE(i);
    std::vector<std::string> rows(70, std::string(90, '5'));
    for (std::string& row : rows) {
      for (char& c : row) {
        if (random.one_in(8)) c = '.';
      }
    }
    const HeightGrid grid = grid_of(rows);
    DomainOptions options;
    for (int k = 0; k < 3; ++k) {
      const Point p{random.real(0, 89), random.real(0, 69)};
      options.breaklines.push_back(
          {{p, p + Point{random.real(-9, 9), random.real(-9, 9)}}, {}, ""});
    }
    const TerrainDomain domain = terrain_domain(grid, options);
    REQUIRE(validate(domain.pslg).empty());
    const Mesh mesh = constrained_delaunay(domain.pslg).mesh;
    CHECK(mesh.vertex_count() == domain.pslg.points.size());
    const auto found = test::coverage(grid, mesh);
    CHECK(found.lost == 0);
    CHECK(found.covered == 0);
  }
}

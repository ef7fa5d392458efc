#include "lepp/terrain/snap_lines.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "lepp/terrain/simplify.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/random.hpp"
#include "terrain/grids.hpp"
#include "terrain/hills.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

constexpr std::uint32_t size = 12;

LineGraph graph_of(const std::vector<std::vector<Point>>& lines) {
  LineGraph graph;
  graph.pslg = polygon({0, 0, size - 1, 0, size - 1, size - 1, 0, size - 1});
  graph.pslg.entities = {};
  graph.pslg.entities.curves.resize(1 + lines.size());
  for (Segment& s : graph.pslg.segments) s.curve = CurveId(0U);
  graph.heights.resize(graph.pslg.segments.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < lines[i].size(); ++k) {
      graph.pslg.points.push_back(lines[i][k]);
      const VertexId v(graph.pslg.points.size() - 1);
      if (k > 0) add_piece(graph, VertexId(v.index() - 1), v, CurveId(i + 1), {1, 2}, 0, 1);
    }
  }
  return graph;
}

// Of a point that is no end of a segment from it, or of two points.
double least_distance(const Pslg& pslg) {
  double least = 1;
  for (const Segment& s : pslg.segments) {
    const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
    for (const Point p : pslg.points) {
      if (p == a || p == b) continue;
      const double part = std::clamp(dot(p - a, b - a) / squared_distance(a, b), 0.0, 1.0);
      least = std::min(least, std::sqrt(squared_distance(a + part * (b - a), p)));
    }
  }
  return least;
}

bool has_point(const Pslg& pslg, Point p) { return std::ranges::count(pslg.points, p) == 1; }

}  // namespace

TEST_CASE("a line near a sample, the outline or the end of another line goes there") {
  const HeightGrid grid = hills(size, size);
  LineGraph graph = graph_of({{{2.004, 3.995}, {5.5, 3.3}},       // a sample
                              {{0.006, 7.3}, {4.4, 7.7}},         // the outline
                              {{5.497, 3.305}, {9.4, 10.996}}});  // both
  CHECK(snap_lines(grid, graph) == 4);
  for (const Point p : {Point{2, 4}, {5.5, 3.3}, {0, 7.3}, {9.4, 11}}) {
    CAPTURE(p.x);
    CHECK(has_point(graph.pslg, p));
  }
  CHECK(graph.pslg.points.size() == 4 + 5);
}

TEST_CASE("a line that passes a sample or a point closely goes through it, with heights between") {
  const HeightGrid grid = hills(size, size);
  LineGraph graph = graph_of({{{1.2, 2.999}, {9.2, 3.009}}, {{4.5, 3.007}, {4.5, 9.5}}});
  CHECK(snap_lines(grid, graph) > 0);
  CHECK(has_point(graph.pslg, {3, 3}));
  CHECK(has_point(graph.pslg, {4.5, 3.007}));
  for (std::size_t i = 0; i < graph.pslg.segments.size(); ++i) {
    const Segment& s = graph.pslg.segments[i];
    const Point a = graph.pslg.points[s.a.index()];
    if (s.curve == CurveId(1U)) {
      CHECK(graph.heights[i].a == doctest::Approx(1 + (a.x - 1.2) / 8).epsilon(1e-3));
    }
  }
}

TEST_CASE("lines far enough from all else stay, also beside a sample without data") {
  HeightGrid grid = hills(size, size);
  grid.heights.set(grid.index(3, grid.row_of_line(3)), std::numeric_limits<double>::quiet_NaN());
  LineGraph graph = graph_of({{{2.5, 3.005}, {3.5, 3.005}}, {{2.5, 3.1}, {4.5, 3.1}}});
  CHECK(snap_lines(grid, graph) == 0);
  CHECK(graph.pslg.points.size() == 4 + 4);
  CHECK(has_point(graph.pslg, {2.5, 3.005}));
}

TEST_CASE("lines that run together and part again leave nothing between that is finer") {
  const HeightGrid grid = hills(size, size);
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<std::vector<Point>> lines;
    for (int pair = 0; pair < 2; ++pair) {
      auto& line = lines.emplace_back();
      for (int k = 0; k < 4; ++k) {
        line.push_back({random.real(0, size - 1), random.real(0, size - 1)});
      }
      const double apart = std::pow(10, random.real(-4, -2));
      std::vector<Point> beside = line;
      for (Point& p : beside) p = p + apart * Point{random.real(-1, 1), random.real(-1, 1)};
      lines.push_back(beside);
    }
    LineGraph graph = graph_of(lines);
    snap_lines(grid, graph);
    CHECK(least_distance(graph.pslg) > 0.5 * meeting_distance);
  }
}

TEST_CASE("simplify with hard lines that nearly meet: angles are good but for those of the input") {
  const HeightGrid grid = hills(30, 25);
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 2178U, 10245U}) {
    CAPTURE(seed);
    Random random(seed);
    DomainOptions lines;
    for (int i = 0; i < 3; ++i) {
      Breakline line;
      for (int k = 0; k < 3; ++k) {
        line.points.push_back({random.real(1, 28), -random.real(1, 23)});
        line.heights.push_back(hill(line.points.back().x, -line.points.back().y));
      }
      lines.breaklines.push_back(line);
      const double apart = std::pow(10, random.real(-4, -2));
      for (Point& p : line.points) p = p + apart * Point{random.real(-1, 1), random.real(-1, 1)};
      lines.breaklines.push_back(line);
    }
    SimplifyReport report;
    const TerrainDomain domain = terrain_domain(grid, lines);
    const Tin tin = simplify(grid, domain, {.max_error = 10}, report);
    MeshClaims claims;
    claims.min_angle_deg = 30;
    claims.unfinished = report.unfinished;
    CHECK(validate(tin.mesh, claims).summary() == "valid");
    CHECK(std::ranges::all_of(report.unfinished,
                              [](const Unfinished& u) { return is_forced_by_input(u.reason); }));
    CHECK(tin.mesh.vertex_count() < 5000);
    CHECK_FALSE(domain.warnings.empty());
  }
}

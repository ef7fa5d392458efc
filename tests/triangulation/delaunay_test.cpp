// The kernel on bare points: whole, and in halves that are merged.

#include "lepp/triangulation/delaunay.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/merge_halves.hpp"
#include "lepp/triangulation/spatial_order.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/gen_pslg.hpp"
#include "support/random.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

std::vector<Point> in_order(const std::vector<Point>& points) {
  std::vector<Point> ordered;
  for (const std::uint32_t i : spatial_order(points)) {
    if (ordered.empty() || ordered.back() != points[i]) ordered.push_back(points[i]);
  }
  return ordered;
}

// Nothing if all points lie on one line.
std::optional<RawTriangulation> triangulated(std::vector<Point> points, std::size_t halve_from,
                                             unsigned threads = 1) {
  RawTriangulation raw;
  raw.points = std::move(points);
  if (raw.points.size() < 3) return std::nullopt;
  if (!triangulate_points(raw, {threads, halve_from})) return std::nullopt;
  return raw;
}

// Counted, without labels, linked, turning left, and locally Delaunay with the hull convex: then it
// is Delaunay.
std::size_t faults(const RawTriangulation& raw) {
  std::size_t found = raw.triangles.size() == 2 * (raw.points.size() - 1) ? 0 : 1;
  for (std::uint32_t t = 0; t < raw.triangles.size(); ++t) {
    const auto& v = raw.triangles[t].vertices;
    if (raw.label(t) != 0) ++found;
    if (!raw.is_ghost(t) && orient2d(raw.point(v[0]), raw.point(v[1]), raw.point(v[2])) <= 0)
      ++found;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto e = RawTriangulation::code(t, i), f = raw.twin(e);
      if (raw.twin(f) != e || raw.origin(e) != raw.destination(f)) ++found;
      const std::uint32_t u = RawTriangulation::triangle_of(f);
      const VertexId beyond = raw.apex(f);
      if (raw.is_ghost(t)) {  // the hull turns right or goes straight on from ghost to ghost
        if (i != 0) continue;
        const VertexId next = raw.triangles[u].vertices[1];
        if (orient2d(raw.point(v[0]), raw.point(v[1]), raw.point(next)) > 0) ++found;
      } else if (!raw.is_ghost(u) && incircle(raw.point(v[0]), raw.point(v[1]), raw.point(v[2]),
                                              raw.point(beyond)) > 0) {
        ++found;
      }
    }
  }
  return found;
}

using Corners = std::array<std::uint32_t, 3>;
std::set<Corners> triangles_of(const RawTriangulation& raw) {
  std::set<Corners> all;
  for (const Triangle& t : raw.triangles) {
    Corners corners{t.vertices[0].value, t.vertices[1].value, t.vertices[2].value};
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    all.insert(corners);
  }
  return all;
}

bool has_area(std::span<const Point> points) {
  for (std::size_t i = 2; i < points.size(); ++i) {
    if (orient2d(points[0], points[1], points[i]) != 0) return true;
  }
  return false;
}

// True if points in order are triangulated as two halves and merged.
bool are_merged(std::span<const Point> points) {
  if (points.size() < 8) return false;
  const auto halves = find_halves(points);
  return halves && has_area(points.first(halves->first_of_second)) &&
         has_area(points.subspan(halves->first_of_second));
}

bool are_equal(const RawTriangulation& one, const RawTriangulation& two) {
  return std::ranges::equal(one.triangles, two.triangles, {}, &Triangle::vertices,
                            &Triangle::vertices);
}

std::vector<Point> random_points(std::uint64_t seed, std::size_t count, double width) {
  Random random(seed);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({random.real(0, width), random.real()});
  return points;
}

}  // namespace

TEST_CASE("merged halves are the Delaunay triangulation of all points, for every kind of input") {
  std::size_t merged = 0;
  for (std::size_t family = 0; family < family_names.size(); ++family) {
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      const Pslg pslg = generate_pslg(static_cast<Family>(family), seed);
      const auto points = in_order(pslg.points);
      const auto raw = triangulated(points, 8);
      if (!raw) continue;
      CAPTURE(family_names[family]);
      CAPTURE(seed);
      CHECK(faults(*raw) == 0);
      if (!are_merged(points)) continue;
      ++merged;
      if (seed % 20 == 0) CHECK(are_equal(*raw, *triangulated(points, 8, 2)));
    }
  }
  CHECK(merged > 2000);  // of 4800: most inputs have a line through the middle
}

TEST_CASE("grids, circles and columns merge: many cocircular and collinear points") {
  std::vector<std::vector<Point>> inputs(3);
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) inputs[0].push_back({1.0 * i, 1.0 * j});
    inputs[1].push_back({std::cos(0.157 * i), std::sin(0.157 * i)});
    for (const double x : {0.0, 1.0, 100.0, 101.0}) inputs[2].push_back({x, 1.0 * i});
  }
  for (const double scale : {1.0, 1e-3, 0.1, 0x1p60, 1e9}) {  // exactly, or nearly, on a circle
    auto& circle = inputs.emplace_back();
    for (const double x : {-5.0, -4.0, -3.0, 0.0, 3.0, 4.0, 5.0}) {
      const double y = std::sqrt(25 - x * x);
      circle.push_back({scale * x, scale * y});
      if (y > 0) circle.push_back({scale * x, scale * -y});
    }
    REQUIRE(circle.size() == 12);
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    CAPTURE(i);
    const auto points = in_order(inputs[i]);
    REQUIRE(are_merged(points));
    const auto raw = triangulated(points, 8);
    REQUIRE(raw);
    CHECK(faults(*raw) == 0);
  }
}

TEST_CASE("where a half lies on one line, all points are inserted together") {
  std::vector<std::vector<Point>> inputs(2);
  for (int i = 0; i < 40; ++i) {
    inputs[0].push_back({i % 2 == 0 ? 0.0 : 100.0, 1.0 * i});
    inputs[1].push_back({1.0 * i, i == 20 ? 1.0 : 0.0});
  }
  for (const auto& input : inputs) {
    const auto points = in_order(input);
    CHECK(!are_merged(points));
    const auto raw = triangulated(points, 8);
    REQUIRE(raw);
    CHECK(faults(*raw) == 0);
  }
}

TEST_CASE("in general position the merged halves and the whole have the same triangles") {
  for (const double width : {1.0, 40.0, 0.01}) {
    const auto points = in_order(random_points(3, 3000, width));
    REQUIRE(find_halves(points));
    const auto halves = triangulated(points, 8), whole = triangulated(points, points.size() + 1);
    CHECK(triangles_of(*halves) == triangles_of(*whole));
  }
}

TEST_CASE("halves are cut near the middle where a line separates them, or not at all") {
  for (const double width : {0.3, 0.55, 0.7, 1.0, 1.4, 1.8}) {
    CAPTURE(width);
    const auto points = in_order(random_points(4, 20000, width));
    const auto halves = find_halves(points);
    REQUIRE(halves);
    CHECK(halves->first_of_second > 9500);
    CHECK(halves->first_of_second < 10500);
  }
  std::vector<Point> mixed;  // large and small x in turn, y as well: no line anywhere
  for (int i = 0; i < 5000; ++i) mixed.push_back({i % 2 * 1e4 + i, (i / 2) % 2 * 1e4 + i});
  CHECK(!find_halves(mixed));
}

TEST_CASE("the mesh does not depend on the number of threads") {
  Pslg pslg = generate_pslg(Family::nested_rings, 5, 200);
  const auto around = random_points(6, 30000, 1);  // the rings have radius 10
  for (const Point p : around) pslg.points.push_back({20 * p.x - 10, 20 * p.y - 10});
  REQUIRE(are_merged(in_order(pslg.points)));
  const Mesh one = constrained_delaunay(pslg, {Crossings::split, 1}).mesh;
  const Mesh two = constrained_delaunay(pslg, {Crossings::split, 2}).mesh;
  CHECK(validate(two).summary() == "valid");
  REQUIRE(one.triangle_count() == two.triangle_count());
  std::size_t different = 0;
  for (std::size_t t = 0; t < one.triangle_count(); ++t) {
    if (one.vertices(TriangleId(t)) != two.vertices(TriangleId(t))) ++different;
    if (one.region(TriangleId(t)) != two.region(TriangleId(t))) ++different;
  }
  CHECK(different == 0);
  CHECK(one.segments().size() == two.segments().size());
}

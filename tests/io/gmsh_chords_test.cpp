#include "lepp/io/gmsh_chords.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lepp;

namespace {

Polyline straight(Point a, Point b) { return {StraightCurve{}, {{a, 0}, {b, 1}}}; }

/// The upper half of the unit circle around `center`, in one piece, or one for each quarter.
Polyline half_circle(Point center, double radius, int pieces) {
  Polyline line{EllipseArc{center, {radius, 0}, {0, radius}, 0, std::numbers::pi}, {}};
  for (int i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    line.points.push_back({point_at(line.geometry, t), t});
  }
  return line;
}

}  // namespace

TEST_CASE("pieces that meet nothing stay as they are") {
  std::vector<Polyline> lines = {half_circle({0, 0}, 1, 4), straight({-1, -1}, {1, -1})};
  CHECK(separate_chords(lines, {}).empty());
  CHECK(lines[0].points.size() == 5);
}

TEST_CASE("a point or a line between a chord and its arc cuts the piece") {
  std::vector<Polyline> lines = {half_circle({0, 0}, 1, 2)};
  const std::vector<Point> inside = {{0.6, 0.6}};  // beyond the chord, within the circle
  CHECK(separate_chords(lines, inside).empty());
  CHECK(lines[0].points.size() > 3);

  lines = {half_circle({0, 0}, 1, 2), straight({0.6, 0.6}, {0.2, 0.2})};
  CHECK(separate_chords(lines, {}).empty());
  CHECK(lines[0].points.size() > 3);
}

TEST_CASE("an arc and its own chord become two chains") {
  Polyline arc = half_circle({0, 0}, 1, 1);
  std::vector<Polyline> lines = {arc, straight(arc.points[0].point, arc.points[1].point)};
  CHECK(separate_chords(lines, {}).empty());
  CHECK(lines[0].points.size() >= 3);
  CHECK(lines[1].points.size() == 2);
}

TEST_CASE("arcs that nearly touch are cut where they do, and only there") {
  std::vector<Polyline> lines = {half_circle({0, 0}, 1, 6), half_circle({0, 0.001}, 1, 6)};
  for (CurvePoint& p : lines[1].points) p.point = point_at(lines[1].geometry, p.t);
  CHECK(separate_chords(lines, {}).empty());
  CHECK(lines[0].points.size() > 7);
  CHECK(lines[0].points.size() < 300);
}

TEST_CASE("arcs that cross are reported, not cut for ever") {
  std::vector<Polyline> lines = {half_circle({0, 0}, 1, 3), half_circle({1.1, 0}, 1, 3)};
  const std::vector<ChordPlace> places = separate_chords(lines, {});
  REQUIRE_FALSE(places.empty());
  for (const auto& [polyline, piece] : places) {
    const Point p = lines[polyline].points[piece].point;
    CHECK(std::abs(p.x - 0.55) < 1e-2);
    CHECK(std::abs(p.y - std::sqrt(1 - 0.55 * 0.55)) < 1e-2);
  }
  CHECK(lines[0].points.size() < 30);
}

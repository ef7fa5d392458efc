#include "lepp/refine/left_alone.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"

using namespace lepp;

namespace {

// Edges of lengths 1, 0.8 and 0.5 leave the origin, at `sharp` and then `wide` degrees.
Mesh two_wedges(double sharp, double wide) {
  const auto at = [](double length, double deg) {
    const double angle = deg * std::numbers::pi / 180;
    return Point{length * std::cos(angle), length * std::sin(angle)};
  };
  Pslg pslg;
  pslg.points = {{0, 0}, at(1, 0), at(0.8, sharp), at(0.5, sharp + wide)};
  for (const auto& [a, b] : {std::pair{0U, 1U}, {0U, 2U}, {0U, 3U}, {1U, 2U}, {2U, 3U}}) {
    pslg.segments.push_back({VertexId(a), VertexId(b), {}, 0, 1});
  }
  return constrained_delaunay(pslg).mesh;
}

double shortest_edge(const Mesh& mesh) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    shortest = std::min(
        {shortest, squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  }
  return std::sqrt(shortest);
}

}  // namespace

TEST_CASE("two wedges at a vertex, one of them sharp, are meshed without an obtuse triangle") {
  for (const double sharp : {50.0, 30.0}) {
    for (const double wide : {60.0, 75.0, 90.0, 91.0, 96.0, 100.0, 120.0}) {
      CAPTURE(sharp);
      CAPTURE(wide);
      Mesh mesh = two_wedges(sharp, wide);
      CHECK(refine(mesh, {.max_angle_deg = 90}).goal_reached);
      CHECK(validate(mesh, {.max_angle_deg = 90}).summary() == "valid");
      CHECK(measure(mesh).obtuse_triangles.exact == 0);
    }
  }
}

TEST_CASE("where 30 and 90 degrees do not go together the wedge is not cut for ever") {
  for (const double sharp : {5.0, 2.0, 0.5}) {
    CAPTURE(sharp);
    Mesh mesh = two_wedges(sharp, 96);
    const RefineReport report = refine(mesh, {.max_angle_deg = 90});
    CHECK_FALSE(report.goal_reached);
    CHECK(shortest_edge(mesh) > 1e-7);  // the size floor is 1e-12
    MeshClaims claims;
    claims.min_angle_deg = 30;
    claims.max_angle_deg = 90;
    claims.nonobtuse = true;
    claims.unfinished = report.unfinished;
    CHECK(validate(mesh, claims).summary() == "valid");
  }
}

TEST_CASE(
    "a vertex whose edges shrink in an attempt, but not without, is left alone from then on") {
  const Mesh start = two_wedges(30, 90);
  Mesh cut = start;
  refine(cut, {.max_edge = 0.005});
  LeftAlone left_alone = LeftAlone::nowhere(start);
  CHECK_FALSE(left_alone.contains(start, TriangleId(0U)));
  CHECK_FALSE(left_alone.add_shrunken(start, start));
  CHECK(left_alone.add_shrunken(cut, start));
  CHECK(left_alone.contains(start, TriangleId(0U)));
  CHECK_FALSE(left_alone.add_shrunken(cut, start));
  CHECK(LeftAlone::everywhere(start).contains(start, TriangleId(0U)));
}

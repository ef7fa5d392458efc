#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/voronoi/admissible.hpp"

using namespace lepp;

namespace {

// Point sets that are hard on rounding; a corner and a size are added by the caller.
constexpr int hard_families = 5;
std::vector<Point> hard_points(int family, std::mt19937& random) {
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto eighth = [&] { return static_cast<double>(random() % 8); };
  std::vector<Point> points(5 + random() % 60);
  for (Point& p : points) {
    const double turn = 2 * std::numbers::pi * unit();
    if (family == 0) p = {unit(), unit()};                  // anywhere
    if (family == 1) p = {eighth(), eighth()};              // on a grid: many cocircular
    if (family == 2) p = {unit(), 1e-3 * unit()};           // flat triangles
    if (family == 3) p = {std::cos(turn), std::sin(turn)};  // on a circle, up to rounding
    if (family == 4) {                                      // clusters as narrow as rounding
      p = {0.1 * eighth() + 1e-15 * unit(), 0.1 * eighth() + 1e-15 * unit()};
    }
  }
  return points;
}

// Nothing if all points lie on one line.
std::optional<Mesh> delaunay_of(const std::vector<Point>& points, Point corner, double size) {
  Pslg pslg;
  for (const Point p : points) pslg.points.push_back(corner + size * p);
  try {
    return constrained_delaunay(pslg).mesh;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

TEST_CASE("the boxes of any Delaunay triangulation of a convex domain fill it") {
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const int family = static_cast<int>(seed % hard_families);
    const Point corner = seed % 3 == 0 ? Point{5e5, 4e6} : Point{0, 0};
    const auto mesh = delaunay_of(hard_points(family, random), corner, seed % 7 == 0 ? 1e-3 : 1);
    if (!mesh) continue;
    const VoronoiBoxes boxes = voronoi_boxes(*mesh);
    const Certificate certificate = certify(*mesh, boxes);
    CHECK(certificate.largest_area_defect < 1e-12);
    for (const BoxViolation& violation : certificate.violations) {
      CHECK_MESSAGE(violation.rule == "V1", violation.where);  // obtuse angles at the hull
    }
    CHECK(std::ranges::all_of(boxes.boxes, [](const VoronoiBox& box) { return box.area > 0; }));
  }
}

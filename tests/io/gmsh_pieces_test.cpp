#include "lepp/io/gmsh_pieces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lepp;

namespace {

/// Largest distance of the curve from its chords.
double worst_sagitta(const Curve& curve, std::vector<double> cuts) {
  cuts.insert(cuts.begin(), 0);
  cuts.push_back(1);
  double worst = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Point a = point_at(curve, cuts[i]), chord = point_at(curve, cuts[i + 1]) - a;
    for (int k = 1; k < 50; ++k) {
      const Point p = point_at(curve, cuts[i] + (cuts[i + 1] - cuts[i]) * k / 50) - a;
      worst = std::max(worst, std::abs(cross(chord, p)) / std::sqrt(dot(chord, chord)));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("a circle is cut into equal pieces, at most 30 degrees each") {
  const Curve circle = EllipseArc{{0, 0}, {1, 0}, {0, 1}, 0, 2 * std::numbers::pi};
  const std::vector<double> coarse = fewest_pieces(circle, 1);
  REQUIRE(coarse.size() == 11);
  CHECK(coarse[2] == 0.25);
  // sagitta 1 - cos(a / 2) <= 1e-3 * 2
  const double widest = 2 * std::acos(1 - 2e-3);
  CHECK(fewest_pieces(circle, 1e-3).size() ==
        static_cast<std::size_t>(std::ceil(2 * std::numbers::pi / widest)) - 1);
}

TEST_CASE("other curves keep the chord tolerance, and one piece less would not") {
  const Curve ellipse = EllipseArc{{0, 0}, {4, 0}, {0, 1}, 0, 3};
  const std::vector<double> cuts = fewest_pieces(ellipse, 1e-3);
  const double allowed = 1e-3 * 8 * 0.9975;  // its bounding box is 7.98 wide
  CHECK(worst_sagitta(ellipse, cuts) <= allowed);
  CHECK(worst_sagitta(ellipse, cuts) > 0.5 * allowed);
  CHECK(std::is_sorted(cuts.begin(), cuts.end()));
}

TEST_CASE("a corner inside a curve is a cut") {
  const Curve corner = CubicPieces{
      {0, 0.5, 1},
      {{Point{0, 0}, {1, 0.1}, {2, 0.1}, {3, 0}}, {Point{3, 0}, {3.1, 1}, {3.1, 2}, {3, 3}}}};
  const std::vector<double> cuts = fewest_pieces(corner, 1e-2);
  CHECK(std::find(cuts.begin(), cuts.end(), 0.5) != cuts.end());
}

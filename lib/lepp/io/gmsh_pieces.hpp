#pragma once

#include <vector>

#include "lepp/geometry/curve.hpp"

namespace lepp {

/// A curve as a chain of straight chords: points in order of their parameters, from t = 0 to 1.
struct Polyline {
  Curve geometry;
  std::vector<CurvePoint> points;
};

/// No chord of a curve turns by more than this.
inline constexpr double most_turn_deg = 30;

/// Inner parameters that cut a curve into the fewest pieces of sagitta <= chord_tolerance * (larger
/// side of the curve's bounding box) and turn <= 30 degrees. All pieces of a circle are equal;
/// other curves are cut so that the worst piece is as good as that number of pieces allows.
/// A corner inside the curve is always a cut.
/// \pre  !is_straight(curve), chord_tolerance > 0
std::vector<double> fewest_pieces(const Curve& curve, double chord_tolerance);

}  // namespace lepp

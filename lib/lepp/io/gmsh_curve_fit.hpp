#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lepp/geometry/curve.hpp"

namespace lepp {

/// Points of a curve at given parameters in [0, 1]: all that is known of a curve inside Gmsh.
using CurveSampler = std::function<std::vector<Point>(std::span<const double>)>;

/// A cubic piece may leave the curve by this share of the curve's size.
inline constexpr double cubic_tolerance = 1e-9;

/// What a sampled curve is: a straight line; else a circle or ellipse run through at constant
/// angular speed; else a chain of cubic pieces within `cubic_tolerance`, with the same parameter.
/// Splines and B-splines of Gmsh come back as their own polynomials, to rounding.
/// Cost  O(pieces) samples for splines with equally spaced knots
Curve fit_curve(const CurveSampler& sample);

/// Number of pieces a curve may need before fit_curve() gives up and keeps what it has.
inline constexpr std::size_t most_cubic_pieces = 100'000;

}  // namespace lepp

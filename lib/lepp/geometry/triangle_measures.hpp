#pragma once

#include <array>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// Signed area, positive when counter-clockwise. Differences first: safe far from the origin.
double signed_area(Point a, Point b, Point c);

/// The three inner angles in degrees, at a, b and c.
std::array<double, 3> angles_deg(Point a, Point b, Point c);

/// Centre of the circle through the three points.
/// \pre  not collinear.  Error a few ulp of the circumradius for angles above a degree
Point circumcenter(Point a, Point b, Point c);

/// cos^2 of the smallest angle, signed like its cosine (which is positive): grows as the angle
/// shrinks, so it orders triangles from good to bad without acos or sqrt.
double squared_cos_of_smallest_angle(Point a, Point b, Point c);

/// cot of the angle at `apex` between a and b.
double cotangent(Point a, Point apex, Point b);

/// True if the angle at `apex` between the rays to a and b is below 60 degrees.
bool is_below_60_deg(Point a, Point apex, Point b);
/// True if the angle at `apex` between the rays to a and b is below 45 degrees.
bool is_below_45_deg(Point a, Point apex, Point b);

}  // namespace lepp

#pragma once

#include "lepp/geometry/point.hpp"

namespace lepp {

/// Exact signs. Each is -1, 0 or +1, decided by a floating-point filter and, where the filter
/// cannot tell, by expansion arithmetic. \pre coordinates in the supported range of pslg.hpp.
/// Source [shewchuk1997] for expansions and the shape of the error bounds.

/// +1 if a, b, c turn left (counter-clockwise), -1 if right, 0 if collinear.
int orient2d(Point a, Point b, Point c);

/// +1 if d lies strictly inside the circle through the counter-clockwise a, b, c; 0 on it.
int incircle(Point a, Point b, Point c, Point d);

/// Sign of (a - apex) . (b - apex): -1 if the angle at apex is obtuse, 0 if right, +1 if acute.
int dot_sign(Point a, Point apex, Point b);

/// True if the angle a-apex-b is above 90 degrees, that is, apex lies strictly inside the
/// diametral circle of ab.
inline bool is_obtuse(Point a, Point apex, Point b) { return dot_sign(a, apex, b) < 0; }

/// True if the predicates still give the right sign on a handful of hard cases. False means this
/// build breaks floating-point arithmetic (-ffast-math, fused or extended operations).
/// Costs microseconds; the program asks it at start-up.
bool predicates_self_test();

}  // namespace lepp

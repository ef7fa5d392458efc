#pragma once

#include "lepp/geometry/point.hpp"

namespace lepp {

/// The pixel of a point is what rounds to it: in x and in y everything nearer to its coordinate
/// than to the doubles next to it, and a tie where its last bit is 0. Pixels tile the plane; they
/// are the hot pixels of [hobby1999], on the grid of doubles.

/// True if segment ab meets the pixel of p, decided exactly.
/// \pre  a, b and p in the supported range of pslg.hpp
bool meets_pixel(Point a, Point b, Point p);

/// At least twice as far as the pixel of p reaches from p in x and in y.
Point reach(Point p);

}  // namespace lepp

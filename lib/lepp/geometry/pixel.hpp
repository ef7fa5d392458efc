#pragma once

#include "lepp/geometry/point.hpp"

namespace lepp {

/// The pixel of a point is what rounds to it: in x and in y everything nearer to its coordinate
/// than to the doubles next to it, and a tie where its last bit is 0. Pixels tile the plane; they
/// are the hot pixels of [hobby1999], on the grid of doubles.

/// True if segment ab meets the pixel of p, decided exactly. With `growth` > 1 the pixel is so
/// many times as large about p, and the answer is exact but for rounding.
/// \pre  a, b and p in the supported range of pslg.hpp
bool meets_pixel(Point a, Point b, Point p, double growth = 1);

/// At least as far as the pixel of p, so many times as large, reaches from p in x and in y.
Point reach(Point p, double growth);

}  // namespace lepp

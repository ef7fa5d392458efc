#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "lepp/geometry/pslg.hpp"

namespace lepp::test {

/// A kind of input that can be made in any size; the same for the same numbers.
struct Family {
  const char* name;
  /// About `points` points. \pre  points >= 64
  Pslg (*make)(std::size_t points, std::uint64_t seed);
};

///  square      random points in a unit square
///  coast       a closed curve grown by bumps on edges, fractal and without self-crossing
///  holes       a unit square with 16-gon holes of different sizes
///  interfaces  a unit square with segments of very different lengths that cross nowhere
///  grid        points of a square grid: every four cocircular, rows collinear
///  circle      a closed polygon on a circle: all points nearly cocircular
///  comb        a closed polygon with long thin teeth
///  spiral      a closed band that winds around the origin
std::span<const Family> families();

}  // namespace lepp::test

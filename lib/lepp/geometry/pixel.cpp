#include "lepp/geometry/pixel.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lepp/geometry/expansion.hpp"
#include "lepp/geometry/pslg.hpp"

namespace lepp {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Half the way from c to the next supported number up or down: between 0 and the least of them
// there is nothing.
double half_step(double c, double towards) {
  const bool to_zero = std::abs(c) == min_coordinate && (c > 0) == (towards < 0);
  if (c == 0 || to_zero) return 0.5 * min_coordinate;
  return 0.5 * std::abs(std::nextafter(c, towards) - c);
}

bool holds_ties(double c) { return std::bit_cast<std::uint64_t>(c) % 2 == 0; }

bool is_between(double c, double a, double b) { return std::min(a, b) <= c && c <= std::max(a, b); }

// On which side of the line from a to b the place p + (x, y) lies, with x and y powers of two.
int side_of_corner(Point a, Point b, Point p, double x, double y) {
  const auto dx = difference(b.x, a.x), dy = difference(b.y, a.y);
  const auto area = dx * difference(p.y, a.y) - dy * difference(p.x, a.x);
  return (area + (scale(dx, y) - scale(dy, x))).sign();
}

}  // namespace

Point reach(Point p) {
  const auto half = [](double c) {
    return std::max(half_step(c, infinity), half_step(c, -infinity));
  };
  return {2 * half(p.x), 2 * half(p.y)};
}

bool meets_pixel(Point a, Point b, Point p) {
  // No double lies between p and the border of its pixel, so boxes can be compared through p.
  if (!is_between(p.x, a.x, b.x) || !is_between(p.y, a.y, b.y)) return false;
  const double left = half_step(p.x, -infinity), right = half_step(p.x, infinity);
  const double down = half_step(p.y, -infinity), up = half_step(p.y, infinity);
  const int sides[] = {side_of_corner(a, b, p, -left, -down), side_of_corner(a, b, p, right, -down),
                       side_of_corner(a, b, p, right, up), side_of_corner(a, b, p, -left, up)};
  const auto [low, high] = std::ranges::minmax(sides);
  if (low < 0 && high > 0) return true;
  const auto on_line = std::ranges::count(sides, 0);
  if (on_line == 0) return false;
  if (on_line == 1) return holds_ties(p.x) && holds_ties(p.y);
  return a.x == b.x ? holds_ties(p.x) : holds_ties(p.y);  // along one side of the pixel
}

}  // namespace lepp

#include "lepp/io/gmsh_curve_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace lepp {
namespace {

double length(Point p) { return std::hypot(p.x, p.y); }

/// Equally spaced samples and how far rounding alone may move them.
struct Samples {
  static constexpr std::size_t intervals = 48;  // halves, thirds and quarters are among them
  std::vector<double> t;
  std::vector<Point> points;
  double size = 0;      // larger side of the bounding box
  double rounding = 0;  // of coordinates and of the arithmetic that made the points
};

Samples take_samples(const CurveSampler& sample) {
  Samples s;
  for (std::size_t i = 0; i <= Samples::intervals; ++i)
    s.t.push_back(static_cast<double>(i) / static_cast<double>(Samples::intervals));
  s.points = sample(s.t);
  Point low = s.points[0], high = s.points[0];
  double largest = 0;
  for (const Point p : s.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  s.size = std::max(high.x - low.x, high.y - low.y);
  s.rounding = std::max(1e-12 * s.size, 16 * 0x1p-53 * largest);
  return s;
}

/// All samples on the chord, running forward along it.
bool runs_straight(const Samples& s) {
  const Point a = s.points.front(), chord = s.points.back() - a;
  const double chord_length = length(chord);
  if (chord_length <= s.rounding) return false;
  double passed = 0;
  for (const Point p : s.points) {
    if (std::abs(cross(chord, p - a)) > s.rounding * chord_length) return false;
    const double along = dot(chord, p - a) / chord_length;
    if (along < passed - s.rounding) return false;
    passed = along;
  }
  return true;
}

std::optional<Point> circumcentre(Point a, Point b, Point c) {
  const Point u = b - a, v = c - a;
  const double twice = 2 * cross(u, v);
  if (twice == 0) return std::nullopt;
  const double uu = dot(u, u), vv = dot(v, v);
  return a + 1 / twice * Point{v.y * uu - u.y * vv, u.x * vv - v.x * uu};
}

bool passes_through(const Curve& curve, const Samples& s) {
  for (std::size_t i = 0; i < s.t.size(); ++i)
    if (length(point_at(curve, s.t[i]) - s.points[i]) > s.rounding) return false;
  return true;
}

std::optional<Curve> as_circle(const Samples& s) {
  const std::size_t n = Samples::intervals;
  const bool closed = length(s.points.back() - s.points.front()) <= s.rounding;
  const auto center = closed ? circumcentre(s.points[0], s.points[n / 3], s.points[2 * n / 3])
                             : circumcentre(s.points[0], s.points[n / 2], s.points[n]);
  if (!center) return std::nullopt;
  double sweep = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point p = s.points[i] - *center, q = s.points[i + 1] - *center;
    sweep += std::atan2(cross(p, q), dot(p, q));
  }
  if (closed) sweep = std::copysign(2 * std::numbers::pi, sweep);
  const Point u = s.points[0] - *center;
  const Curve circle = EllipseArc{*center, u, {-u.y, u.x}, 0, sweep};
  return passes_through(circle, s) ? std::optional(circle) : std::nullopt;
}

/// P(t) = c + cos(wt) u + sin(wt) v has P(t+h) + P(t-h) - 2 P(t) = k (P(t) - c), k = 2 cos(wh) - 2.
/// Two such second differences give k, then c, then u and v.
std::optional<Curve> as_ellipse(const Samples& s) {
  constexpr std::size_t third = Samples::intervals / 3;
  const Point p0 = s.points[0], p1 = s.points[third], p2 = s.points[2 * third],
              p3 = s.points[3 * third];
  const Point d1 = p0 + p2 - 2 * p1, d2 = p1 + p3 - 2 * p2, step = p1 - p2;
  const double k = dot(d1 - d2, step) / dot(step, step);
  if (!(k < 0 && k > -4)) return std::nullopt;
  const double sweep = 3 * std::acos(1 + k / 2);
  const Point center = 0.5 * (p1 + p2 - 1 / k * (d1 + d2));
  const Point u = p0 - center;
  const double angle = sweep / 4;
  const Point quarter = s.points[Samples::intervals / 4];
  const Point v = 1 / std::sin(angle) * (quarter - center - std::cos(angle) * u);
  const Curve ellipse = EllipseArc{center, u, v, 0, sweep};
  return passes_through(ellipse, s) ? std::optional(ellipse) : std::nullopt;
}

/// The cubic through the curve at a, a + h/3, a + 2h/3, a + h, if it stays close in between.
struct CubicFit {
  std::array<Point, 4> control;
  double deviation = 0;
};

CubicFit fit_cubic(const CurveSampler& sample, double a, double b) {
  const auto at = [&](double s) { return a + s * (b - a); };
  const std::array<double, 8> t = {a,           at(1. / 3),  at(2. / 3),  b,
                                   at(1. / 12), at(5. / 12), at(7. / 12), at(11. / 12)};
  const std::vector<Point> p = sample(t);
  CubicFit fit;
  fit.control = {p[0], 1. / 6 * (-5 * p[0] + 18 * p[1] - 9 * p[2] + 2 * p[3]),
                 1. / 6 * (2 * p[0] - 9 * p[1] + 18 * p[2] - 5 * p[3]), p[3]};
  const Curve cubic = CubicPieces{{0, 1}, {fit.control}};
  constexpr std::array<double, 4> between = {1. / 12, 5. / 12, 7. / 12, 11. / 12};
  for (std::size_t i = 0; i < 4; ++i)
    fit.deviation = std::max(fit.deviation, length(point_at(cubic, between[i]) - p[4 + i]));
  return fit;
}

/// n pieces of equal width, if each of them fits: then n is most likely the curve's own number.
std::optional<CubicPieces> equal_pieces(const CurveSampler& sample, std::size_t n, double bound) {
  CubicPieces cubics{{0}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const double b = static_cast<double>(i + 1) / static_cast<double>(n);
    const CubicFit fit = fit_cubic(sample, cubics.knots.back(), b);
    if (!(fit.deviation <= bound)) return std::nullopt;
    cubics.pieces.push_back(fit.control);
    cubics.knots.push_back(b);
  }
  return cubics;
}

/// Pieces halved until they fit; ends because a piece is never narrower than 2^-40.
CubicPieces halved_pieces(const CurveSampler& sample, double bound) {
  CubicPieces cubics{{0}, {}};
  std::vector<double> ends = {1, 0.75, 0.5, 0.25};  // what lies ahead, the nearest last
  while (!ends.empty()) {
    const double a = cubics.knots.back(), b = ends.back();
    const CubicFit fit = fit_cubic(sample, a, b);
    const bool splits = cubics.pieces.size() + ends.size() < most_cubic_pieces && b - a > 0x1p-40;
    if (splits && !(fit.deviation <= bound)) {
      ends.push_back(0.5 * (a + b));
      continue;
    }
    cubics.pieces.push_back(fit.control);
    cubics.knots.push_back(b);
    ends.pop_back();
  }
  return cubics;
}

}  // namespace

Curve fit_curve(const CurveSampler& sample) {
  const Samples s = take_samples(sample);
  if (s.size == 0 || runs_straight(s)) return StraightCurve{};
  if (const auto circle = as_circle(s)) return *circle;
  if (const auto ellipse = as_ellipse(s)) return *ellipse;
  // A curve's own pieces fit to rounding; only where there are none do we settle for a tolerance.
  constexpr std::size_t most_equal = 512;
  for (std::size_t n = 1; n <= most_equal; ++n)
    if (auto cubics = equal_pieces(sample, n, s.rounding)) return *cubics;
  // The fit is judged at a few points: half of what is promised leaves room between them.
  return halved_pieces(sample, 0.5 * cubic_tolerance * s.size);
}

}  // namespace lepp

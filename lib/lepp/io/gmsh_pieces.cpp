#include "lepp/io/gmsh_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lepp {
namespace {

constexpr double most_turn = most_turn_deg * std::numbers::pi / 180;
constexpr double corner = 1e-3;  // radians between two polynomial pieces: a cut, not a bend

double length(Point p) { return std::hypot(p.x, p.y); }
double angle_between(Point p, Point q) { return std::atan2(std::abs(cross(p, q)), dot(p, q)); }

/// The curve at closely spaced parameters, with the turn since its begin.
struct Table {
  std::vector<double> t, turn;
  std::vector<Point> points;
  std::vector<std::size_t> corners;  // indices where the direction jumps
  double size = 0;
};

/// Parameters of the polynomial pieces; an arc is one piece.
std::vector<double> knots_of(const Curve& curve) {
  if (const auto* cubics = std::get_if<CubicPieces>(&curve)) return cubics->knots;
  return {0, 1};
}

/// Direction just before (side -1) or after (side +1) a knot.
Point direction_near(const Curve& curve, double t, double width, double side) {
  return derivative_at(curve, t + side * 1e-9 * width);
}

Table tabulate(const Curve& curve, double chord_tolerance) {
  const std::vector<double> knots = knots_of(curve);
  // A step must be much finer than a piece of the wanted sagitta.
  const double wanted = std::clamp(64 / std::sqrt(chord_tolerance), 1024.0, 4e6);
  const auto per_piece = static_cast<std::size_t>(
      std::max(32.0, std::ceil(wanted / static_cast<double>(knots.size() - 1))));
  Table table;
  table.t = {knots[0]};
  table.turn = {0};
  Point before = direction_near(curve, knots[0], knots[1] - knots[0], 1);
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double width = knots[k + 1] - knots[k];
    const Point after = direction_near(curve, knots[k], width, 1);
    const double jump = angle_between(before, after);
    if (k > 0 && jump > corner) table.corners.push_back(table.t.size() - 1);
    else table.turn.back() += jump;
    before = after;
    for (std::size_t i = 1; i <= per_piece; ++i) {
      const bool last = i == per_piece;
      const double t =
          last ? knots[k + 1]
               : knots[k] + width * static_cast<double>(i) / static_cast<double>(per_piece);
      const Point direction = last ? direction_near(curve, t, width, -1) : derivative_at(curve, t);
      table.t.push_back(t);
      table.turn.push_back(table.turn.back() + angle_between(before, direction));
      before = direction;
    }
  }
  Point low = point_at(curve, 0), high = low;
  for (const double t : table.t) {
    const Point p = point_at(curve, t);
    table.points.push_back(p);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  table.size = std::max(high.x - low.x, high.y - low.y);
  return table;
}

/// Largest distance of the points between i and j from the chord ij.
double sagitta(const Table& table, std::size_t i, std::size_t j) {
  const Point a = table.points[i], chord = table.points[j] - a;
  const double chord_length = length(chord);
  double most = 0;
  for (std::size_t k = i + 1; k < j; ++k) {
    const Point p = table.points[k] - a;
    most = std::max(most, chord_length > 0 ? std::abs(cross(chord, p)) / chord_length : length(p));
  }
  return most;
}

struct Bounds {
  double sagitta = 0, turn = 0;
};

bool is_piece(const Table& table, std::size_t i, std::size_t j, const Bounds& bounds) {
  return table.turn[j] - table.turn[i] <= bounds.turn && sagitta(table, i, j) <= bounds.sagitta;
}

/// The furthest end of a piece that starts at i and ends at `limit` at the latest.
std::size_t furthest(const Table& table, std::size_t i, std::size_t limit, const Bounds& bounds) {
  std::size_t good = i + 1, step = 1;  // a single step of the table is always taken
  while (good + step <= limit && is_piece(table, i, good + step, bounds)) {
    good += step;
    step *= 2;
  }
  for (; step > 0; step /= 2)
    if (good + step <= limit && is_piece(table, i, good + step, bounds)) good += step;
  return good;
}

std::vector<std::size_t> greedy_cuts(const Table& table, const Bounds& bounds) {
  std::vector<std::size_t> cuts;
  std::size_t at = 0;
  auto next_corner = table.corners.begin();
  while (true) {
    while (next_corner != table.corners.end() && *next_corner <= at) ++next_corner;
    const std::size_t limit =
        next_corner != table.corners.end() ? *next_corner : table.t.size() - 1;
    at = furthest(table, at, limit, bounds);
    if (at + 1 >= table.t.size()) return cuts;
    cuts.push_back(at);
  }
}

bool is_circle(const EllipseArc& arc) {
  const double uu = dot(arc.u, arc.u), vv = dot(arc.v, arc.v);
  return std::abs(uu - vv) <= 1e-12 * uu && std::abs(dot(arc.u, arc.v)) <= 1e-12 * uu;
}

std::vector<double> equal_cuts(const EllipseArc& circle, double allowed_sagitta) {
  const double share = allowed_sagitta / length(circle.u);
  const double widest = share < 1 ? std::min(most_turn, 2 * std::acos(1 - share)) : most_turn;
  const auto n = static_cast<std::size_t>(std::ceil(std::abs(circle.sweep) / widest - 1e-9));
  std::vector<double> cuts;
  for (std::size_t i = 1; i < n; ++i)
    cuts.push_back(static_cast<double>(i) / static_cast<double>(n));
  return cuts;
}

}  // namespace

std::vector<double> fewest_pieces(const Curve& curve, double chord_tolerance) {
  const Table table = tabulate(curve, chord_tolerance);
  Bounds bounds{chord_tolerance * table.size, most_turn};
  if (const auto* arc = std::get_if<EllipseArc>(&curve); arc != nullptr && is_circle(*arc))
    return equal_cuts(*arc, bounds.sagitta);
  std::vector<std::size_t> cuts = greedy_cuts(table, bounds);
  // The same number of pieces under tighter bounds: the last piece is no longer what was left.
  double loose = 1, tight = 0;
  for (int round = 0; round < 12; ++round) {
    const double share = 0.5 * (loose + tight);
    auto candidate = greedy_cuts(table, {share * bounds.sagitta, share * bounds.turn});
    if (candidate.size() == cuts.size()) {
      cuts = std::move(candidate);
      loose = share;
    } else {
      tight = share;
    }
  }
  std::vector<double> result;
  for (const std::size_t cut : cuts) result.push_back(table.t[cut]);
  return result;
}

}  // namespace lepp

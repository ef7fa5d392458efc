#include "bench/families.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lepp::test {

namespace {

constexpr double pi = std::numbers::pi;

// The same numbers with every compiler and library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double from(double low, double high) { return low + (high - low) * unit(); }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  bool coin() { return (bits() >> 63) != 0; }

 private:
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

void add_segment(Pslg& pslg, std::size_t a, std::size_t b) {
  pslg.segments.push_back({VertexId(a), VertexId(b), std::nullopt, 0, 1});
}

void add_polygon(Pslg& pslg, const std::vector<Point>& corners) {
  const std::size_t first = pslg.points.size(), n = corners.size();
  pslg.points.insert(pslg.points.end(), corners.begin(), corners.end());
  for (std::size_t i = 0; i < n; ++i) add_segment(pslg, first + i, first + (i + 1) % n);
}

Pslg unit_square() {
  Pslg pslg;
  add_polygon(pslg, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  return pslg;
}

Point on_circle(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Pslg square(std::size_t points, std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = unit_square();
  while (pslg.points.size() < points) {
    const double x = random.unit(), y = random.unit();  // in this order, whatever the compiler
    pslg.points.push_back({x, y});
  }
  return pslg;
}

// Each edge a-b that is chosen becomes a, a third, a bump to either side, two thirds, b. Bumps of
// at most 50 degrees stay in rhombs over their edges that do not overlap.
Pslg coast(std::size_t points, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> curve;
  for (int i = 0; i < 24; ++i) curve.push_back(on_circle(1, 2 * pi * i / 24));
  while (curve.size() + 3 <= points) {
    std::size_t wanted = std::min((points - curve.size()) / 3, curve.size());
    std::vector<Point> grown;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      grown.push_back(curve[i]);
      const double share = static_cast<double>(wanted) / static_cast<double>(curve.size() - i);
      if (random.unit() >= share) continue;
      --wanted;
      const Point a = curve[i], d = curve[(i + 1) % curve.size()] - a;
      const double height = std::tan(random.from(pi / 12, pi * 5 / 18)) / 6;
      const double h = random.coin() ? height : -height;
      grown.push_back(a + (1.0 / 3) * d);
      grown.push_back(a + 0.5 * d + h * Point{-d.y, d.x});
      grown.push_back(a + (2.0 / 3) * d);
    }
    curve = std::move(grown);
  }
  Pslg pslg;
  add_polygon(pslg, curve);
  return pslg;
}

Pslg holes(std::size_t points, std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = unit_square();
  const std::size_t count = std::max<std::size_t>(points / 16, 1);
  const auto rows = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const double cell = 1 / static_cast<double>(rows);
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = cell * random.from(0.05, 0.4);
    const double room = 0.48 * cell - radius;
    const double x = cell * (static_cast<double>(i % rows) + 0.5) + random.from(-room, room);
    const double y = cell * (static_cast<double>(i / rows) + 0.5) + random.from(-room, room);
    const double turn = random.from(0, 2 * pi);
    std::vector<Point> rim;
    for (int k = 0; k < 16; ++k) rim.push_back(Point{x, y} + on_circle(radius, turn + pi * k / 8));
    add_polygon(pslg, rim);
    pslg.holes.push_back({x, y});
  }
  return pslg;
}

// The square is cut into boxes, the oldest first, at places that make them very different; each
// box then holds one segment.
Pslg interfaces(std::size_t points, std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = unit_square();
  struct Box {
    Point low, high;
  };
  std::vector<Box> boxes{{{0, 0}, {1, 1}}};
  std::size_t oldest = 0;
  while (boxes.size() - oldest < points / 2) {  // each turn leaves one box more
    const auto [low, high] = boxes[oldest++];
    const double s = random.from(0.2, 0.8);
    const bool upright = high.x - low.x > high.y - low.y;
    const Point cut{low.x + s * (high.x - low.x), low.y + s * (high.y - low.y)};
    boxes.push_back({low, upright ? Point{cut.x, high.y} : Point{high.x, cut.y}});
    boxes.push_back({upright ? Point{cut.x, low.y} : Point{low.x, cut.y}, high});
  }
  for (; oldest < boxes.size(); ++oldest) {
    const auto [low, high] = boxes[oldest];
    for (const double side : {0.05, 0.55}) {  // left end, right end
      const double s = random.from(side, side + 0.4), t = random.from(0.05, 0.95);
      pslg.points.push_back({low.x + s * (high.x - low.x), low.y + t * (high.y - low.y)});
    }
    add_segment(pslg, pslg.points.size() - 2, pslg.points.size() - 1);
  }
  return pslg;
}

Pslg grid(std::size_t points, std::uint64_t) {
  Pslg pslg;
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(points)));
  for (std::size_t i = 0; i < rows * rows; ++i) {
    pslg.points.push_back({static_cast<double>(i % rows), static_cast<double>(i / rows)});
  }
  return pslg;
}

Pslg circle(std::size_t points, std::uint64_t seed) {
  const double turn = Random(seed).from(0, 2 * pi), step = 2 * pi / static_cast<double>(points);
  std::vector<Point> rim;
  for (std::size_t i = 0; i < points; ++i) {
    rim.push_back(on_circle(1, turn + step * static_cast<double>(i)));
  }
  Pslg pslg;
  add_polygon(pslg, rim);
  return pslg;
}

Pslg comb(std::size_t points, std::uint64_t seed) {
  Random random(seed);
  const std::size_t teeth = points / 4;
  const double width = 1 / static_cast<double>(teeth);
  std::vector<Point> outline{{1, -0.1}, {0, -0.1}};  // the back; clockwise, as it happens
  for (std::size_t i = 0; i < teeth; ++i) {
    const double x = width * static_cast<double>(i), top = random.from(0.5, 1);
    for (const Point p : {Point{0.1, 0}, {0.2, top}, {0.6, top}, {0.7, 0}}) {
      outline.push_back({x + width * p.x, p.y});
    }
  }
  Pslg pslg;
  add_polygon(pslg, outline);
  return pslg;
}

Pslg spiral(std::size_t points, std::uint64_t seed) {
  const double turn = Random(seed).from(0, 2 * pi);
  const std::size_t half = points / 2;
  const double turns = std::max(2.0, std::round(0.5 * std::pow(static_cast<double>(half), 0.4)));
  const auto at = [&](std::size_t i, double offset) {
    const double s = static_cast<double>(i) / static_cast<double>(half - 1);
    return on_circle((1 + s * turns + offset) / (1 + turns), turn + 2 * pi * turns * s);
  };
  std::vector<Point> band;
  for (std::size_t i = 0; i < half; ++i) band.push_back(at(i, 0));
  for (std::size_t i = half; i-- > 0;) band.push_back(at(i, 0.4));
  Pslg pslg;
  add_polygon(pslg, band);
  return pslg;
}

constexpr Family all[] = {
    {"square", square}, {"coast", coast},   {"holes", holes}, {"interfaces", interfaces},
    {"grid", grid},     {"circle", circle}, {"comb", comb},   {"spiral", spiral}};

}  // namespace

std::span<const Family> families() { return all; }

}  // namespace lepp::test

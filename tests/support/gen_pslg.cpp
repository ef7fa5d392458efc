#include "support/gen_pslg.hpp"

#include <algorithm>
#include <cmath>

#include "support/oracle_arrangement.hpp"
#include "support/random.hpp"

namespace lepp::test {

namespace {

// A point of the unit circle, about `turn` of a full turn from (1, 0), without library functions
// that differ from machine to machine.
Point on_unit_circle(double turn) {
  const double quarters = 4 * turn;
  const int quarter = static_cast<int>(quarters);
  const double t = quarters - quarter;
  const double x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);
  switch (quarter % 4) {
    case 0:
      return {x, y};
    case 1:
      return {-y, x};
    case 2:
      return {-x, -y};
    default:
      return {y, -x};
  }
}

class Builder {
 public:
  explicit Builder(Random& random) : random_(random) { pslg_.source = "generated"; }

  Pslg take() { return std::move(pslg_); }
  std::size_t size() const { return pslg_.points.size(); }
  std::vector<Point>& points() { return pslg_.points; }

  std::uint32_t add(Point p) {
    pslg_.points.push_back(p);
    return static_cast<std::uint32_t>(pslg_.points.size() - 1);
  }

  void join(std::uint32_t a, std::uint32_t b) {
    const CurveId curve(pslg_.entities.curves.size());
    pslg_.entities.curves.push_back({static_cast<int>(curve.value) + 1, {}, StraightCurve{}, {}});
    pslg_.segments.push_back({VertexId(a), VertexId(b), curve, 0, 1});
  }

  void join_some(int attempts, bool may_cross) {
    for (int i = 0; i < attempts && size() > 1; ++i) {
      const auto n = static_cast<std::uint32_t>(size());
      const std::uint32_t a = random_.below(n), b = random_.below(n);
      if (a == b || (!may_cross && crosses_any(a, b))) continue;
      join(a, b);
    }
  }

  std::uint32_t ring(const std::vector<Point>& corners) {
    const auto first = static_cast<std::uint32_t>(size());
    const auto n = static_cast<std::uint32_t>(corners.size());
    for (const Point p : corners) add(p);
    for (std::uint32_t i = 0; i < n; ++i) join(first + i, first + (i + 1) % n);
    return first;
  }

  void hole(Point p) { pslg_.holes.push_back(p); }
  void region(Point p) {
    const SurfaceId surface(pslg_.entities.surfaces.size());
    SurfaceEntity entity;
    entity.tag = static_cast<int>(surface.value) + 1;
    entity.attribute = entity.tag;
    pslg_.entities.surfaces.push_back(entity);
    pslg_.seeds.push_back({p, surface});
  }

  // A square around everything.
  void frame() {
    Point low = pslg_.points[0], high = low;
    for (const Point p : pslg_.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double margin = random_.one_in(3) ? 0 : 0.25 * (high.x - low.x + high.y - low.y) + 1;
    low = low - Point{margin, margin};
    high = high + Point{margin, margin};
    ring({low, {high.x, low.y}, high, {low.x, high.y}});
    if (random_.one_in(3)) region({0.5 * (low.x + high.x), 0.4 * low.y + 0.6 * high.y});
    if (random_.one_in(8)) hole({0.7 * low.x + 0.3 * high.x, 0.5 * (low.y + high.y)});
  }

  template <class Change>
  void change_places(Change change) {
    for (Point& p : pslg_.points) p = change(p);
    for (Point& p : pslg_.holes) p = change(p);
    for (RegionSeed& s : pslg_.seeds) s.at = change(s.at);
  }

  void jitter(int ulps, std::uint32_t one_in) {
    for (Point& p : pslg_.points) {
      if (!random_.one_in(one_in)) continue;
      p.x = move_by_ulps(p.x, random_.between(-ulps, ulps));
      p.y = move_by_ulps(p.y, random_.between(-ulps, ulps));
    }
  }

 private:
  bool crosses_any(std::uint32_t a, std::uint32_t b) const {
    const auto at = [&](VertexId v) { return pslg_.points[v.index()]; };
    return std::any_of(pslg_.segments.begin(), pslg_.segments.end(), [&](const Segment& s) {
      return cross_inside(pslg_.points[a], pslg_.points[b], at(s.a), at(s.b));
    });
  }

  Random& random_;
  Pslg pslg_;
};

void uniform_points(Builder& b, Random& random, int n) {
  const double size = random.one_in(2) ? 1 : 1000;
  for (int i = 0; i < n; ++i) {
    const double x = random.real(-size, size);
    b.add({x, random.real(-size, size)});
  }
}

// n of the lattice points of a square, in any order, perhaps with repetitions.
void lattice_points(Builder& b, Random& random, int n) {
  int side = 2;
  while (side * side < n) ++side;
  std::vector<Point> all;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) all.push_back({double(i), double(j)});
  }
  for (std::size_t i = all.size(); i > 1; --i) {
    std::swap(all[i - 1], all[random.below(static_cast<std::uint32_t>(i))]);
  }
  for (int i = 0; i < n; ++i) b.add(all[static_cast<std::size_t>(i)]);
}

void circle_points(Builder& b, Random& random, int n) {
  const double radius = random.real(0.5, 50);
  const Point center{random.real(-9, 9), 1.5};
  for (int i = 0; i < n; ++i) b.add(center + radius * on_unit_circle(random.real()));
}

void line_points(Builder& b, Random& random, int n) {
  const Point direction{random.real(-1, 1), random.real(-1, 1)};
  for (int i = 0; i < n; ++i) {
    const double t = random.between(-40, 40) * 0.1;
    b.add(t * direction + Point{random.one_in(4) ? 0.1 : 0.0, 0.3});
  }
}

void some_points(Builder& b, Random& random, int n) {
  switch (random.below(4)) {
    case 0:
      return uniform_points(b, random, n);
    case 1:
      return circle_points(b, random, n);
    default:
      return lattice_points(b, random, n);
  }
}

void finish(Builder& b, Random& random, int n) {
  b.join_some(random.between(0, n), false);
  if (random.one_in(2)) b.frame();
}

void rotated_grid(Builder& b, Random& random, int n) {
  lattice_points(b, random, n);
  finish(b, random, n);
  const bool exact = random.one_in(3);
  const double s = exact ? 1 : random.one_in(2) ? 0.2 : random.real(0.01, 3);
  b.change_places([&](Point p) { return Point{s * (4 * p.x - 3 * p.y), s * (3 * p.x + 4 * p.y)}; });
}

void ulp_jitter(Builder& b, Random& random, int n) {
  switch (random.below(4)) {
    case 0:
      circle_points(b, random, n);
      break;
    case 1:
      line_points(b, random, n);
      break;
    default:
      lattice_points(b, random, n);
      break;
  }
  const std::size_t copies = random.one_in(2) ? b.size() / 4 : 0;
  for (std::size_t i = 0; i < copies; ++i) b.add(b.points()[i]);  // jitter makes them neighbours
  finish(b, random, n);
  b.jitter(random.between(1, 4), random.one_in(2) ? 1 : 4);
}

void far_away(Builder& b, Random& random, int n) {
  some_points(b, random, n);
  finish(b, random, n);
  const double far = random.one_in(2) ? 1e7 : 1e15;
  const Point shift{random.one_in(4) ? 0 : far, random.one_in(2) ? far : -0.7 * far};
  const double size = far > 1e10 ? 16 : 1;
  b.change_places([&](Point p) { return size * p + shift; });
}

double in_range(double c) {
  const double size = std::abs(c);
  if (size < min_coordinate) return 0;
  return size > max_coordinate ? std::copysign(max_coordinate, c) : c;
}

void scaled(Builder& b, Random& random, int n) {
  if (random.one_in(3)) {  // every coordinate of another size
    const int low = random.between(-140, 150), spread = random.between(1, 49);
    const auto coordinate = [&] {
      const double x = std::ldexp(1 + random.real(), random.between(low, low + spread));
      return random.one_in(8) ? 0 : random.one_in(2) ? x : -x;
    };
    for (int i = 0; i < n; ++i) {
      const double x = coordinate();
      b.add({x, coordinate()});
    }
    b.join_some(random.between(0, n), false);
    return;
  }
  some_points(b, random, n);
  finish(b, random, n);
  const double s = std::ldexp(1.0, random.between(-140, 188));
  b.change_places([&](Point p) { return Point{in_range(s * p.x), in_range(s * p.y)}; });
}

void small_angles(Builder& b, Random& random, int n) {
  const double step = std::ldexp(1.0, -random.between(4, 40));
  const int fans = 1 + n / 20;
  for (int f = 0; f < fans; ++f) {
    const Point at{4.0 * f, random.real(-1, 1)};
    const std::uint32_t apex = b.add(at);
    for (int i = 0; i < n / fans; ++i) {
      const double length = random.one_in(2) ? 3 : random.real(0.5, 3);
      const double slope = step * i;
      b.join(apex, b.add(at + length * Point{1, slope}));
    }
  }
  if (random.one_in(2)) b.frame();
}

void nested_rings(Builder& b, Random& random, int n) {
  const int rings = random.between(1, 2 + n / 12), corners = std::max(4, n / rings);
  // A ring of radius 1 leaves this much room inside: its corners lie at 0.9 or further out, and
  // half the widest angle between two of them is below 1.3 pi / corners.
  const double half_angle = 1.3 * 3.1416 / corners;
  const double room = 0.9 * (1 - 0.5 * half_angle * half_angle);
  double radius = 10;
  for (int r = 0; r < rings; ++r) {
    std::vector<Point> ring;
    for (int i = 0; i < corners; ++i) {
      const double wobble = random.real(0.9, 1.0);
      ring.push_back(radius * wobble * on_unit_circle((i + 0.5) / corners));
    }
    b.ring(ring);
    const double inner = 0.95 * room * radius;
    const Point between = 0.5 * (0.9 * radius + inner) * on_unit_circle(0.5 / corners);
    if (random.one_in(3) && r > 0) b.hole(between);
    else if (random.one_in(2)) b.region(between);
    radius = inner;
  }
}

//   A row of diamonds, each sharing a corner with the next; the first or all of them may touch the
//   frame: <><><>
void touching_holes(Builder& b, Random& random, int n) {
  const int diamonds = std::max(1, n / 4);
  const double height = random.one_in(2) ? 1 : 0.5;
  std::uint32_t left = b.add({0, 0});
  for (int i = 0; i < diamonds; ++i) {
    const double x = 2 * i;
    const std::uint32_t down = b.add({x + 1, -height}), up = b.add({x + 1, height});
    const bool shared = !random.one_in(4);
    const std::uint32_t right = b.add({x + (shared ? 2 : 1.75), 0});
    for (const auto& [from, to] : {std::pair(left, down), {down, right}, {right, up}, {up, left}}) {
      b.join(from, to);
    }
    if (!random.one_in(4)) b.hole({x + 1, 0.125});
    else if (random.one_in(2)) b.region({x + 1, 0.125});
    left = shared ? right : b.add({x + 2, 0});
  }
  const double end = 2 * diamonds, margin = random.one_in(2) ? 0 : 0.5;
  b.ring({{-margin, -1}, {end + margin, -1}, {end + margin, 1}, {-margin, 1}});
}

void comb(Builder& b, Random& random, int n) {
  const double width = random.one_in(2) ? 1 : std::ldexp(1.0, -random.between(1, 30));
  std::vector<Point> outline;
  double x = 0;
  for (int tooth = 0; tooth < std::max(2, n / 4); ++tooth) {
    const double tip = random.one_in(2) ? 10 : random.real(1, 10);
    outline.insert(outline.end(), {{x, 1}, {x, tip}, {x + width, tip}, {x + width, 1}});
    x += 2 * width;
  }
  outline.insert(outline.end(), {{x, 1}, {x, 0}, {0, 0}});
  b.ring(outline);
}

void spiral(Builder& b, Random& random, int n) {
  const int half = std::max(3, n / 2), per_turn = random.between(4, 9);
  std::vector<Point> outline;
  const auto at = [&](int i, double radius) {
    return (radius + double(i) / per_turn) * on_unit_circle(double(i % per_turn) / per_turn);
  };
  for (int i = 0; i < half; ++i) outline.push_back(at(i, 1));
  for (int i = half; i-- > 0;) outline.push_back(at(i, 0.75));
  b.ring(outline);
}

void overlap(Builder& b, Random& random, int n) {
  lattice_points(b, random, std::max(4, n / 2));
  const auto base = static_cast<std::uint32_t>(b.size());
  for (int i = 0; i < n / 4; ++i) b.add(b.points()[random.below(base)]);
  for (int i = 0; i < n; ++i) {  // along rows and columns, so that many overlap
    const auto count = static_cast<std::uint32_t>(b.size());
    const std::uint32_t p = random.below(count), q = random.below(count);
    const Point u = b.points()[p], w = b.points()[q];
    if (u.x == w.x || u.y == w.y) b.join(p, q);
  }
  b.join_some(random.between(0, n / 2), false);
  if (random.one_in(2)) b.frame();
}

void crossings(Builder& b, Random& random, int n) {
  some_points(b, random, n);
  b.join_some(random.between(2, 4 + n / 3), true);
  if (random.one_in(2)) b.frame();
  if (random.one_in(4)) b.jitter(2, 2);
}

}  // namespace

Pslg generate_pslg(Family family, std::uint64_t seed, int points) {
  Random random(seed ^ (static_cast<std::uint64_t>(family) + 1) << 56);
  Builder b(random);
  const int n = points > 0 ? points : random.between(5, 55);
  switch (family) {
    case Family::random:
      uniform_points(b, random, n), finish(b, random, n);
      break;
    case Family::grid:
      lattice_points(b, random, n), finish(b, random, n);
      break;
    case Family::rotated_grid:
      rotated_grid(b, random, n);
      break;
    case Family::ulp_jitter:
      ulp_jitter(b, random, n);
      break;
    case Family::offset:
      far_away(b, random, n);
      break;
    case Family::scale:
      scaled(b, random, n);
      break;
    case Family::small_angles:
      small_angles(b, random, n);
      break;
    case Family::nested_rings:
      nested_rings(b, random, n);
      break;
    case Family::touching_holes:
      touching_holes(b, random, n);
      break;
    case Family::comb_spiral:
      random.one_in(2) ? comb(b, random, n) : spiral(b, random, n);
      break;
    case Family::overlap:
      overlap(b, random, n);
      break;
    case Family::crossings:
      crossings(b, random, n);
      break;
  }
  // Any family may come jittered, turned or shifted.
  if (random.one_in(8)) b.jitter(3, 3);
  if (family != Family::scale && random.one_in(8)) {
    b.change_places([](Point p) { return Point{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y}; });
  }
  if (family != Family::scale && family != Family::offset && random.one_in(8)) {
    b.change_places([](Point p) { return p + Point{1e7, -3e7}; });
  }
  b.change_places([](Point p) { return Point{in_range(p.x), in_range(p.y)}; });
  return b.take();
}

}  // namespace lepp::test

#include "lepp/triangulation/merge_halves.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <vector>

#include "lepp/geometry/predicates.hpp"

namespace lepp {

namespace {

using Code = RawTriangulation::Code;

double along(Point p, bool by_y) { return by_y ? p.y : p.x; }

// Smallest coordinates of each block of points and of all behind it.
constexpr std::size_t block = 4096;
std::vector<double> smallest_from(std::span<const Point> points, bool by_y) {
  std::vector<double> from(points.size() / block + 2, std::numeric_limits<double>::infinity());
  for (std::size_t i = points.size(); i-- > 0;) {
    double& smallest = from[i / block];
    if (i % block == block - 1) smallest = from[i / block + 1];
    smallest = std::min(smallest, along(points[i], by_y));
  }
  return from;
}

// The cut nearest to the middle; 0 if there is none.
std::size_t best_cut(std::span<const Point> points, bool by_y) {
  const std::vector<double> from = smallest_from(points, by_y);
  const auto unevenness = [&](std::size_t cut) {
    return cut > points.size() - cut ? 2 * cut - points.size() : points.size() - 2 * cut;
  };
  std::size_t best = 0;
  double largest = -std::numeric_limits<double>::infinity();  // of the points before the block
  std::vector<double> behind(std::min(block, points.size()) +
                             1);  // smallest from point i of the block on
  for (std::size_t begin = 0; begin < points.size(); begin += block) {
    const std::size_t count = std::min(block, points.size() - begin);
    behind[count] = from[begin / block + 1];
    for (std::size_t i = count; i-- > 0;) {
      behind[i] = std::min(behind[i + 1], along(points[begin + i], by_y));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t cut = begin + i;
      if (largest < behind[i] && unevenness(cut) < unevenness(best)) best = cut;
      largest = std::max(largest, along(points[cut], by_y));
    }
  }
  return best;
}

// Ghosts (u, w) follow each other clockwise around the hull.
std::uint32_t ghost_after(const RawTriangulation& raw, std::uint32_t ghost) {
  return RawTriangulation::triangle_of(raw.twin(RawTriangulation::code(ghost, 0)));
}

class Merge {
 public:
  Merge(RawTriangulation& raw, std::span<const std::uint32_t> free)
      : raw_(raw), free_(free.begin(), free.end()) {}

  // From the ghosts of the halves that face each other.
  void run(std::uint32_t left, std::uint32_t right) {
    find_tangent(left, right);
    const std::uint32_t below = take_slot();
    raw_.set_corners(below, right_vertex_, left_vertex_, RawTriangulation::ghost);
    raw_.link(RawTriangulation::code(below, 0), RawTriangulation::code(after(left_ghost_), 1));
    raw_.link(RawTriangulation::code(below, 1), RawTriangulation::code(before(right_ghost_), 0));
    base_ = RawTriangulation::code(below, 2);
    while (step()) {
    }
    const std::uint32_t above = take_slot();
    raw_.set_corners(above, left_vertex_, right_vertex_, RawTriangulation::ghost);
    raw_.link(RawTriangulation::code(above, 2), base_);
    raw_.link(RawTriangulation::code(above, 0), RawTriangulation::code(right_ghost_, 1));
    raw_.link(RawTriangulation::code(above, 1), RawTriangulation::code(left_ghost_, 0));
    assert(left_.empty() && right_.empty() && free_.empty());
  }

 private:
  std::uint32_t after(std::uint32_t ghost) const { return ghost_after(raw_, ghost); }
  std::uint32_t before(std::uint32_t ghost) const {
    return RawTriangulation::triangle_of(raw_.twin(RawTriangulation::code(ghost, 1)));
  }
  VertexId start_of(std::uint32_t ghost) const { return raw_.triangles[ghost].vertices[0]; }
  VertexId end_of(std::uint32_t ghost) const { return raw_.triangles[ghost].vertices[1]; }
  int side(VertexId v) const {
    return orient2d(raw_.point(left_vertex_), raw_.point(right_vertex_), raw_.point(v));
  }

  // Clockwise on the left, counter-clockwise on the right, until nothing lies below.
  void find_tangent(std::uint32_t left, std::uint32_t right) {
    left_vertex_ = start_of(left);
    right_vertex_ = start_of(right);
    while (true) {  // ends: each step turns the line one way round both convex hulls
      if (side(end_of(left)) < 0) {
        left_vertex_ = end_of(left);
        left = after(left);
      } else if (side(start_of(before(right))) < 0) {
        right = before(right);
        right_vertex_ = start_of(right);
      } else {
        break;
      }
    }
    left_ghost_ = before(left);
    right_ghost_ = right;
  }

  //    c ... d       One triangle more on the base l-r: with c, the next vertex up the left side of
  //     \   /        the gap, or with d, up the right side. Triangles behind these sides that the
  //      l-r         other half spoils go first. False if nothing lies above: the upper tangent.
  bool step() {
    const bool has_left = clear_left(), has_right = clear_right();
    if (!has_left && !has_right) return false;
    const Point l = raw_.point(left_vertex_), r = raw_.point(right_vertex_);
    const bool take_right =
        !has_left || (has_right && incircle(l, r, raw_.point(raw_.destination(left_.back())),
                                            raw_.point(raw_.origin(right_.back()))) > 0);
    const VertexId up = take_right ? raw_.origin(right_.back()) : raw_.destination(left_.back());
    const std::uint32_t t = take_slot();
    raw_.set_corners(t, left_vertex_, right_vertex_, up);
    raw_.link(RawTriangulation::code(t, 2), base_);
    if (take_right) {
      raw_.link(RawTriangulation::code(t, 0), right_.back());
      right_.pop_back();
      right_vertex_ = up;
      base_ = RawTriangulation::code(t, 1);
    } else {
      raw_.link(RawTriangulation::code(t, 1), left_.back());
      left_.pop_back();
      left_vertex_ = up;
      base_ = RawTriangulation::code(t, 0);
    }
    return true;
  }

  // Brings an edge l -> c to the top of left_ that is Delaunay as far as r can tell. False if c
  // does not lie above the base.
  bool clear_left() {
    if (left_.empty()) {
      if (side(start_of(left_ghost_)) <= 0) return false;
      left_.push_back(raw_.twin(RawTriangulation::code(left_ghost_, 2)));
      free_.push_back(left_ghost_);
      left_ghost_ = before(left_ghost_);
    }
    if (side(raw_.destination(left_.back())) <= 0) return false;
    while (is_spoilt(left_.back(), raw_.destination(left_.back()))) {
      const Code e = left_.back();
      left_.back() = raw_.twin(RawTriangulation::next(e));
      left_.push_back(raw_.twin(RawTriangulation::previous(e)));
      free_.push_back(RawTriangulation::triangle_of(e));
    }
    return true;
  }

  // The same on the right, where edges run c -> r.
  bool clear_right() {
    if (right_.empty()) {
      if (side(end_of(right_ghost_)) <= 0) return false;
      right_.push_back(raw_.twin(RawTriangulation::code(right_ghost_, 2)));
      free_.push_back(right_ghost_);
      right_ghost_ = after(right_ghost_);
    }
    if (side(raw_.origin(right_.back())) <= 0) return false;
    while (is_spoilt(right_.back(), raw_.origin(right_.back()))) {
      const Code e = right_.back();
      right_.back() = raw_.twin(RawTriangulation::previous(e));
      right_.push_back(raw_.twin(RawTriangulation::next(e)));
      free_.push_back(RawTriangulation::triangle_of(e));
    }
    return true;
  }

  // The triangle behind side `e` of the gap reaches into the circle of the base and c.
  bool is_spoilt(Code e, VertexId c) const {
    if (raw_.is_ghost(RawTriangulation::triangle_of(e))) return false;
    return incircle(raw_.point(left_vertex_), raw_.point(right_vertex_), raw_.point(c),
                    raw_.point(raw_.apex(e))) > 0;
  }

  std::uint32_t take_slot() {
    const std::uint32_t t = free_.back();
    free_.pop_back();
    return t;
  }

  RawTriangulation& raw_;
  std::vector<std::uint32_t> free_;
  VertexId left_vertex_, right_vertex_;  // the ends of the base
  Code base_ = 0;                        // r -> l, on what has been joined so far
  std::vector<Code> left_, right_;       // sides of the gap that are no hull edges, lowest last
  std::uint32_t left_ghost_ = 0;         // the hull edge that ends at the top of the left side
  std::uint32_t right_ghost_ = 0;        // the one that starts at the top of the right side
};

}  // namespace

std::optional<Halves> find_halves(std::span<const Point> points) {
  const std::size_t by_x = best_cut(points, false), by_y = best_cut(points, true);
  const auto smaller = [&](std::size_t cut) { return std::min(cut, points.size() - cut); };
  const bool use_y = smaller(by_y) > smaller(by_x);
  const std::size_t cut = use_y ? by_y : by_x;
  if (smaller(cut) < points.size() / 8 || cut == 0) return std::nullopt;
  return Halves{cut, use_y};
}

std::uint32_t facing_ghost(const RawTriangulation& raw, std::uint32_t first_triangle,
                           const Halves& halves, Half half) {
  const auto place = [&](std::uint32_t ghost) {
    const double at = along(raw.point(raw.triangles[ghost].vertices[0]), halves.by_y);
    return half == Half::first ? at : -at;
  };
  std::uint32_t first = first_triangle;
  while (!raw.is_ghost(first)) ++first;
  std::uint32_t best = first;
  for (std::uint32_t g = ghost_after(raw, first); g != first; g = ghost_after(raw, g)) {
    if (place(g) > place(best)) best = g;
  }
  return best;
}

void merge_halves(RawTriangulation& raw, std::array<std::uint32_t, 2> facing,
                  std::array<std::uint32_t, 2> free) {
  Merge(raw, free).run(facing[0], facing[1]);
}

}  // namespace lepp

#include "lepp/triangulation/delaunay.hpp"

#include <array>
#include <bit>
#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/two_threads.hpp"
#include "lepp/triangulation/merge_halves.hpp"

namespace lepp {

namespace {

using Code = RawTriangulation::Code;

constexpr unsigned most_rounds = 10;

// The round each vertex is inserted in, counted from the last one, 0: an eighth of the vertices
// of each round, picked by a hash of their numbers, goes to the round before.
std::vector<std::uint8_t> choose_rounds(std::size_t count) {
  std::vector<std::uint8_t> rounds(count);
  for (std::size_t v = 0; v < count; ++v) {
    std::uint64_t h = (v + 0x9E3779B97F4A7C15U) * 0xBF58476D1CE4E5B9U;
    h = (h ^ h >> 29) * 0x94D049BB133111EBU >> 32 | std::uint64_t{1} << 3 * (most_rounds - 1);
    rounds[v] = static_cast<std::uint8_t>(std::countr_zero(h) / 3);
  }
  return rounds;
}

// Inserts vertices of one range; its triangles lie from first_triangle on, 2 (vertices - 1) of
// them. Two can work at the same time on different ranges.
class Inserter {
 public:
  Inserter(RawTriangulation& raw, std::uint32_t first_triangle)
      : raw_(raw), last_(first_triangle), unused_(first_triangle) {}

  // One triangle (a, b, c) and the three ghosts around it.
  //
  //             c              ghost across edge i of the triangle is triangle 1 + i; ghosts meet
  //        2  /   \  1         along the edges to infinity
  //          a --- b
  //             3
  void start(VertexId a, VertexId b, VertexId c) {
    if (orient2d(raw_.point(a), raw_.point(b), raw_.point(c)) < 0) std::swap(b, c);
    const std::array<VertexId, 3> v{a, b, c};
    const std::uint32_t t = last_;
    for (std::uint32_t i = 0; i < 4; ++i) raw_.triangles[unused_++] = {};
    raw_.set_corners(t, a, b, c);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t g = t + 1 + i;
      raw_.set_corners(g, v[previous_corner(i)], v[next_corner(i)], RawTriangulation::ghost);
      raw_.link(RawTriangulation::code(t, i), RawTriangulation::code(g, 2));
      raw_.link(RawTriangulation::code(g, 0),
                RawTriangulation::code(t + 1 + previous_corner(i), 1));
    }
  }

  void insert(VertexId v) {
    const Point p = raw_.point(v);
    open(triangle_at(p));
    // The edges of the hole come up counter-clockwise; each becomes the base of a new triangle.
    Code first = 0, before = 0;  // the sides of new triangles that meet at p, still to be linked
    bool started = false;
    while (!pending_.empty()) {  // triangles of the hole + 2 = new triangles + pending edges
      const Code outside = pending_.back();
      pending_.pop_back();
      const std::uint32_t t = RawTriangulation::triangle_of(outside);
      if (is_in_conflict(raw_.triangles[t].vertices, p)) {
        pending_.push_back(raw_.twin(RawTriangulation::previous(outside)));
        pending_.push_back(raw_.twin(RawTriangulation::next(outside)));
        free_.push_back(t);
        continue;
      }
      const Sides sides = close(outside, v);
      if (started) raw_.link(before, sides.from_p);
      else first = sides.from_p;
      started = true;
      before = sides.to_p;
    }
    raw_.link(before, first);
    last_ = RawTriangulation::triangle_of(first);
  }

 private:
  // The edges p -> a and b -> p of a new triangle (p, a, b), as p's neighbours will link to them.
  struct Sides {
    Code from_p, to_p;
  };

  // Walks from the last insertion towards p. Ends: no cycle is possible in a Delaunay
  // triangulation. A ghost that is reached has p strictly beyond its hull edge.
  std::uint32_t triangle_at(Point p) const {
    std::uint32_t t = last_;
    if (raw_.is_ghost(t))
      t = RawTriangulation::triangle_of(raw_.twin(RawTriangulation::code(t, 2)));
    std::uint32_t entered = 3;
    while (true) {
      const auto& v = raw_.triangles[t].vertices;
      const Point a = raw_.point(v[0]), b = raw_.point(v[1]), c = raw_.point(v[2]);
      std::uint32_t leave = 3;
      if (entered != 0 && orient2d(b, c, p) < 0) leave = 0;
      else if (entered != 1 && orient2d(c, a, p) < 0) leave = 1;
      else if (entered != 2 && orient2d(a, b, p) < 0) leave = 2;
      if (leave == 3) return t;
      const Code across = raw_.twin(RawTriangulation::code(t, leave));
      t = RawTriangulation::triangle_of(across);
      if (raw_.is_ghost(t)) return t;
      entered = RawTriangulation::edge_of(across);
    }
  }

  bool is_in_conflict(const std::array<VertexId, 3>& v, Point p) const {
    const Point a = raw_.point(v[0]), b = raw_.point(v[1]);
    if (v[2] != RawTriangulation::ghost) return incircle(a, b, raw_.point(v[2]), p) > 0;
    const int side = orient2d(a, b, p);
    return side > 0 || (side == 0 && dot_sign(a, p, b) < 0);
  }

  void open(std::uint32_t t) {
    free_.push_back(t);
    for (std::uint32_t i = 3; i-- > 0;) {
      pending_.push_back(raw_.twin(RawTriangulation::code(t, i)));
    }
  }

  Sides close(Code outside, VertexId p) {
    const VertexId a = raw_.destination(outside), b = raw_.origin(outside);
    std::uint32_t t = unused_;
    if (free_.empty()) {
      raw_.triangles[unused_++] = {};
    } else {
      t = free_.back();
      free_.pop_back();
    }
    // Corner 0 is p, a or b: whichever makes a ghost, if there is one, corner 2.
    const std::uint32_t at_p = b == RawTriangulation::ghost   ? 0
                               : a == RawTriangulation::ghost ? 1
                                                              : 2;
    if (at_p == 0) raw_.set_corners(t, p, a, b);
    else if (at_p == 1) raw_.set_corners(t, b, p, a);
    else raw_.set_corners(t, a, b, p);
    const Code base = RawTriangulation::code(t, at_p);
    raw_.link(base, outside);
    return {RawTriangulation::previous(base), RawTriangulation::next(base)};
  }

  RawTriangulation& raw_;
  std::uint32_t last_;               // one that the last insertion made
  std::uint32_t unused_;             // the first triangle that has not been used yet
  std::vector<Code> pending_;        // edges seen from outside the hole, still to be looked at
  std::vector<std::uint32_t> free_;  // triangles of the hole that are not in use again yet
};

// False, with nothing done, if the vertices lie on one line.
bool triangulate_range(RawTriangulation& raw, std::uint32_t begin, std::uint32_t end,
                       std::uint32_t first_triangle) {
  const auto point = [&](std::uint32_t v) { return raw.points[v]; };
  std::uint32_t apex = begin + 2;
  while (apex < end && orient2d(point(begin), point(begin + 1), point(apex)) == 0) ++apex;
  if (apex >= end) return false;
  Inserter inserter(raw, first_triangle);
  inserter.start(VertexId(begin), VertexId(begin + 1), VertexId(apex));
  std::vector<std::uint8_t> rounds = choose_rounds(end - begin);
  rounds[0] = rounds[1] = rounds[apex - begin] = most_rounds;
  for (unsigned round = most_rounds; round-- > 0;) {
    for (std::uint32_t v = begin + 2; v < end; ++v) {
      if (rounds[v - begin] == round) inserter.insert(VertexId(v));
    }
  }
  return true;
}

bool triangulate_halves(RawTriangulation& raw, const Halves& halves, unsigned threads) {
  const auto cut = static_cast<std::uint32_t>(halves.first_of_second);
  const auto count = static_cast<std::uint32_t>(raw.points.size());
  const std::uint32_t middle = 2 * (cut - 1), free = 2 * (count - 2);  // two are free from there on
  std::array<bool, 2> done{};
  std::array<std::uint32_t, 2> facing{};
  in_parallel(
      threads,
      [&] {
        done[0] = triangulate_range(raw, 0, cut, 0);
        if (done[0]) facing[0] = facing_ghost(raw, 0, halves, Half::first);
      },
      [&] {
        done[1] = triangulate_range(raw, cut, count, middle);
        if (done[1]) facing[1] = facing_ghost(raw, middle, halves, Half::second);
      });
  if (!done[0] || !done[1]) return false;
  for (const std::uint32_t t : {free, free + 1}) raw.triangles[t] = {};
  merge_halves(raw, facing, {free, free + 1});
  return true;
}

}  // namespace

bool triangulate_points(RawTriangulation& raw, const DelaunayOptions& options) {
  const auto count = static_cast<std::uint32_t>(raw.points.size());
  raw.triangles.resize(2 * (std::size_t{count} - 1));
  if (count >= options.halve_from) {
    const auto halves = find_halves(raw.points);
    if (halves && triangulate_halves(raw, *halves, options.threads)) return true;
  }
  if (triangulate_range(raw, 0, count, 0)) return true;
  raw.triangles.clear();
  return false;
}

}  // namespace lepp

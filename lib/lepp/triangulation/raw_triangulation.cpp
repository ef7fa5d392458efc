#include "lepp/triangulation/raw_triangulation.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "lepp/geometry/predicates.hpp"

namespace lepp {

namespace {

// A set of triangles that knows how many of its members come before one: a bit each, and a count
// for every 64.
class Ranks {
 public:
  template <class Has>
  Ranks(std::size_t triangles, Has has) : words_(triangles / 64 + 1) {
    for (std::uint32_t t = 0; t < triangles; ++t) {
      Word& word = words_[t / 64];
      if (t % 64 == 0) word.before = count_;
      if (!has(t)) continue;
      word.members |= std::uint64_t{1} << t % 64;
      ++count_;
    }
  }

  bool has(std::uint32_t t) const { return (words_[t / 64].members >> t % 64 & 1) != 0; }
  std::uint32_t rank(std::uint32_t t) const {
    const Word& word = words_[t / 64];
    const std::uint64_t below = word.members & ((std::uint64_t{1} << t % 64) - 1);
    return word.before + static_cast<std::uint32_t>(std::popcount(below));
  }
  std::uint32_t count() const { return count_; }

 private:
  struct Word {
    std::uint64_t members = 0;
    std::uint32_t before = 0;
  };
  std::vector<Word> words_;
  std::uint32_t count_ = 0;
};

}  // namespace

void RawTriangulation::find_leaving() {
  leaving.resize(points.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) leave_from(t);
}

void RawTriangulation::flip(Code e) {
  //        c
  //      / | \        t: (c, a, d) keeps the outer edges ca and ad
  //     a e|  b       u: (d, b, c) keeps the outer edges db and bc
  //      \ | /        e = a -> b before; afterwards d -> c in t, opposite a
  //        d
  const Code f = twin(e);
  const VertexId a = origin(e), b = destination(e), c = apex(e), d = apex(f);
  const std::uint32_t t = triangle_of(e), u = triangle_of(f);
  const Code ca = previous(e), bc = next(e), ad = next(f), db = previous(f);
  const std::array<std::pair<Code, bool>, 4> outer{{{twin(ca), is_constrained(ca)},
                                                    {twin(ad), is_constrained(ad)},
                                                    {twin(db), is_constrained(db)},
                                                    {twin(bc), is_constrained(bc)}}};
  set_corners(t, c, a, d);
  set_corners(u, d, b, c);
  const std::array<Code, 4> inner{code(t, 2), code(t, 0), code(u, 2), code(u, 0)};
  for (std::size_t i = 0; i < 4; ++i) {
    link(inner[i], outer[i].first);
    set_constrained(inner[i], outer[i].second);
  }
  link(code(t, 1), code(u, 1));
  leave_from(t);
  leave_from(u);
}

void RawTriangulation::restore_delaunay(std::vector<Code>& suspects) {
  XorShift random;
  while (!suspects.empty()) {  // ends: no edge that a flip removed ever comes back
    std::swap(suspects[random(suspects.size())], suspects.back());
    const Code e = suspects.back();
    suspects.pop_back();
    if (is_constrained(e)) continue;
    const Code f = twin(e);
    const std::uint32_t t = triangle_of(e), u = triangle_of(f);
    if (is_ghost(t) || is_ghost(u)) continue;
    const auto& v = triangles[t].vertices;
    if (incircle(point(v[0]), point(v[1]), point(v[2]), point(apex(f))) <= 0) continue;
    flip(e);
    suspects.insert(suspects.end(), {code(t, 0), code(t, 2), code(u, 0), code(u, 2)});
  }
}

RawTriangulation::Code RawTriangulation::edge_between(VertexId a, VertexId b) const {
  Code at_a = leaving[a.index()], at_b = leaving[b.index()];
  while (true) {
    if (destination(at_a) == b) return at_a;
    if (destination(at_b) == a) return at_b;
    at_a = turn(at_a);
    at_b = turn(at_b);
  }
}

TriangleArray RawTriangulation::take_triangles(
    const std::vector<std::optional<SurfaceId>>& of_label,
    const std::vector<std::uint32_t>& vertex) {
  constexpr std::uint32_t dropped = Triangle::nothing;
  const Ranks kept(triangles.size(),
                   [&](std::uint32_t t) { return of_label[label(t)].has_value(); });
  std::ranges::fill(leaving, dropped);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!kept.has(t)) continue;
    const std::uint32_t place = kept.rank(t);
    Triangle triangle = triangles[t];
    triangle.region_ = *of_label[triangle.region_.value];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Code across = triangle.across_[i];
      const bool is_boundary = !kept.has(triangle_of(across));
      triangle.across_[i] =
          is_boundary ? Triangle::nothing : code(kept.rank(triangle_of(across)), edge_of(across));
      Code& first = leaving[triangle.vertices[next_corner(i)].index()];
      if (first == dropped || is_boundary) first = code(place, i);
    }
    for (VertexId& v : triangle.vertices) v = VertexId(vertex[v.index()]);
    triangles[place] = triangle;  // place <= t: nothing that is still needed
  }
  triangles.resize(kept.count());
  // Refinement will want the room; a copy costs more memory, for a while, than it sets free.
  if (kept.count() < triangles.capacity() / 4) triangles.shrink_to_fit();
  return std::move(triangles);
}

bool RawTriangulation::is_constrained_vertex_at(std::uint32_t t, Point p) const {
  for (const VertexId v : triangles[t].vertices) {
    if (point(v) != p) continue;
    const Code first = leaving[v.index()];
    Code e = first;
    do {
      if (is_constrained(e)) return true;
      e = turn(e);
    } while (e != first);
  }
  return false;
}

RawTriangulation::Place RawTriangulation::locate(Point p, std::uint32_t start) const {
  XorShift random;
  std::uint32_t t = start;
  if (is_ghost(t)) t = triangle_of(twin(code(t, 2)));
  while (true) {  // ends with probability 1, in O(sqrt n) steps for points spread evenly
    bool on_constrained = false;
    std::uint32_t leave = 3;
    const std::uint32_t first = random(3);
    for (std::uint32_t k = 0; k < 3 && leave == 3; ++k) {
      const std::uint32_t i = (first + k) % 3;
      const Code e = code(t, i);
      const int side = orient2d(point(origin(e)), point(destination(e)), p);
      if (side < 0) leave = i;
      if (side == 0 && is_constrained(e)) on_constrained = true;
    }
    if (leave == 3) return {t, on_constrained || is_constrained_vertex_at(t, p)};
    t = triangle_of(twin(code(t, leave)));
    if (is_ghost(t)) return {t, false};
  }
}

}  // namespace lepp

#include "lepp/triangulation/remove_vertex.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/outer_edge.hpp"

namespace lepp {

namespace {

// The other ends of the constrained edges that end at v.
std::vector<VertexId> constrained_neighbours(const Mesh& mesh, VertexId v) {
  std::vector<VertexId> ends;
  for_each_in_fan(mesh, v, [&](TriangleId t, std::uint32_t corner) {
    const HalfEdge out{t, previous_corner(corner)}, in{t, next_corner(corner)};
    if (mesh.is_constrained(out)) ends.push_back(mesh.destination(out));
    if (mesh.is_boundary(in)) ends.push_back(mesh.origin(in));  // no triangle sees it as `out`
  });
  return ends;
}

Removability removability_from_segment(const Mesh& mesh, VertexId a, VertexId v, VertexId b) {
  const ConstrainedEdge to_a = *mesh.find_record(a, v), to_b = *mesh.find_record(v, b);
  if (to_a.segments != to_b.segments) return Removability::different_segments;
  const auto is_curved = [&](SegmentId s) {
    const auto curve = mesh.segments()[s.index()].curve;
    return curve && !is_straight(mesh.entities()[*curve].geometry);
  };
  if (std::ranges::any_of(mesh.segments_of(to_a.segments), is_curved)) return Removability::curved;
  // v lies between a and b: if it were beyond one of them, the other edge would cover that vertex.
  const bool straight = orient2d(mesh.point(a), mesh.point(v), mesh.point(b)) == 0;
  return straight ? Removability::from_segment : Removability::bent;
}

class StarOf {
 public:
  StarOf(Mesh& mesh, VertexId v) : mesh_(mesh), v_(v) {}

  Removal remove() {
    constrained_ = constrained_neighbours(mesh_, v_);
    cut_ears();
    fill();
    for (const TriangleId t : free_) mesh_.set_vertices(t, v_, v_, v_);
    for (const TriangleId t : filled_) mesh_.refresh_leaving(t);
    if (!constrained_.empty()) mesh_.join_records(constrained_[0], v_, constrained_[1]);
    removal_.changed.insert(removal_.changed.end(), filled_.begin(), filled_.end());
    restore_delaunay(mesh_, suspects_, &removal_.changed);
    fill_gaps();
    return std::move(removal_);
  }

 private:
  std::size_t degree() const {
    std::size_t edges = 0;
    for_each_in_fan(mesh_, v_, [&](TriangleId, std::uint32_t) { ++edges; });
    return edges;
  }

  // Flips edges at v until none can be flipped: three are left, or four with v on a diagonal; on
  // each side of a constrained edge one. In a closed fan each edge that could not be flipped is
  // tried again only once a neighbour of it has been.
  void cut_ears() {
    std::size_t around = degree();
    std::size_t refused = 0;  // so many edges clockwise of e cannot be flipped
    HalfEdge e = mesh_.leaving(v_);
    while (refused < around) {  // ends: each turn makes around - refused smaller, or around
      if (!mesh_.is_constrained(e) && is_flippable(mesh_, e)) {
        const HalfEdge diagonal = flip(mesh_, e);
        const TriangleId ear = mesh_.twin(diagonal)->triangle;
        suspects_.push_back(diagonal_of_ear(ear));
        removal_.changed.push_back(ear);
        --around;
        refused = std::min(refused - (refused > 0 ? 1 : 0), around - 2);
        e = {diagonal.triangle, 0};  // v to the corner clockwise of the ear
        continue;
      }
      ++refused;
      const auto next = turn_counter_clockwise(mesh_, e);
      if (!next) return;  // round an open fan once, stepping back at each ear
      e = *next;
    }
  }
  // flip() puts the new diagonal opposite corner 1.
  static HalfEdge diagonal_of_ear(TriangleId ear) { return {ear, 1}; }

  //      p2               p2          star[i] is triangle v p_i p_(i+1)
  //     / | \            /   \        three corners or an open fan: one triangle, p0 p1 p2
  //   p3--v--p1        p3-----p1      four corners: two, on both sides of the diagonal p_j p_(j+2)
  //     \ | /            \   /
  //      p0               p0
  void fill() {
    std::vector<HalfEdge> star;  // the outer edges
    for_each_in_fan(mesh_, v_, [&](TriangleId t, std::uint32_t i) { star.push_back({t, i}); });
    std::vector<OuterEdge> outer;
    for (const HalfEdge e : star) outer.emplace_back(mesh_, e);
    const std::size_t j = star.size() == 4 ? diagonal_start(star) : 0;
    std::array<VertexId, 4> p{};
    for (std::size_t i = 0; i < 4; ++i) p[i] = corner(star, j + i);
    const auto at = [&](std::size_t i) { return (j + i) % star.size(); };

    const TriangleId t = star[at(0)].triangle;
    put(t, {p[0], p[1], p[2]}, outer[at(0)], outer[at(1)]);
    for (std::size_t i = 1; i < star.size(); ++i) {
      if (i == 2 && star.size() == 4) continue;
      free_.push_back(star[at(i)].triangle);
    }
    if (star.size() == 3) {
      outer[at(2)].attach(mesh_, {t, 1});
    } else if (star.size() == 2) {
      mesh_.unlink({t, 1});
      mesh_.set_constrained_flag({t, 1}, true);
    } else {
      assert(star.size() == 4);
      const TriangleId u = star[at(2)].triangle;
      put(u, {p[2], p[3], p[0]}, outer[at(2)], outer[at(3)]);
      mesh_.link({t, 1}, {u, 1});
      mesh_.set_constrained_flag({t, 1}, !constrained_.empty());
      mesh_.set_constrained_flag({u, 1}, !constrained_.empty());
    }
  }

  // Makes `t` the triangle a b c, with what lies beyond ab and bc; beyond ca is the caller's.
  void put(TriangleId t, const std::array<VertexId, 3>& corners, const OuterEdge& ab,
           const OuterEdge& bc) {
    const auto [a, b, c] = corners;
    mesh_.set_vertices(t, a, b, c);
    ab.attach(mesh_, {t, 2});
    bc.attach(mesh_, {t, 0});
    filled_.push_back(t);
    suspects_.insert(suspects_.end(), {{t, 0}, {t, 1}, {t, 2}});
  }

  // p_i. The last triangle of an open fan of two has a corner that no other one starts at.
  VertexId corner(const std::vector<HalfEdge>& star, std::size_t i) const {
    if (i == star.size()) return mesh_.destination(star[i - 1]);
    return mesh_.origin(star[i % star.size()]);
  }

  // Where the diagonal starts: at a constrained edge, else where both triangles come out positive.
  std::size_t diagonal_start(const std::vector<HalfEdge>& star) const {
    if (!constrained_.empty()) {
      return std::ranges::find(constrained_, corner(star, 0)) != constrained_.end() ? 0 : 1;
    }
    std::array<Point, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = mesh_.point(corner(star, i));
    return orient2d(p[0], p[1], p[2]) > 0 && orient2d(p[2], p[3], p[0]) > 0 ? 0 : 1;
  }

  void fill_gaps() {
    std::ranges::sort(free_, std::greater<>());  // so that no free triangle moves
    auto& moves = removal_.moved_triangles;
    for (const TriangleId gap : free_) {
      const auto from = mesh_.remove_triangle(gap);
      if (!from) continue;
      if (!moves.empty() && moves.back().to == *from) moves.back().to = gap;
      else moves.push_back({*from, gap});
    }
    auto& changed = removal_.changed;
    for (TriangleId& t : changed) {
      const auto move = std::ranges::find(moves, t, &Removal::TriangleMove::from);
      if (move != moves.end()) t = move->to;
    }
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    removal_.moved_vertex = mesh_.remove_vertex(v_);
  }

  Mesh& mesh_;
  VertexId v_;
  std::vector<VertexId> constrained_;  // the other ends of constrained edges at v: none or two
  std::vector<HalfEdge> suspects_;
  std::vector<TriangleId> filled_, free_;
  Removal removal_;
};

}  // namespace

Removability removability(const Mesh& mesh, VertexId v) {
  if (mesh.is_input(v)) return Removability::input_vertex;
  const auto ends = constrained_neighbours(mesh, v);
  if (ends.empty()) return Removability::from_inside;
  if (ends.size() != 2) return Removability::end_of_segments;
  return removability_from_segment(mesh, ends[0], v, ends[1]);
}

std::string_view to_string(Removability r) {
  switch (r) {
    case Removability::from_inside:
      return "it ends no constrained edge";
    case Removability::from_segment:
      return "it cuts a segment in two";
    case Removability::input_vertex:
      return "it is a point of the input";
    case Removability::end_of_segments:
      return "a segment ends or segments meet there";
    case Removability::different_segments:
      return "two segments meet there";
    case Removability::bent:
      return "its two constrained edges are not collinear";
    case Removability::curved:
      return "it lies on a curve";
  }
  return {};
}

std::optional<Removal> remove_vertex(Mesh& mesh, VertexId v) {
  if (!is_removable(removability(mesh, v))) return std::nullopt;
  return StarOf(mesh, v).remove();
}

}  // namespace lepp

#include "lepp/bisection/cutter.hpp"

#include <algorithm>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/lepp.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"

namespace lepp {

std::optional<Cut> Cutter::plan(HalfEdge e, std::optional<HalfEdge> across) const {
  Cut cut;
  cut.sides[0].e = e;
  if (across) {
    cut.sides[1].e = *across;
    cut.side_count = 2;
  }
  cut.constrained = mesh_.is_constrained(e);
  return place_middle(cut) ? std::optional(cut) : std::nullopt;
}

bool Cutter::place_middle(Cut& cut) const {
  const HalfEdge e = cut.sides[0].e;
  if (cut.constrained) {
    const VertexId from = std::min(mesh_.origin(e), mesh_.destination(e));  // from either side
    const ConstrainedPiece piece = piece_from(mesh_, e, from);
    if (options_.follow_curves && piece.curve != nullptr) {
      const CurvePoint on_curve = halfway(*piece.curve, piece.piece);
      cut.parameter = on_curve.t;
      if (try_middle(cut, in_supported_range(on_curve.point))) return true;
    }
    cut.parameter = 0.5 * (piece.piece.t_a + piece.piece.t_b);
  }
  const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
  const Point middle = in_supported_range(midpoint(a, b));
  if (cut.side_count == 2) return try_middle(cut, middle);
  const auto fits = [&](Point p) { return try_middle(cut, p); };
  return point_near_chord(mesh_, e, middle, fits).has_value();
}

// Whether all halves would be counter-clockwise; if so, which of their edges are the next.
bool Cutter::try_middle(Cut& cut, Point middle) const {
  cut.middle = middle;
  for (Cut::Side& side : cut.both()) {
    const std::uint32_t edge = side.e.edge;
    std::array<Point, 3> first = mesh_.corners(side.e.triangle), second = first;
    first[previous_corner(edge)] = middle;
    second[next_corner(edge)] = middle;
    for (const auto& [a, b, c] : {first, second}) {
      if (orient2d(a, b, c) <= 0) return false;
    }
    const bool by_length = forest_.rule_ == BisectionRule::longest_edge;
    side.next[0] =
        static_cast<std::uint8_t>(by_length ? longest_edge(first) : previous_corner(edge));
    side.next[1] = static_cast<std::uint8_t>(by_length ? longest_edge(second) : next_corner(edge));
  }
  return true;
}

void Cutter::announce(const Cut& cut) {
  for (const Cut::Side& side : cut.both()) {
    announced(side.e.triangle) = 4 * side.second.value + side.e.edge;
  }
}

void Cutter::forget(const Cut& cut) {
  for (const Cut::Side& side : cut.both()) announced(side.e.triangle) = Forest::none;
}

// What lies across `e` once all of the round is cut.
std::optional<HalfEdge> Cutter::now_across(HalfEdge e) const {
  const auto across = mesh_.twin(e);
  if (!across || announced(across->triangle) == Forest::none) return across;
  const std::uint32_t cut = announced(across->triangle);
  if (across->edge != next_corner(cut % 4)) return across;
  return HalfEdge{TriangleId(cut / 4), across->edge};
}

void Cutter::write(const Cut& cut, std::vector<TriangleId>& woken) {
  for (const Cut::Side& side : cut.both()) {
    wake(mesh_.twin(next_edge(side.e)), woken);
    wake(mesh_.twin(previous_edge(side.e)), woken);
  }
  const auto& [left, right] = cut.sides;
  VertexOrigin origin{VertexOrigin::Kind::interior, 0};
  if (cut.constrained) origin = origin_on(mesh_, left.e);
  mesh_.set_vertex(cut.vertex, cut.middle, origin);
  if (cut.side_count == 2) {
    write_side(cut, left, HalfEdge{right.second, right.e.edge}, right.e);
    write_side(cut, right, HalfEdge{left.second, left.e.edge}, left.e);
  } else {
    write_side(cut, left, std::nullopt, std::nullopt);
  }
  mesh_.set_leaving(cut.vertex, {left.second, left.e.edge});
}

// What is cut itself does not wait. Of others, the edge first: no other thread looks at the state
// of who waits at this edge.
void Cutter::wake(std::optional<HalfEdge> across, std::vector<TriangleId>& woken) {
  if (!across || announced(across->triangle) != Forest::none) return;
  Forest::Leaf& leaf = forest_.leaves_[across->triangle.index()];
  if (leaf.cut != across->edge || leaf.state != Forest::State::waiting) return;
  leaf.state = Forest::State::listed;
  woken.push_back(across->triangle);
}

// The edge runs from a to b; beyond its halves lie `beside_a` and `beside_b`.
void Cutter::write_side(const Cut& cut, const Cut::Side& side, std::optional<HalfEdge> beside_a,
                        std::optional<HalfEdge> beside_b) {
  const HalfEdge e = side.e;
  const TriangleId t = e.triangle, u = side.second;
  const HalfEdge to_c = next_edge(e), from_c = previous_edge(e);
  const auto before = mesh_.twin(to_c), across_to_c = now_across(to_c);
  auto corners = mesh_.vertices(t), of_second = corners;
  const VertexId b = corners[previous_corner(e.edge)];
  of_second[next_corner(e.edge)] = cut.vertex;
  corners[previous_corner(e.edge)] = cut.vertex;

  mesh_.set_triangle(u, of_second, mesh_.region(t));
  mesh_.set_across({u, e.edge}, beside_b);
  mesh_.set_across({u, to_c.edge}, across_to_c);
  mesh_.set_across({u, from_c.edge}, to_c);
  mesh_.set_constrained_flag({u, e.edge}, cut.constrained);
  mesh_.set_constrained_flag({u, to_c.edge}, mesh_.is_constrained(to_c));
  if (before && announced(before->triangle) == Forest::none) {  // else it sees to that itself
    mesh_.set_across(*before, HalfEdge{u, to_c.edge});
  }

  mesh_.set_across(from_c, now_across(from_c));
  mesh_.replace_vertices(t, corners[0], corners[1], corners[2]);
  mesh_.set_across(e, beside_a);
  mesh_.set_across(to_c, HalfEdge{u, from_c.edge});
  mesh_.set_constrained_flag(to_c, false);
  mesh_.move_leaving(b, to_c, {u, to_c.edge});
  grow_tree(side);
}

void Cutter::grow_tree(const Cut::Side& side) {
  const TriangleId t = side.e.triangle, u = side.second;
  Forest::Leaf& leaf = forest_.leaves_[t.index()];
  const std::uint32_t parent = leaf.node;
  const auto generation = static_cast<std::uint16_t>(forest_.pairs_[parent / 2].generation + 1);
  forest_.link(parent) = side.pair;
  forest_.cut(parent) = static_cast<std::uint8_t>(side.e.edge);
  forest_.pairs_[side.pair] = {
      parent, {t.value, u.value}, generation, {Forest::uncut, Forest::uncut}};
  leaf.node = 2 * side.pair;
  leaf.cut = side.next[0];
  leaf.state = Forest::State::idle;
  forest_.leaves_[u.index()] = {2 * side.pair + 1, Forest::none, side.next[1], Forest::State::idle};
}

void Cutter::prefetch(TriangleId t) const {
  mesh_.prefetch(t);
  lepp::prefetch(forest_.leaves_.data() + t.index());
}

// Each step looks at what the step before, some places ago, has asked for.
void Cutter::prefetch_for_plans(std::span<const TriangleId> list, std::size_t i) const {
  constexpr std::size_t step = 12;
  if (i + 3 * step < list.size()) prefetch(list[i + 3 * step]);
  if (i + 2 * step < list.size()) {
    const TriangleId t = list[i + 2 * step];
    for (const VertexId v : mesh_.vertices(t)) mesh_.prefetch(v);
    if (const auto across = across_cut(t)) prefetch(across->triangle);
  }
  if (i + step < list.size()) {
    if (const auto across = across_cut(list[i + step])) mesh_.prefetch(mesh_.apex(*across));
  }
}

void Cutter::prefetch_for_writes(std::span<const Cut> cuts, std::size_t i) const {
  constexpr std::size_t step = 8;
  if (i + 2 * step < cuts.size()) {
    for (const Cut::Side& side : cuts[i + 2 * step].both()) prefetch(side.e.triangle);
  }
  if (i + step >= cuts.size()) return;
  for (const Cut::Side& side : cuts[i + step].both()) {
    lepp::prefetch(&forest_.pairs_[forest_.leaves_[side.e.triangle.index()].node / 2]);
    mesh_.prefetch_leaving(mesh_.destination(side.e));
    if (const auto across = mesh_.twin(next_edge(side.e))) prefetch(across->triangle);
    if (const auto across = mesh_.twin(previous_edge(side.e))) prefetch(across->triangle);
  }
}

}  // namespace lepp

#include "lepp/terrain/terrain_mesh.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/refine/straight_walk.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/spatial_order.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"

namespace lepp {

namespace {

// A line is cut at a sample near a place in the middle part of it, so that none of the halves is a
// smaller part than `shortest_part`: where cells are long, the nearest sample can be its end.
constexpr double first_part = 0.35, shortest_part = 0.18;

// Where between a and b, from 0 to 1.
double part_of_way(Point a, Point b, Point p) { return dot(p - a, b - a) / squared_distance(a, b); }

bool lies_between(Point a, Point b, Point p, double near) {
  const double twice_area = cross(b - a, p - a), length = std::sqrt(squared_distance(a, b));
  const double along = part_of_way(a, b, p) * length;
  return std::abs(twice_area) <= near * length && along > near && along < length - near;
}

std::vector<std::uint32_t> inverse(const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> number_of(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    number_of[order[i]] = static_cast<std::uint32_t>(i);
  }
  return number_of;
}

template <class T>
void rearrange(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  std::vector<T> arranged;
  arranged.reserve(values.size());
  for (const std::uint32_t i : order) arranged.push_back(values[i]);
  values = std::move(arranged);
}

// A counting sort. The last corner, because the first ones may be those of the coarse levels.
std::vector<std::uint32_t> triangles_by_last_corner(const Mesh& mesh) {
  std::vector<std::uint32_t> begin(mesh.vertex_count() + 1, 0);
  const auto last = [](const Triangle& t) { return std::ranges::max(t.vertices).index(); };
  for (const Triangle& t : mesh.triangles()) ++begin[last(t) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> order(mesh.triangle_count());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[begin[last(mesh.triangles()[i])]++] = static_cast<std::uint32_t>(i);
  }
  return order;
}

}  // namespace

// What a scan passes over is all that insert() would refuse: corners of scans are moved to samples
// that they are at.
TerrainMesh::TerrainMesh(const HeightGrid& grid, Tin tin, double rounding)
    : grid_(grid),
      space_(grid),
      on_line_(std::max(2 * same_place, 4 * rounding)),
      scan_(grid, on_line_ + same_place * std::max(1.0, grid.aspect())) {
  state_.tin = std::move(tin);
  state_.kept.assign(mesh().vertex_count(), 0);
  if (!state_.tin.heights.empty()) rescan_all();
}

TerrainMesh::TerrainMesh(const HeightGrid& grid, const TerrainDomain& domain)
    : TerrainMesh(grid, Tin()) {
  HardTriangulation start =
      triangulate_lines(domain.pslg, domain.fixed_heights, domain.hard_segments);
  Tin& tin = state_.tin;
  tin = {std::move(start.mesh), std::move(start.heights), std::move(start.hard_segments)};
  for (std::size_t i = 0; i < tin.heights.size(); ++i) {
    if (std::isnan(tin.heights[i])) tin.heights[i] = height_of(mesh().point(VertexId(i)));
  }
  state_.kept.assign(mesh().vertex_count(), 0);
  for (std::size_t i = 0; i < domain.kept_border.size(); ++i) {
    const auto v = start.vertex_of_point[i];
    if (v && domain.kept_border[i]) state_.kept[v->index()] = 1;
  }
  rescan_all();
}

void TerrainMesh::scan_triangle(TriangleId t) {
  const auto& [a, b, c] = mesh().vertices(t);
  Sides hard = 0;
  for (std::uint32_t i = 0; i < 3; ++i) hard |= hard_side({t, i}, i);
  state_.worst[t.index()] = scan_.worst_or_bad({corner(a), corner(b), corner(c)}, enough_, hard);
}

void TerrainMesh::rescan(std::span<const TriangleId> changed) {
  state_.worst.resize(mesh().triangle_count());
  for (const TriangleId t : changed) scan_triangle(t);
}

void TerrainMesh::rescan_all() {
  state_.worst.resize(mesh().triangle_count());
  for (std::size_t t = 0; t < state_.worst.size(); ++t) scan_triangle(TriangleId(t));
}

void TerrainMesh::choose_diagonals(std::vector<TriangleId>& changed, double limit) {
  for (std::size_t k = 0; k < changed.size(); ++k) {  // ends: each flip lowers the larger error
    const TriangleId t = changed[k];
    if (!(error(t) > limit)) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{t, i};
      if (mesh().is_constrained(e)) continue;
      const TriangleId across = mesh().twin(e)->triangle;
      if (!choose_diagonal(e)) continue;
      changed.push_back(across);
      changed.push_back(t);
      break;
    }
  }
}

// Edge e leads from a to b, with apex c; beyond it d:
//
//      c           c            the two then have the corners c a d and d b c
//     / \         /|\ .
//    a-e-b  -->  a | b
//     \ /         \|/
//      d           d
std::array<TerrainMesh::Seen, 2> TerrainMesh::flipped(HalfEdge e) const {
  const HalfEdge f = *mesh().twin(e);
  const TerrainCorner a = corner(mesh().origin(e)), b = corner(mesh().destination(e));
  const TerrainCorner c = corner(mesh().apex(e)), d = corner(mesh().apex(f));
  const auto sides = [&](HalfEdge opposite_first, HalfEdge opposite_last) {
    return static_cast<Sides>(hard_side(opposite_first, 0) | hard_side(opposite_last, 2));
  };
  return {Seen{{c, a, d}, sides(next_edge(f), previous_edge(e))},
          Seen{{d, b, c}, sides(next_edge(e), previous_edge(f))}};
}

// Flips `e` if both diagonals are Delaunay and the other one is off less.
bool TerrainMesh::choose_diagonal(HalfEdge e) {
  const HalfEdge f = *mesh().twin(e);
  const Point a = mesh().point(mesh().origin(e)), b = mesh().point(mesh().destination(e));
  if (incircle(a, b, mesh().point(mesh().apex(e)), mesh().point(mesh().apex(f))) != 0) return false;
  const double now = std::max(error(e.triangle), error(f.triangle));
  const auto [one, other] = flipped(e);
  if (!scan_.is_within(one.corners, now, one.hard) ||
      !scan_.is_within(other.corners, now, other.hard)) {
    return false;
  }
  const double then = std::max(scan_.worst(one.corners, one.hard).error,
                               scan_.worst(other.corners, other.hard).error);
  if (!(then < now) || !is_flippable(mesh(), e)) return false;
  const TriangleId pair[] = {e.triangle, f.triangle};
  flip(mesh(), e);
  rescan(pair);
  return true;
}

double TerrainMesh::height_of(Point p) const {
  const Sample s = space_.nearest(p);
  if (SampleSpace::is_at(space_.corner(p, 0), s) && !std::isnan(space_.height(s))) {
    return space_.height(s);
  }
  return height_at(grid_, p);
}

Point TerrainMesh::clear_of_samples(Point p, double part) const {
  const Point sample = space_.place(space_.nearest(p));
  return in_supported_range({std::abs(p.x - sample.x) < part ? sample.x : p.x,
                             std::abs(p.y - sample.y) < part * grid_.aspect() ? sample.y : p.y});
}

std::optional<Point> TerrainMesh::sample_inside(HalfEdge e, double part) const {
  const Point a = mesh().point(mesh().origin(e)), b = mesh().point(mesh().destination(e));
  const Point near = snapped(a + std::clamp(part, first_part, 1 - first_part) * (b - a));
  const double at = part_of_way(a, b, near);
  if (at < shortest_part || at > 1 - shortest_part || orient2d(a, b, near) != 0) {
    return std::nullopt;
  }
  return near;
}

// An outline may lead from one side of the grid to another: its ends are kept, it is not.
bool TerrainMesh::may_cut(HalfEdge e) const {
  const VertexId from = mesh().origin(e), to = mesh().destination(e);
  if (!mesh().is_boundary(e) || state_.kept[from.index()] == 0 || state_.kept[to.index()] == 0) {
    return true;
  }
  const Point a = mesh().point(from), b = mesh().point(to);
  const Point corner = grid_.sample(grid_.columns - 1, grid_.rows - 1);
  const bool beside = a.x == b.x && (a.x == 0 || a.x == corner.x);
  const bool across = a.y == b.y && (a.y == 0 || a.y == corner.y);
  return !beside && !across;
}

bool TerrainMesh::may_cut_with_fan(HalfEdge e) const {
  if (!may_cut(e)) return false;
  for (const VertexId v : {mesh().origin(e), mesh().destination(e)}) {
    if (state_.kept[v.index()] == 0) continue;  // then no side that is kept ends there
    const Fan fan = fan_at(mesh(), e, v);
    if (!std::ranges::all_of(fan.edges, [&](HalfEdge f) { return may_cut(f); })) return false;
  }
  return true;
}

void TerrainMesh::add_heights() {
  for (std::size_t i = state_.tin.heights.size(); i < mesh().vertex_count(); ++i) {
    const VertexId v(i);
    const auto on_line = height_on_hard_line(state_.tin, v);
    state_.tin.heights.push_back(on_line ? *on_line : height_of(mesh().point(v)));
    state_.kept.push_back(0);
  }
}

bool TerrainMesh::insert(TriangleId t, Sample s, std::vector<TriangleId>& changed) {
  const Point p = space_.place(s);
  if (const auto e = constrained_edge_at(t, p)) return cut_at(*e, p, changed);
  if (!contains(mesh(), t, p)) {
    const WayEnd end = straight_walk(mesh(), t, p);
    if (end.barrier) return is_on(*end.barrier, p) && cut_at(*end.barrier, p, changed);
    t = end.triangle;
  }
  return insert_inside(t, p, changed);
}

bool TerrainMesh::insert_inside(TriangleId t, Point p, std::vector<TriangleId>& changed) {
  if (!cavity_.find(mesh(), t, p)) return false;
  cavity_.fill(mesh(), p, {VertexOrigin::Kind::interior, 0});
  changed.insert(changed.end(), cavity_.triangles().begin(), cavity_.triangles().end());
  add_heights();
  return true;
}

Removal TerrainMesh::remove(VertexId v, double limit) {
  std::optional<Removal> removed = remove_vertex(mesh(), v);
  assert(removed);
  Removal removal = std::move(*removed);
  const auto take_place = [&](auto& of_vertices) {
    of_vertices[v.index()] = of_vertices.back();
    of_vertices.pop_back();
  };
  take_place(state_.tin.heights);
  take_place(state_.kept);
  for (const auto& move : removal.moved_triangles) {
    state_.worst[move.to.index()] = state_.worst[move.from.index()];
  }
  rescan(removal.changed);
  choose_diagonals(removal.changed, limit);
  return removal;
}

void TerrainMesh::renumber(std::size_t first) {
  std::vector<std::uint32_t> order(first);
  std::iota(order.begin(), order.end(), 0U);
  for (const std::uint32_t i : spatial_order(mesh().points().subspan(first))) {
    order.push_back(static_cast<std::uint32_t>(first) + i);
  }
  rearrange(state_.tin.heights, order);
  rearrange(state_.kept, order);
  mesh().renumber_vertices(inverse(order));
  const std::vector<std::uint32_t> triangles = triangles_by_last_corner(mesh());
  rearrange(state_.worst, triangles);
  mesh().renumber_triangles(inverse(triangles));
}

std::optional<HalfEdge> TerrainMesh::constrained_edge_at(TriangleId t, Point p) const {
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (is_on({t, i}, p)) return HalfEdge{t, i};
  }
  return std::nullopt;
}

bool TerrainMesh::is_on(HalfEdge e, Point p) const {
  return mesh().is_constrained(e) && lies_between(mesh().point(mesh().origin(e)),
                                                  mesh().point(mesh().destination(e)), p, on_line_);
}

// A point beyond a side of the mesh, by rounding, would make it overlap what it touches there.
bool TerrainMesh::cut_at(HalfEdge e, Point p, std::vector<TriangleId>& changed) {
  if (!may_cut(e) || is_hard(e)) return false;
  const VertexId from = mesh().origin(e);
  const Point a = mesh().point(from), b = mesh().point(mesh().destination(e));
  if (can_split_edge(mesh(), e, p) && (!mesh().is_boundary(e) || orient2d(a, b, p) >= 0)) {
    const CurvePiece piece = piece_from(mesh(), e, from).piece;
    const double t = piece.t_a + (piece.t_b - piece.t_a) * part_of_way(a, b, p);
    const Insertion done = insert_on_edge(mesh(), e, p, origin_on(mesh(), e), t);
    changed.insert(changed.end(), done.changed.begin(), done.changed.end());
  } else {
    const auto split = split_at_distance(mesh(), e, from, std::sqrt(squared_distance(a, p)), 0);
    if (split.vertices.empty()) return false;
    changed.insert(changed.end(), split.changed.begin(), split.changed.end());
  }
  add_heights();
  return true;
}

}  // namespace lepp

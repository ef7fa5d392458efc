#include "lepp/triangulation/split_constrained.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"

namespace lepp {

namespace {

double length(const Mesh& mesh, HalfEdge e) {
  return std::sqrt(squared_distance(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e))));
}

// One point per edge suffices where every longer edge exceeds the shortest by this factor.
constexpr double clearly_longer = 1.4;

bool long_enough(const ConstrainedPiece& e, Point p, double floor) {
  const double least = std::min(squared_distance(e.piece.a, p), squared_distance(p, e.piece.b));
  return least >= floor * floor && least > 0;
}

ConstrainedSplit split_at(Mesh& mesh, HalfEdge e, const ConstrainedPiece& geometry,
                          CurvePoint on_curve, CurvePoint on_chord, double floor) {
  const auto cut = [&](Point p, double t) -> ConstrainedSplit {
    const Insertion done = insert_on_edge(mesh, e, p, origin_on(mesh, e), t);
    return {{done.vertex}, done.changed};
  };
  const auto can_cut = [&](Point p) { return long_enough(geometry, p, floor); };
  if (geometry.curve != nullptr) {
    const Point p = in_supported_range(on_curve.point);
    if (can_cut(p) && can_split_edge(mesh, e, p)) return cut(p, on_curve.t);
  }
  const auto p = point_near_chord(mesh, e, in_supported_range(on_chord.point),
                                  [&](Point q) { return can_split_edge(mesh, e, q); });
  return p && can_cut(*p) ? cut(*p, on_chord.t) : ConstrainedSplit{};
}

CurvePoint on_chord(const CurvePiece& piece, double s) {
  return {piece.a + s * (piece.b - piece.a), piece.t_a + s * (piece.t_b - piece.t_a)};
}

void append(ConstrainedSplit& all, const ConstrainedSplit& one) {
  all.vertices.insert(all.vertices.end(), one.vertices.begin(), one.vertices.end());
  all.changed.insert(all.changed.end(), one.changed.begin(), one.changed.end());
}

bool is_longer(const Mesh& mesh, double l, double radius, VertexId center) {
  return l > radius && !is_same_radius(l, radius, mesh.point(center));
}

// The radius at which a fan is cut when one of its edges, of length `wanted`, must be.
double fan_radius(const Mesh& mesh, const Fan& fan, double wanted) {
  double shortest = wanted;
  for (const HalfEdge e : fan.edges) shortest = std::min(shortest, length(mesh, e));
  const bool one_point =
      is_longer(mesh, wanted, shortest, fan.center) &&
      std::ranges::all_of(fan.edges, [&](HalfEdge e) {
        const double l = length(mesh, e);
        return !is_longer(mesh, l, shortest, fan.center) || l >= clearly_longer * shortest;
      });
  return one_point ? shortest : shortest / 2;
}

// A Steiner point cuts a segment in two: its edges leave in opposite directions.
bool can_be_sharp(const Mesh& mesh, VertexId v) { return mesh.is_input(v); }

enum class Turn { clockwise, counter_clockwise };

// The constrained edge that comes after constrained edge `e` around `center`, through the domain.
HalfEdge next_constrained(const Mesh& mesh, HalfEdge e, VertexId center, Turn turn) {
  const auto step = turn == Turn::clockwise ? next_edge : previous_edge;
  const bool arrives = mesh.destination(e) == center;
  HalfEdge here = arrives == (turn == Turn::clockwise) ? e : *mesh.twin(e);
  while (!mesh.is_constrained(step(here))) here = *mesh.twin(step(here));
  return step(here);
}

// Cutting an edge leaves the others of the fan constrained and in their order, so each is found
// from the one before it, on either side of the first that is cut.
ConstrainedSplit split_fan(Mesh& mesh, HalfEdge e, const Fan& fan, double floor) {
  const VertexId center = fan.center;
  const double radius = fan_radius(mesh, fan, length(mesh, e));
  const auto before = static_cast<std::size_t>(std::ranges::find(fan.edges, e) - fan.edges.begin());
  ConstrainedSplit all = split_at_distance(mesh, e, center, radius, floor);
  if (all.vertices.empty()) return all;
  const VertexId first = all.vertices.front();
  const auto cut = [&](std::size_t edges, Turn turn) {
    HalfEdge here = *mesh.find_edge(first, center);
    for (; edges > 0; --edges) {
      here = next_constrained(mesh, here, center, turn);
      if (!is_longer(mesh, length(mesh, here), radius, center)) continue;
      const ConstrainedSplit one = split_at_distance(mesh, here, center, radius, floor);
      append(all, one);
      if (!one.vertices.empty()) here = *mesh.find_edge(one.vertices.front(), center);
    }
  };
  cut(before, Turn::clockwise);
  cut(fan.edges.size() - before - 1, Turn::counter_clockwise);
  return all;
}

}  // namespace

ConstrainedPiece piece_from(const Mesh& mesh, HalfEdge e, VertexId from) {
  const VertexId to = mesh.origin(e) == from ? mesh.destination(e) : mesh.origin(e);
  const ConstrainedEdge& record = mesh.constrained_edge(e);
  ConstrainedPiece result;
  result.piece = {mesh.point(from), mesh.point(to), record.t_low, record.t_high};
  if (to < from) std::swap(result.piece.t_a, result.piece.t_b);
  if (const auto curve = mesh.curve_of(e);
      curve && !is_straight(mesh.entities()[*curve].geometry)) {
    result.curve = &mesh.entities()[*curve].geometry;
  }
  return result;
}

//     a --------- p ------- b     p lies a hair outside: one step along x, along y, or along both,
//            q   mesh             towards the mesh, leads to q; nothing that is not mesh joins it
//
std::optional<Point> point_near_chord(const Mesh& mesh, HalfEdge e, Point p,
                                      const std::function<bool(Point)>& fits) {
  const Point a = mesh.point(mesh.origin(e)), b = mesh.point(mesh.destination(e));
  if (!mesh.is_boundary(e)) return fits(p) ? std::optional(p) : std::nullopt;
  const auto does = [&](Point q) { return orient2d(a, b, q) >= 0 && fits(q); };
  if (does(p)) return p;
  constexpr int most_steps = 4;
  const auto ulp = [](double c, double d) { return 0x1p-53 * std::max(std::abs(c), std::abs(d)); };
  const Point step{std::copysign(ulp(a.x, b.x), a.y - b.y),
                   std::copysign(ulp(a.y, b.y), b.x - a.x)};
  for (int k = 1; k <= most_steps; ++k) {
    for (const Point move : {Point{step.x, 0}, Point{0, step.y}, step}) {
      const Point q = in_supported_range(p + static_cast<double>(k) * move);
      if (does(q)) return q;
    }
  }
  return std::nullopt;
}

ConstrainedSplit split_halfway(Mesh& mesh, HalfEdge e, double floor) {
  const ConstrainedPiece geometry = piece_from(mesh, e, mesh.origin(e));
  const CurvePoint chord{midpoint(geometry.piece.a, geometry.piece.b),
                         0.5 * (geometry.piece.t_a + geometry.piece.t_b)};
  const CurvePoint curve =
      geometry.curve == nullptr ? chord : halfway(*geometry.curve, geometry.piece);
  return split_at(mesh, e, geometry, curve, chord, floor);
}

ConstrainedSplit split_at_distance(Mesh& mesh, HalfEdge e, VertexId from, double radius,
                                   double floor) {
  const ConstrainedPiece geometry = piece_from(mesh, e, from);
  const CurvePoint chord = on_chord(geometry.piece, radius / length(mesh, e));
  const CurvePoint curve =
      geometry.curve == nullptr ? chord : at_distance(*geometry.curve, geometry.piece, radius);
  return split_at(mesh, e, geometry, curve, chord, floor);
}

ConstrainedSplit split_constrained_edge(Mesh& mesh, HalfEdge e, double floor) {
  const VertexId a = mesh.origin(e), b = mesh.destination(e);
  const Fan at_origin = can_be_sharp(mesh, a) ? fan_at(mesh, e, a) : Fan{a, {}};
  const Fan at_destination = can_be_sharp(mesh, b) ? fan_at(mesh, e, b) : Fan{b, {}};
  if (at_origin.exists() == at_destination.exists()) return split_halfway(mesh, e, floor);
  return split_fan(mesh, e, at_origin.exists() ? at_origin : at_destination, floor);
}

}  // namespace lepp

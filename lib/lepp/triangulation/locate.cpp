#include "lepp/triangulation/locate.hpp"

#include <algorithm>
#include <limits>

#include "lepp/geometry/place_on_segment.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/xorshift.hpp"
#include "lepp/triangulation/boundary_walk.hpp"
#include "lepp/triangulation/locator.hpp"
#include "lepp/triangulation/spatial_order.hpp"

namespace lepp {

namespace {

int side_of(const Mesh& mesh, HalfEdge e, Point p) {
  return orient2d(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)), p);
}

// The squared distance from p to edge e, rounded: it only says where to look first.
double squared_distance_to(const Mesh& mesh, HalfEdge e, Point p) {
  return nearest_place(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)), p)
      .squared_distance;
}

struct NearSide {
  HalfEdge side;
  double squared_distance = std::numeric_limits<double>::infinity();
};

// The edge nearest to p on the boundary loop of `start`; of two that share the nearest corner, the
// one that has p on its left.
NearSide nearest_side(const Mesh& mesh, HalfEdge start, Point p, LocateSteps& steps) {
  NearSide nearest;
  HalfEdge e = start;
  do {
    const double here = squared_distance_to(mesh, e, p);
    if (here < nearest.squared_distance ||
        (here == nearest.squared_distance && side_of(mesh, e, p) >= 0)) {
      nearest = {e, here};
    }
    e = next_side(mesh, e);
    ++steps.count;
  } while (e != start);
  return nearest;
}

// From wherever p is in the mesh, a straight way leads from the nearest place of a boundary loop to
// p without meeting that loop again. So each loop met next has a place that is nearer still.
std::optional<Location> walk_round_holes(const Mesh& mesh, Point p, TriangleId hint,
                                         LocateSteps& steps) {
  double nearest_yet = std::numeric_limits<double>::infinity();
  TriangleId start = hint;
  while (true) {  // ends: nearest_yet falls from turn to turn
    const WalkEnd end = walk(mesh, p, start, mesh.triangle_count(), steps);
    if (end.found) return location_in(mesh, end.triangle, p);
    if (!end.side) return std::nullopt;
    const NearSide nearest = nearest_side(mesh, *end.side, p, steps);
    if (!(nearest.squared_distance < nearest_yet)) return std::nullopt;
    nearest_yet = nearest.squared_distance;
    start = nearest.side.triangle;
  }
}

}  // namespace

bool contains(const Mesh& mesh, TriangleId t, Point p) {
  const auto [a, b, c] = mesh.corners(t);
  return orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0;
}

Location location_in(const Mesh& mesh, TriangleId t, Point p) {
  Location location{t, {}, {}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (side_of(mesh, {t, i}, p) == 0) location.on_edge = HalfEdge{t, i};
    if (mesh.point(mesh.vertex(t, i)) == p) location.at_vertex = mesh.vertex(t, i);
  }
  return location;
}

WalkEnd walk(const Mesh& mesh, Point p, TriangleId start, std::size_t most_steps,
             LocateSteps& steps) {
  XorShift random;
  WalkEnd end{start, false, {}};
  std::uint32_t entered_by = 3;  // p is known to be on the left of that edge
  for (std::size_t step = 0; step < most_steps; ++step) {
    ++steps.count;
    std::optional<HalfEdge> leave;
    const std::uint32_t first = random(3);
    for (std::uint32_t k = 0; k < 3 && !leave; ++k) {
      const HalfEdge e{end.triangle, (first + k) % 3};
      if (e.edge != entered_by && side_of(mesh, e, p) < 0) leave = e;
    }
    end.found = !leave;
    if (end.found) return end;
    const auto across = mesh.twin(*leave);
    if (!across) {
      end.side = leave;
      return end;
    }
    end.triangle = across->triangle;
    entered_by = across->edge;
  }
  return end;
}

std::optional<Location> locate(const Mesh& mesh, Point p, TriangleId hint, LocateSteps* steps) {
  LocateSteps own;
  LocateSteps& counted = steps != nullptr ? *steps : own;
  if (const auto found = walk_round_holes(mesh, p, hint, counted)) return found;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    ++counted.count;
    if (contains(mesh, TriangleId(t), p)) return location_in(mesh, TriangleId(t), p);
  }
  return std::nullopt;
}

std::vector<std::optional<Location>> locate(const Mesh& mesh, std::span<const Point> points,
                                            LocateSteps* steps) {
  LocateSteps own;
  LocateSteps& counted = steps != nullptr ? *steps : own;
  std::vector<std::optional<Location>> places(points.size());
  std::optional<Locator> locator;
  TriangleId hint(0U);
  for (const std::uint32_t i : spatial_order(points)) {
    const Point p = points[i];
    const WalkEnd end = walk(mesh, p, hint, mesh.triangle_count(), counted);
    if (end.found) {
      places[i] = location_in(mesh, end.triangle, p);
    } else {
      if (!locator) locator.emplace(mesh);
      places[i] = locator->locate(p, &counted);
    }
    if (places[i]) hint = places[i]->triangle;
  }
  return places;
}

}  // namespace lepp

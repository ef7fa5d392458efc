#include "lepp/triangulation/unfinished.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"

namespace lepp {

namespace {

// True if a side of `t` is an input segment shorter than `limit`, never cut.
bool has_whole_segment(const Mesh& mesh, TriangleId t, double limit) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    const VertexId a = mesh.origin(e), b = mesh.destination(e);
    if (!mesh.is_constrained(e) || !mesh.is_input(a) || !mesh.is_input(b)) continue;
    if (squared_distance(mesh.point(a), mesh.point(b)) < limit * limit) return true;
  }
  return false;
}

}  // namespace

std::string to_string(Reason reason) {
  switch (reason) {
    case Reason::input_angle:
      return "input_angle";
    case Reason::input_feature:
      return "input_feature";
    case Reason::size_floor:
      return "size_floor";
    case Reason::budget:
      return "budget";
    case Reason::cancelled:
      return "cancelled";
    case Reason::method:
      return "method";
    case Reason::kept_border:
      return "kept_border";
  }
  return {};
}

bool is_forced_by_input(Reason reason) {
  return reason == Reason::input_angle || reason == Reason::input_feature;
}

InputReasons::InputReasons(const Mesh& mesh)
    : mesh_(mesh),
      floor_(default_size_floor(mesh)),
      in_sharp_wedge_(corners_in_sharp_wedges(mesh)) {}

bool InputReasons::by_angle(TriangleId t) const {
  const bool in_wedge = (in_sharp_wedge_[t.index()] >> smallest_corner(mesh_, t) & 1U) != 0;
  return in_wedge || shortest_edge_is_seditious(mesh_, t);
}

bool InputReasons::by_feature(TriangleId t) const {
  return at_input_feature(mesh_, t, 2 * floor_) || has_whole_segment(mesh_, t, 2 * floor_);
}

std::optional<Reason> InputReasons::of(TriangleId t) const {
  if (by_angle(t)) return Reason::input_angle;
  if (by_feature(t)) return Reason::input_feature;
  return std::nullopt;
}

//          P     the angle at P is obtuse if Q lies beyond the perpendicular to OP at P, by
//   O------|     `beyond`; with equal sides Q lies before it, by |PQ|^2 / (2 |OP|)
//     -----Q
bool is_obtuse_by_rounding(const Mesh& mesh, TriangleId t) {
  if (!smallest_angle_between_constrained(mesh, t)) return false;
  const HalfEdge e{t, smallest_corner(mesh, t)};
  const Point o = mesh.point(mesh.apex(e));
  Point p = mesh.point(mesh.origin(e)), q = mesh.point(mesh.destination(e));
  if (is_obtuse(o, q, p)) std::swap(p, q);
  if (!is_obtuse(o, p, q)) return false;
  double largest = 0;
  for (const Point corner : {o, p, q}) {
    largest = std::max({largest, std::abs(corner.x), std::abs(corner.y)});
  }
  const double rounding = 4 * 0x1p-52 * largest, length = std::sqrt(squared_distance(o, p));
  const double beyond = -dot(o - p, q - p) / length;
  return squared_distance(p, q) <= 2 * rounding * length && beyond <= rounding;
}

double default_size_floor(const Mesh& mesh) {
  Point low = mesh.point(VertexId(0U)), high = low;
  for (const Point p : mesh.points()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double diagonal = std::sqrt(squared_distance(low, high));
  const double largest =
      std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
  return std::max(1e-12 * diagonal, 64 * 0x1p-52 * largest);
}

}  // namespace lepp

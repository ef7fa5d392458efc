#include "lepp/triangulation/unfinished.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/triangulation/sharp_vertex.hpp"

namespace lepp {

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

bool InputReasons::by_feature(TriangleId t) const { return at_input_feature(mesh_, t, 2 * floor_); }

std::optional<Reason> InputReasons::of(TriangleId t) const {
  if (by_angle(t)) return Reason::input_angle;
  if (by_feature(t)) return Reason::input_feature;
  return std::nullopt;
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

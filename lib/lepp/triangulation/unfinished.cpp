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
  }
  return {};
}

bool is_forced_by_input(Reason reason) {
  return reason == Reason::input_angle || reason == Reason::input_feature;
}

std::optional<Reason> reason_in_input(const Mesh& mesh, TriangleId t, double floor) {
  if (smallest_angle_in_sharp_wedge(mesh, t) || shortest_edge_is_seditious(mesh, t)) {
    return Reason::input_angle;
  }
  if (at_input_feature(mesh, t, 2 * floor)) return Reason::input_feature;
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

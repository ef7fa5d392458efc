#pragma once

#include <map>
#include <optional>

#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The heights that hard breaklines ask for, at their points and along them, in any TIN of a
/// domain.
class HardHeights {
 public:
  explicit HardHeights(const TerrainDomain& domain);

  bool is_at(Point p) const { return by_place_.contains(p); }
  /// The height asked for at a vertex, linear between the points of a line. Cost O(log points)
  /// \pre `mesh` is in grid space
  std::optional<double> at(const Mesh& mesh, VertexId v) const;

 private:
  std::optional<double> on(const Mesh& mesh, const Segment& s, Point p) const;

  std::map<Point, double> by_place_;
};

}  // namespace lepp

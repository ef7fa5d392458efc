#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lepp/refine/angle_test.hpp"
#include "lepp/refine/change_times.hpp"
#include "lepp/refine/good_star.hpp"
#include "lepp/refine/refine.hpp"

namespace lepp {

/// Takes Steiner points out of a refined mesh where every bound still holds without them.
class CleanUp {
 public:
  CleanUp(Mesh& mesh, const RefineOptions& options, double floor);

  /// Looks at each Steiner point once, the last one first, and removes it if the triangles that
  /// fill its star are good. With Effort::best it does more, and some of it where there is a
  /// largest angle, which leaves more to merge: else one vertex takes the place of it and a
  /// neighbour, if it has a good place; then all vertices move into the middle of their good
  /// places, and it begins again, until a round brings next to nothing.
  /// The mesh stays constrained Delaunay, and no triangle becomes bad.
  void run();

 private:
  bool may_go_on() const { return !options_.progress || options_.progress(mesh_.vertex_count()); }
  std::size_t remove_needless();
  void relax();
  bool can_do_without(VertexId v);
  bool is_needless_inside(const Star& star);
  bool is_needless_on_segment(VertexId v);
  bool is_good_fan(std::span<const Point> polygon, std::size_t from, SurfaceId region) const;
  bool merge_with_neighbour(VertexId v);
  void replace_both(VertexId v, VertexId w, Point p);
  TriangleId remove(VertexId v);

  Mesh& mesh_;
  const RefineOptions& options_;
  AngleTest angle_;
  SizeTest size_;
  bool merges_;
  GoodStar good_star_;
  ChangeTimes times_;
  Star star_;
  std::vector<Point> polygon_;
  Cavity cavity_;
  std::vector<TriangleId> changed_;
};

}  // namespace lepp

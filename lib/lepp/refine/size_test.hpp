#pragma once

#include <algorithm>
#include <vector>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/refine/size_field.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Tests triangles against the sizes that are asked for: longest edge and area, of all, by region,
/// and the longest edge by a field. The field is asked at the corners and at the centroid; the
/// least of the four counts, and of what RefineOptions::size_in says, and of the sizes of points in
/// the triangle that hold around them, if the field is a SizeField.
class SizeTest {
 public:
  SizeTest(const Mesh& mesh, const RefineOptions& options);

  /// False if no triangle can be too large.
  bool any() const { return any_; }
  bool is_too_large(TriangleId t) const {
    if (!any_) return false;
    const auto [a, b, c] = mesh_.corners(t);
    return is_too_large(a, b, c, mesh_.region(t));
  }
  /// The same for a triangle to come.
  bool is_too_large(Point a, Point b, Point c, SurfaceId region) const {
    if (!any_) return false;
    const Bound& limit = bound(region);
    const double longest =
        std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
    if (longest > limit.squared_edge || signed_area(a, b, c) > limit.area) return true;
    return has_field_ && longest > squared_size_in(a, b, c);
  }
  /// How many times too large, squared lengths or areas; at most 1 if it is not.
  double excess(Point a, Point b, Point c, SurfaceId region) const;

  /// The edge of the equilateral triangles to be made around `p`: small enough that triangles a
  /// little off that shape still keep the bounds. Infinite where no size is asked for.
  double wanted_edge(Point p, SurfaceId region) const;

  /// How many triangles of the wanted size triangle abc will need.
  double predicted_triangles(Point a, Point b, Point c, SurfaceId region) const;

 private:
  struct Bound {
    double squared_edge, area;
    double wanted_edge;  // as both ask for
  };
  static Bound make_bound(double edge, double area);
  const Bound& bound(SurfaceId region) const {
    return region.index() < by_region_.size() ? by_region_[region.index()] : everywhere_;
  }
  double field_at(Point p) const;
  static double checked(double size, Point p);
  double squared_size_in(Point a, Point b, Point c) const;

  const Mesh& mesh_;
  const RefineOptions& options_;
  const SizeField* points_ = nullptr;  // the field, if it is one of points
  bool any_ = false, has_field_ = false;
  Bound everywhere_;
  std::vector<Bound> by_region_;
  // What the field said lately: a vertex is asked about with each triangle around it.
  struct Answer {
    Point at;
    double size;
  };
  mutable std::vector<Answer> answers_;
};

}  // namespace lepp

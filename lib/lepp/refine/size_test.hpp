#pragma once

#include <algorithm>
#include <cmath>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Tests triangles against the sizes that are asked for: longest edge, area, area by region.
class SizeTest {
 public:
  SizeTest(const Mesh& mesh, const RefineOptions& options) : mesh_(mesh), options_(options) {
    const auto has_limit = [](const SurfaceEntity& s) { return std::isfinite(s.max_area); };
    any_ = std::isfinite(options.max_edge) || std::isfinite(options.max_area) ||
           std::ranges::any_of(mesh.entities().surfaces, has_limit);
  }

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
    const double longest =
        std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
    const double area = std::min(options_.max_area, mesh_.entities()[region].max_area);
    return longest > options_.max_edge * options_.max_edge || signed_area(a, b, c) > area;
  }

 private:
  const Mesh& mesh_;
  const RefineOptions& options_;
  bool any_ = false;
};

}  // namespace lepp

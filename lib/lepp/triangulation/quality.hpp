#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The figures of the paper's Tables 1 and 2, and what a finite-volume user counts.
struct Quality {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  double min_angle_deg = 0;
  double mean_min_angle_deg = 0;
  double mean_max_angle_deg = 0;
  double max_angle_deg = 0;

  /// A count decided exactly, and its twin that forgives 1e-9 degrees; exact >= tolerant.
  struct Count {
    std::size_t exact = 0;
    std::size_t tolerant = 0;
  };
  Count obtuse_triangles;    ///< triangles with an angle above 90 degrees
  Count obtuse_constrained;  ///< angles above 90 degrees opposite a constrained edge
  Count obtuse_boundary;     ///< those opposite an edge of one triangle
  Count non_delaunay_edges;  ///< edges of two triangles, not constrained, not locally Delaunay
  Count non_delaunay_constrained;  ///< the same for constrained edges of two triangles
};

/// Measures every triangle and edge once. \pre M1 to M3. Cost O(triangles).
Quality measure(const Mesh& mesh);

/// True if the smallest angle of `t` is below the bound, less 1e-9 degrees.
bool is_below(const Mesh& mesh, TriangleId t, double min_angle_deg);

/// Length of each curve entity and area of each surface entity, indexed by id.
struct EntityMeasures {
  std::vector<double> curve_lengths;
  std::vector<double> surface_areas;
};
EntityMeasures measure_entities(const Mesh& mesh);

/// Length, area or number of points of each physical group, indexed by GroupId.
/// An edge counts once per group, however many of its owners are in the group.
std::vector<double> measure_groups(const Mesh& mesh);

/// The area of the mesh, summed without cancellation.
double total_area(const Mesh& mesh);

}  // namespace lepp

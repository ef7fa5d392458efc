#pragma once

#include <span>
#include <vector>

#include "linear_system.hpp"

namespace lepp::demo {

/// A vertex at which two or more regions of high diffusion touch, and around it lower ones that
/// keep them apart: four quadrants of two materials in turn, for example.
struct CrossPoint {
  VertexId vertex;
  /// What lies between two interfaces, counter-clockwise around the vertex, the last one before the
  /// first.
  struct Sector {
    double begin = 0;  ///< direction, ascending; the first may be below 0
    double diffusion = 0;
  };
  std::vector<Sector> sectors;  ///< neighbours have different values
  /// Sectors with more than both neighbours, at least two; counter-clockwise from the highest one.
  std::vector<std::size_t> peaks;
};

/// \param diffusion  D > 0, indexed by region.  Cost O(triangles)
std::vector<CrossPoint> cross_points(const Mesh& mesh, std::span<const double> diffusion);

/// Functions of little energy near cross points that multigrid is slow to find: constant on each
/// peak but another constant on the next one, and where D is low, linear in the angle. In the
/// coarse spaces all peaks have the one value of the cross point, down to the size of the coarse
/// triangles. In the logarithm of the radius these functions are hats, one for each halving.
/// \param free  one per vertex: 0 where a value is given; the functions are 0 there
/// \return      a column for each, a row for each vertex; no columns if there is no cross point
/// Cost         O(triangles * (1 + cross points))
SparseMatrix cross_point_modes(const Mesh& mesh, std::span<const double> diffusion,
                               std::span<const char> free);

}  // namespace lepp::demo

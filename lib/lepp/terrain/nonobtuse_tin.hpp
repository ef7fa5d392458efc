#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "lepp/terrain/height_grid.hpp"
#include "lepp/terrain/tin.hpp"
#include "lepp/triangulation/unfinished.hpp"

namespace lepp {

/// Vertices between samples are rounded in world coordinates, which moves heights by this part of
/// their range at most: what the error may be off by.
inline constexpr double rounding_in_world = 1e-8;

struct NonobtuseTinOptions {
  double max_error = 0;  ///< to be kept, >= 0, but for rounding_in_world
  bool keep_error = true;
  double min_angle_deg = 30;
  std::size_t max_vertices = 0;  ///< 0: the default budget of refine()
  /// Called now and then with the number of vertices; false stops.
  std::function<bool(std::size_t vertices)> progress = {};
};

struct NonobtuseTin {
  Tin tin;        ///< in grid space
  Mesh in_world;  ///< the same in world coordinates
  /// True if angles were judged in world coordinates: what they say of the mesh holds there
  /// exactly. False where world coordinates have not the true proportions (degrees): then in grid
  /// space.
  bool judged_in_world = true;
  bool goal_reached = false;
  std::size_t rounds = 0;
  std::vector<Unfinished> unfinished;
};

/// Adds vertices to a TIN until no angle opposite a constrained edge is obtuse and every angle
/// reaches the bound, and until the error is kept all the same: refine() and the insertion of
/// samples that are off take turns. No vertex moves.
/// \param tin  of simplify() with the same grid
/// \pre   its mesh satisfies M1 to M6
NonobtuseTin make_nonobtuse(const HeightGrid& grid, Tin tin, const NonobtuseTinOptions& options);

}  // namespace lepp

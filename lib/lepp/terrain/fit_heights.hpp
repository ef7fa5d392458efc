#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "lepp/terrain/height_grid.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/terrain/tin.hpp"

namespace lepp {

struct FitOptions {
  /// No sample comes farther off than this, or than it was, and no vertex farther from its height.
  double max_error = 0;
  /// By vertex: its height stays. Empty: all may change.
  std::vector<bool> is_fixed = {};
  std::size_t max_sweeps = 30;
  /// Called once a sweep; false stops, which leaves a TIN within the bound.
  std::function<bool()> go_on = {};
};

/// Moves the heights of vertices, not their places, so that the root mean square of H - H* over all
/// samples with data becomes small: least squares under the bound on |H - H*|, vertex by vertex.
/// \param tin  in grid space; heights change
/// \return  how many sweeps over all vertices it took
/// Cost     O(samples) per sweep, three times that of measure_error(); mostly 5 to 15 sweeps
/// Source   docs/algorithms/terrain.md, "Heights that fit"
std::size_t fit_heights(const HeightGrid& grid, Tin& tin, const FitOptions& options);

/// The vertices of a TIN whose heights are others' to choose: those of hard breaklines, and those
/// on borders that a neighbour shares (TerrainDomain::kept_border).
std::vector<bool> fixed_vertices(const HeightGrid& grid, const TerrainDomain& domain,
                                 const Tin& tin);

}  // namespace lepp

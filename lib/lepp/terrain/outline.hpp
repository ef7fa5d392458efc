#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "lepp/terrain/height_grid.hpp"

namespace lepp {

/// A sample by its column and its line, lines counted from the south.
struct LatticePoint {
  std::uint32_t column = 0, line = 0;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// What the samples with data cover, as closed polygons with samples at their corners.
struct Outline {
  std::vector<LatticePoint> corners;  ///< each place once
  /// Directed, the covered area on the left: pairs of indices into `corners`, ring after ring.
  /// Rings touch in corners only, and never cross.
  std::vector<std::array<std::uint32_t, 2>> edges;
  /// Samples with data that no cell of three or four of them has as a corner, in order of lines.
  std::vector<LatticePoint> islands;
};

/// Covered are cells with four samples with data, and of cells with three their triangle; then
/// notches in the outline are filled where they hold no sample at all. So every sample with data is
/// covered, but for islands, none without data is, and no edge comes closer to an island than a
/// quarter of a cell along its column or its line.
/// Angles of the covered area are at least those of half a cell: 45 degrees where cells are square.
/// Cost  O(samples / 64 + n log n) for an outline through n samples, 40 bytes each
Outline outline_of(const HeightGrid& grid);

}  // namespace lepp

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lepp/terrain/terrain_domain.hpp"

namespace lepp {

/// The samples of a line that become vertices where the line is the border of a tile. They follow
/// from the heights of the line alone, so that two tiles, or two grids cut apart, agree on them
/// whatever lies beside the line: between two neighbours the straight line is off by `max_error` at
/// most, pieces side by side differ in length by a factor of 2 at most, and at both ends of a run
/// of samples with data pieces are one sample long, so that lines that meet in the corner of a tile
/// match in length.
/// \param heights  NaN where there is no data
/// \return  ascending indices; both ends of each run of samples with data are among them
/// Cost     O(n log n).
std::vector<std::uint32_t> border_samples(std::span<const float> heights, double max_error);

/// Makes the four sides of the grid borders: the domain gets the vertices of border_samples() on
/// them, and sides between two of them are not cut (TerrainDomain::kept_border).
void fix_borders(const HeightGrid& grid, double max_error, TerrainDomain& domain);

/// Where borders that must not be cut may be to blame for a small angle: nearer to one than the
/// piece of it there is long, because a vertex inside the circle around a piece would cut it.
class NearBorder {
 public:
  /// \param domain  after fix_borders()
  NearBorder(const HeightGrid& grid, const TerrainDomain& domain);
  bool operator()(Point p) const;

 private:
  std::array<std::vector<double>, 4> ends_;  // of pieces: on the west, east, south, north side
  Point corner_;                             // the north-eastern one
};

}  // namespace lepp

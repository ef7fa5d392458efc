#pragma once

#include <vector>

#include "lepp/terrain/terrain_domain.hpp"

namespace lepp {

/// What a segment of an arrangement comes from, by its curve.
enum class LineKind { outline, breakline, clip };

/// Outline, breaklines and clip polygons, cut wherever they meet: a PSLG without regions.
struct Arrangement {
  Pslg pslg;                   ///< each segment has a curve; curves have no bounds yet
  std::vector<LineKind> kind;  ///< of each curve; the outline is curve 0, then the breaklines
  /// Heights that hard breaklines ask for, one per point; NaN: none. Where two meet, the first one.
  std::vector<double> fixed_heights;
  std::vector<bool> hard_segments;  ///< one per segment: of a hard breakline
  std::size_t places_joined = 0;    ///< where lines were moved to meet
};

/// Puts lines beside an outline in grid space. Their points are moved to a column or a line of
/// samples that is within 2^-20 of a cell, so that a polygon along the rim leaves no sliver there;
/// then lines meet where they nearly do (snap_lines.hpp).
/// \param outline  a PSLG whose segments are all of curve 0
/// \throw InputError  naming the line or ring: a coordinate or height that is not finite, or far
///                    beyond the grid, heights that are not as many as the points, a ring of fewer
///                    than three places
Arrangement arrange(const HeightGrid& grid, const Pslg& outline, const DomainOptions& options);

}  // namespace lepp

#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lepp/geometry/pslg.hpp"
#include "lepp/terrain/height_grid.hpp"

namespace lepp {

/// What a hard line asks for at the ends of a segment, or nothing.
struct EndHeights {
  double a = std::numeric_limits<double>::quiet_NaN(), b = a;

  double at(double part) const { return part == 1 ? b : a + part * (b - a); }
};

/// Outline, breaklines and clip polygons in grid space while they are put together.
struct LineGraph {
  Pslg pslg;                        ///< each segment has a curve; that of the outline is 0
  std::vector<EndHeights> heights;  ///< one per segment
};

inline bool is_outline(const Segment& s) { return s.curve == CurveId(0U); }

/// Column and line of a place, if it is a sample's.
std::optional<std::pair<std::int64_t, std::int64_t>> sample_at(const HeightGrid& grid, Point p);

/// A part of a segment; parts run from 0 to 1. Its heights are those along the segment.
void add_piece(LineGraph& graph, VertexId a, VertexId b, CurveId curve, const EndHeights& heights,
               double part_a, double part_b);

/// The samples on a slanting segment of the outline on either side of a cut at `part` of it, by
/// parts: a cut is rounded, and may bend a piece away from samples on it, unless it has none.
std::vector<std::pair<double, Point>> samples_beside(const HeightGrid& grid, Point a, Point b,
                                                     double part);

/// Cuts segments wherever they meet, slanting ones of the outline also at the samples beside.
/// Pieces without length and points without a segment go.
void cut_where_lines_meet(const HeightGrid& grid, LineGraph& graph);

}  // namespace lepp

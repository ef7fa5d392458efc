#pragma once

#include <vector>

#include "lepp/geometry/pslg.hpp"

namespace lepp {

/// A PSLG whose segments meet only at common ends, and how it came about.
struct SplitPslg {
  /// The points of the input, unmoved and in their order, then the new ones; the pieces of the
  /// segments in the order of the input, each with curve, curve parameters and
  /// Pslg::segment_numbers of its segment.
  Pslg pslg;
  std::vector<SegmentId> segment_of;   ///< for each piece the segment of the input it is part of
  std::size_t crossings_split = 0;     ///< points added where segments cross
  std::size_t points_on_segments = 0;  ///< cuts at points that were there before
  int rounds = 0;                      ///< how often segments were cut; 0 if none needed it
};

/// Cuts segments wherever two meet and wherever a point lies on one.
///
/// A crossing becomes a point, rounded to the nearest double, so the pieces are not exactly
/// straight; what that makes cross, or pass within rounding of a point, is cut there again, until
/// an exact check finds nothing. Points of the input never move. Pieces of different segments may
/// coincide: both stay. Duplicate points and segments of zero length stay as they are.
///
/// \pre     P1 and P2
/// \return  a PSLG in which no segment passes through a point and any two share ends only, or
///          both
/// \throw   InputError naming both segments if they still cross after 32 rounds; RefusedError as
///          find_segment_meetings()
/// Cost     that of find_segment_meetings() per round; rarely more than three rounds
/// Source   the hot pixels of [hobby1999]; docs/algorithms/crossings.md
SplitPslg split_crossings(const Pslg& pslg);

}  // namespace lepp

#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "lepp/geometry/pslg.hpp"
#include "lepp/geometry/segment_intersection.hpp"

namespace lepp {

/// Two segments that meet elsewhere than at a common end: touching, crossing or overlapping.
struct SegmentPair {
  SegmentId first, second;  ///< first < second
  SegmentMeeting meeting;
  friend bool operator==(const SegmentPair&, const SegmentPair&) = default;
};

/// A point that is no end of a segment (but of one of zero length) and lies on one.
struct PointOnSegment {
  VertexId point;
  SegmentId segment;
  friend auto operator<=>(const PointOnSegment&, const PointOnSegment&) = default;
};

/// Everything that P3 and P4 forbid (pslg.hpp), decided exactly, each list in order of ids.
/// A point stands for all points with its coordinates, and a segment for all that join the same
/// two places: `pairs` and `points_on_segments` name the first copy only.
struct SegmentMeetings {
  std::vector<std::pair<VertexId, VertexId>> duplicate_points;     ///< (first copy, a later one)
  std::vector<SegmentId> zero_length;                              ///< both ends at one place
  std::vector<std::pair<SegmentId, SegmentId>> repeated_segments;  ///< (first copy, a later one)
  std::vector<SegmentPair> pairs;
  std::vector<PointOnSegment> points_on_segments;

  bool none() const;  ///< true if every list is empty: P3 and P4 hold
};

/// The largest number of `pairs` and `points_on_segments` together; while they are looked for, up
/// to twice as many stand in memory, 12 bytes each.
inline constexpr std::size_t most_meetings = 25'000'000;

/// Finds them all.
/// \pre     P1 and P2
/// \throw   RefusedError if `pairs` and `points_on_segments` together are more than `most`
/// Cost     O(n log n + what is found) in practice; near_pairs.hpp. A million segments of a coast
///          line take about a second.
SegmentMeetings find_segment_meetings(const Pslg& pslg, std::size_t most = most_meetings);

/// What validate() says of a PSLG, and what it looked at.
struct PslgFindings {
  std::vector<PslgViolation> violations;    ///< as validate() returns them
  std::optional<SegmentMeetings> meetings;  ///< nothing if P1 or P2 is broken
};

/// For those who want both: what costs time is done once.
PslgFindings examine(const Pslg& pslg);

/// For each point the first one at the same place, itself if it is that.
std::vector<VertexId> first_copies(const std::vector<Point>& points);

/// A point that both segments of the pair have in common: the end of one that lies on the other,
/// or the rounded crossing.
Point meeting_point(const Pslg& pslg, const SegmentPair& pair);

}  // namespace lepp

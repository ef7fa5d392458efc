#pragma once

#include <algorithm>

#include "lepp/geometry/segment_meetings.hpp"

namespace lepp::test {

/// find_segment_meetings() by comparing each with each: the oracle. Cost O(n^2)
inline SegmentMeetings plain_meetings(const Pslg& pslg) {
  SegmentMeetings found;
  const auto at = [&](VertexId v) { return pslg.points[v.index()]; };
  const std::size_t n = pslg.points.size(), m = pslg.segments.size();
  std::vector<bool> is_copy(n, false), is_end(n, false), skip(m, false);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i && !is_copy[i]; ++j) {
      if (pslg.points[i] != pslg.points[j]) continue;
      is_copy[i] = true;
      found.duplicate_points.emplace_back(j, i);
    }
  }
  for (std::size_t i = 0; i < m; ++i) {
    const Point a = at(pslg.segments[i].a), b = at(pslg.segments[i].b);
    if (a == b) found.zero_length.emplace_back(i);
    skip[i] = a == b;
    for (std::size_t j = 0; j < i && !skip[i]; ++j) {
      const Point c = at(pslg.segments[j].a), d = at(pslg.segments[j].b);
      if (std::minmax(a, b) != std::minmax(c, d)) continue;
      skip[i] = true;
      found.repeated_segments.emplace_back(j, i);
    }
    if (skip[i]) continue;
    for (std::size_t v = 0; v < n; ++v) {
      if (pslg.points[v] == a || pslg.points[v] == b) is_end[v] = true;
    }
  }
  for (std::size_t i = 0; i < m; ++i) {
    const Point a = at(pslg.segments[i].a), b = at(pslg.segments[i].b);
    for (std::size_t j = i + 1; j < m && !skip[i]; ++j) {
      if (skip[j]) continue;
      const auto meeting = segments_meet(a, b, at(pslg.segments[j].a), at(pslg.segments[j].b));
      if (meeting == SegmentMeeting::apart || meeting == SegmentMeeting::at_shared_end) continue;
      found.pairs.push_back({SegmentId(i), SegmentId(j), meeting});
    }
    for (std::size_t v = 0; v < n && !skip[i]; ++v) {
      if (is_copy[v] || is_end[v] || !is_on_segment(pslg.points[v], a, b)) continue;
      found.points_on_segments.push_back({VertexId(v), SegmentId(i)});
    }
  }
  std::ranges::sort(found.points_on_segments);
  return found;
}

}  // namespace lepp::test

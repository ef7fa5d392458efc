#pragma once

#include <vector>

#include "lepp/geometry/pslg.hpp"

namespace lepp {

/// The way from one vertex to the next that leads through a third.
struct Detour {
  VertexId from, to, through;
};

/// An input segment and the vertices it has to pass, in order, without its ends. The lists only
/// grow, and where a vertex lies along the segment is asked of the unmoved segment: so no chain
/// folds back or crosses itself, and rounds cannot go in a circle. Where two tracks pass the four
/// corners of one pixel's width in orders that cross, one of them takes a detour.
struct Track {
  SegmentId segment;
  std::vector<VertexId> passes;
  std::vector<Detour> detours;
};

/// The vertices of a track from end to end, each once: a detour through a vertex that the track has
/// anyway cuts out the loop between the two visits.
/// \param s  the segment of the track
/// Cost  O(vertices) for each detour
std::vector<VertexId> chain(const Track& track, const Segment& s);

}  // namespace lepp

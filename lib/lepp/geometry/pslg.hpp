#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lepp/geometry/entities.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/geometry/ids.hpp"
#include "lepp/geometry/point.hpp"

namespace lepp {

/// The supported range: a coordinate is 0 or between these two in absolute value. Inside it no
/// product of the exact predicates can over- or underflow (predicates.cpp says why).
inline constexpr double min_coordinate = 0x1p-140;
inline constexpr double max_coordinate = 0x1p+200;

/// An input edge that the mesh must contain as a chain of edges.
struct Segment {
  VertexId a, b;
  std::optional<CurveId> curve;  ///< the input curve it is a piece of
  double t_a = 0, t_b = 1;       ///< parameters of a and b on that curve
};

/// Everything inside the same closed area as `at` belongs to `surface`.
struct RegionSeed {
  Point at;
  SurfaceId surface;
};

/// A planar straight-line graph: what is to be meshed.
///
/// The domain is found in one of three ways, in this order:
///  - if a curve has `bounds`, a place belongs to the surfaces it is inside of; outside all of
///    them there is no mesh, and inside two of them is an error;
///  - else, if the segments close off an area, everything the outside can reach without crossing
///    a segment is removed, then every area that holds a hole point;
///  - else (no closed area) the domain is the convex hull.
struct Pslg {
  std::vector<Point> points;
  std::vector<Segment> segments;
  std::vector<Point> holes;
  std::vector<RegionSeed> seeds;
  Entities entities;

  std::string source;     ///< what messages call this input, for example the file's name
  std::int64_t base = 0;  ///< number of the first point, segment, hole and seed in messages
  /// The user's numbers of the points, if they are not base, base + 1, ...
  std::vector<std::int64_t> point_numbers;
  /// Likewise of the segments; pieces of one segment share its number.
  std::vector<std::int64_t> segment_numbers;

  std::int64_t point_number(VertexId v) const;
  std::int64_t segment_number(SegmentId s) const;
  /// What messages call a segment: "segment 5", or "curve 7" where it is a piece of a curve that
  /// the user drew (a curve with bounds or a shape).
  std::string segment_name(SegmentId s) const;
  /// True if a curve has `bounds`, so that surfaces are known by their boundaries.
  bool has_bounded_surfaces() const;
};

/// A PSLG from plain arrays.
/// \param coordinates  x0 y0 x1 y1 ..., in one length unit
/// \param segments     pairs of point indices, from 0
/// \param tags         one per segment, or empty; equal tags make one curve, 0 means no curve
/// \throw InputError   on an odd length, an index out of range, or as many tags as segments missing
Pslg pslg_from_arrays(std::span<const double> coordinates, std::span<const std::uint32_t> segments,
                      std::span<const int> tags = {});

/// One broken rule of an input: P1 finite and in range, P2 ids valid, P3 no duplicate point,
/// P4 segments meet only at shared ends.
struct PslgViolation {
  std::string rule;   ///< "P1" ... "P4"
  std::string where;  ///< with the user's numbers
};

/// All of P1 to P4; P3 and P4 as find_segment_meetings() finds them (segment_meetings.hpp).
/// constrained_delaunay() needs P1 and P2 only: it merges, splits and reports the rest.
/// \return  the broken rules, empty for a clean PSLG.
///          Where P1 or P2 is broken, the first offender alone is returned.
/// Cost     O(n log n + broken rules) in practice
std::vector<PslgViolation> validate(const Pslg& pslg);

/// The first pair of segments, by ids, that meet elsewhere than at a common end. \pre P1, P2
std::optional<std::pair<SegmentId, SegmentId>> first_bad_meeting(const Pslg& pslg);

/// P1 and P2 alone. \throw InputError naming the first offender
void check_ids_and_range(const Pslg& pslg);

/// The part of P2 inside the entities: groups, bounds and the vertices of point entities exist.
/// \throw InputError naming the entity
void check_entities(const Entities& entities, std::size_t points, const std::string& source);

}  // namespace lepp

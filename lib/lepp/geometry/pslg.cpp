#include "lepp/geometry/pslg.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "lepp/geometry/segment_meetings.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

bool in_range(double c) {
  return c == 0 || (std::abs(c) >= min_coordinate && std::abs(c) <= max_coordinate);
}

bool in_range(Point p) { return in_range(p.x) && in_range(p.y); }

std::string coordinate_problem(double c) {
  if (!std::isfinite(c)) return "coordinate " + to_text(c) + " is not a finite number";
  return "coordinate " + to_text(c) + " is outside the supported range, 0 or " +
         to_text(min_coordinate) + " to " + to_text(max_coordinate) + " in absolute value";
}

void check_place(const Pslg& pslg, Point p, const std::string& what) {
  for (const double c : {p.x, p.y}) {
    if (!in_range(c)) {
      throw InputError(pslg.source + ", " + what, coordinate_problem(c),
                       "correct the coordinate, or scale and shift the whole input");
    }
  }
}

// Puts every broken rule into words, with the user's numbers.
std::vector<PslgViolation> in_words(const Pslg& pslg, const SegmentMeetings& found) {
  const auto point = [&](VertexId v) { return std::to_string(pslg.point_number(v)); };
  const auto segment = [&](SegmentId s) { return std::to_string(pslg.segment_number(s)); };
  std::vector<PslgViolation> words;
  for (const auto& [first, copy] : found.duplicate_points) {
    words.push_back({"P3", "points " + point(first) + " and " + point(copy) + " are both at " +
                               to_text(pslg.points[copy.index()])});
  }
  for (const SegmentId s : found.zero_length) {
    words.push_back({"P4", "segment " + segment(s) + " has both ends at " +
                               to_text(pslg.points[pslg.segments[s.index()].a.index()])});
  }
  for (const auto& [first, copy] : found.repeated_segments) {
    words.push_back(
        {"P4", "segments " + segment(first) + " and " + segment(copy) + " have the same ends"});
  }
  for (const SegmentPair& pair : found.pairs) {
    words.push_back({"P4", "segments " + segment(pair.first) + " and " + segment(pair.second) +
                               " " + describe(pair.meeting) + " at " +
                               to_text(meeting_point(pslg, pair))});
  }
  for (const auto& [v, s] : found.points_on_segments) {
    words.push_back({"P4", "point " + point(v) + " lies on segment " + segment(s) + " at " +
                               to_text(pslg.points[v.index()])});
  }
  return words;
}

}  // namespace

std::int64_t Pslg::point_number(VertexId v) const {
  return v.index() < point_numbers.size() ? point_numbers[v.index()]
                                          : base + static_cast<std::int64_t>(v.index());
}

std::int64_t Pslg::segment_number(SegmentId s) const {
  return s.index() < segment_numbers.size() ? segment_numbers[s.index()]
                                            : base + static_cast<std::int64_t>(s.index());
}

std::string Pslg::segment_name(SegmentId s) const {
  const auto& curve = segments[s.index()].curve;
  if (curve && (!entities[*curve].bounds.empty() || !is_straight(entities[*curve].geometry))) {
    return "curve " + std::to_string(entities[*curve].tag);
  }
  return "segment " + std::to_string(segment_number(s));
}

bool Pslg::has_bounded_surfaces() const {
  return std::ranges::any_of(entities.curves, [](const auto& c) { return !c.bounds.empty(); });
}

Pslg pslg_from_arrays(std::span<const double> coordinates, std::span<const std::uint32_t> segments,
                      std::span<const int> tags) {
  Pslg pslg;
  pslg.source = "arrays";
  if (coordinates.size() % 2 != 0) {
    throw InputError("coordinates", "odd length " + std::to_string(coordinates.size()),
                     "give x and y for each point");
  }
  if (segments.size() % 2 != 0 || (!tags.empty() && tags.size() != segments.size() / 2)) {
    throw InputError(
        "segments",
        std::to_string(segments.size()) + " indices and " + std::to_string(tags.size()) + " tags",
        "give two point indices per segment, and one tag per segment or none");
  }
  for (std::size_t i = 0; i < coordinates.size(); i += 2) {
    pslg.points.push_back({coordinates[i], coordinates[i + 1]});
  }
  std::map<int, CurveId> curve_of_tag;
  for (std::size_t i = 0; i < segments.size() / 2; ++i) {
    Segment segment{VertexId(segments[2 * i]), VertexId(segments[2 * i + 1]), {}, 0, 1};
    if (const int tag = tags.empty() ? 0 : tags[i]; tag != 0) {
      const auto [known, is_new] = curve_of_tag.try_emplace(tag, pslg.entities.curves.size());
      if (is_new) pslg.entities.curves.push_back({tag, {}, StraightCurve{}, {}});
      segment.curve = known->second;
    }
    pslg.segments.push_back(segment);
  }
  check_ids_and_range(pslg);
  return pslg;
}

std::optional<std::pair<SegmentId, SegmentId>> first_bad_meeting(const Pslg& pslg) {
  const SegmentMeetings found = find_segment_meetings(pslg);
  std::optional<std::pair<SegmentId, SegmentId>> first;
  const auto offer = [&](SegmentId r, SegmentId s) {
    if (!first || std::pair(r, s) < *first) first = {r, s};
  };
  for (const SegmentPair& pair : found.pairs) offer(pair.first, pair.second);
  for (const auto& [r, s] : found.repeated_segments) offer(r, s);
  return first;
}

void check_ids_and_range(const Pslg& pslg) {
  check_entities(pslg.entities, pslg.points.size(), pslg.source);
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    if (in_range(pslg.points[i])) continue;
    check_place(pslg, pslg.points[i], "point " + std::to_string(pslg.point_number(VertexId(i))));
  }
  for (std::size_t i = 0; i < pslg.holes.size(); ++i) {
    check_place(pslg, pslg.holes[i],
                "hole " + std::to_string(pslg.base + static_cast<std::int64_t>(i)));
  }
  for (std::size_t i = 0; i < pslg.seeds.size(); ++i) {
    check_place(pslg, pslg.seeds[i].at,
                "region " + std::to_string(pslg.base + static_cast<std::int64_t>(i)));
    if (pslg.seeds[i].surface.index() >= pslg.entities.surfaces.size()) {
      throw InputError(pslg.source + ", region seed " + std::to_string(i), "its surface is missing",
                       "add the surface to Pslg::entities");
    }
  }
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
    const Segment& s = pslg.segments[i];
    const bool has_curve = !s.curve || s.curve->index() < pslg.entities.curves.size();
    const std::size_t points = pslg.points.size();
    if (s.a.index() < points && s.b.index() < points && has_curve) continue;
    const std::string where =
        pslg.source + ", segment " + std::to_string(pslg.segment_number(SegmentId(i)));
    if (!has_curve) {
      throw InputError(where, "its curve is missing", "add the curve to Pslg::entities");
    }
    const VertexId v = s.a.index() < points ? s.b : s.a;
    throw InputError(
        where, "point index " + std::to_string(v.value) + " is out of range",
        "there are " + std::to_string(points) + " points, counted from 0 in this array");
  }
}

void check_entities(const Entities& entities, std::size_t points, const std::string& source) {
  const auto require = [&](bool holds, const std::string& who, int tag, const std::string& what) {
    if (holds) return;
    throw InputError(source + ", " + who + " " + std::to_string(tag), what + " that does not exist",
                     "add it to Entities, or correct the id");
  };
  const auto check_groups = [&](const std::string& who, const auto& list) {
    for (const auto& entity : list) {
      for (const GroupId g : entity.groups) {
        require(g.index() < entities.groups.size(), who, entity.tag, "is in a group");
      }
    }
  };
  check_groups("point", entities.points);
  check_groups("curve", entities.curves);
  check_groups("surface", entities.surfaces);
  for (const PointEntity& point : entities.points) {
    require(point.vertex.index() < points, "point", point.tag, "is at a vertex");
  }
  for (const CurveEntity& curve : entities.curves) {
    for (const SurfaceId s : curve.bounds) {
      require(s.index() < entities.surfaces.size(), "curve", curve.tag, "bounds a surface");
    }
  }
}

std::vector<PslgViolation> validate(const Pslg& pslg) { return examine(pslg).violations; }

PslgFindings examine(const Pslg& pslg) {
  try {
    check_ids_and_range(pslg);
  } catch (const InputError& error) {
    const bool range = error.problem().starts_with("coordinate");
    return {{{range ? "P1" : "P2", error.where() + ": " + error.problem()}}, {}};
  }
  SegmentMeetings found = find_segment_meetings(pslg);
  return {in_words(pslg, found), std::move(found)};
}

}  // namespace lepp

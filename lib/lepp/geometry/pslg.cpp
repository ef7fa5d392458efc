#include "lepp/geometry/pslg.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "lepp/geometry/segment_intersection.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

bool in_range(double c) {
  return c == 0 || (std::abs(c) >= min_coordinate && std::abs(c) <= max_coordinate);
}

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

void find_duplicate_points(const Pslg& pslg, std::vector<PslgViolation>& found) {
  std::vector<std::size_t> order(pslg.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    return std::pair(pslg.points[i], i) < std::pair(pslg.points[j], j);
  });
  for (std::size_t k = 1; k < order.size(); ++k) {
    const VertexId a(order[k - 1]), b(order[k]);
    if (pslg.points[a.index()] != pslg.points[b.index()]) continue;
    found.push_back({"P3", "points " + std::to_string(pslg.point_number(a)) + " and " +
                               std::to_string(pslg.point_number(b)) + " are both at " +
                               to_text(pslg.points[a.index()])});
  }
}

struct Box {
  Point low, high;
};

Box box_of(Point a, Point b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

SegmentMeeting meeting_of(const Pslg& pslg, SegmentId r, SegmentId s) {
  const auto ends = [&](SegmentId id) {
    const Segment& segment = pslg.segments[id.index()];
    return std::pair(pslg.points[segment.a.index()], pslg.points[segment.b.index()]);
  };
  const auto [a, b] = ends(r);
  const auto [c, d] = ends(s);
  return segments_meet(a, b, c, d);
}

// Calls visit(r, s, meeting) for each pair that meets elsewhere than at a common end, until visit
// says false. A sweep from left to right over bounding boxes.
template <class Visit>
void for_each_bad_meeting(const Pslg& pslg, Visit visit) {
  std::vector<Box> boxes;
  for (const Segment& s : pslg.segments) {
    boxes.push_back(box_of(pslg.points[s.a.index()], pslg.points[s.b.index()]));
  }
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    return std::pair(boxes[i].low.x, i) < std::pair(boxes[j].low.x, j);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Box& box = boxes[order[i]];
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].low.x <= box.high.x; ++j) {
      if (!overlap(box, boxes[order[j]])) continue;
      const auto [first, second] = std::minmax(order[i], order[j]);
      const SegmentId r(first), s(second);
      const SegmentMeeting meeting = meeting_of(pslg, r, s);
      if (meeting == SegmentMeeting::apart || meeting == SegmentMeeting::at_shared_end) continue;
      if (!visit(r, s, meeting)) return;
    }
  }
}

void check_segment_pairs(const Pslg& pslg, std::vector<PslgViolation>& found) {
  for_each_bad_meeting(pslg, [&](SegmentId r, SegmentId s, SegmentMeeting meeting) {
    found.push_back({"P4", "segments " + std::to_string(pslg.segment_number(r)) + " and " +
                               std::to_string(pslg.segment_number(s)) + " " + describe(meeting)});
    return true;
  });
}

void check_points_on_segments(const Pslg& pslg, std::vector<PslgViolation>& found) {
  std::vector<bool> is_end(pslg.points.size(), false);
  for (const Segment& s : pslg.segments) is_end[s.a.index()] = is_end[s.b.index()] = true;
  std::vector<VertexId> lone;
  for (std::size_t i = 0; i < is_end.size(); ++i) {
    if (!is_end[i]) lone.emplace_back(i);
  }
  std::ranges::sort(lone, {}, [&](VertexId v) { return pslg.points[v.index()]; });
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
    const Segment& s = pslg.segments[i];
    const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
    const auto [low, high] = std::minmax(a, b);
    const auto at = [&](VertexId v) { return pslg.points[v.index()]; };
    const auto first = std::ranges::lower_bound(lone, low, {}, at);
    for (auto v = first; v != lone.end() && at(*v) <= high; ++v) {
      if (!is_on_segment(at(*v), a, b)) continue;
      found.push_back({"P4", "point " + std::to_string(pslg.point_number(*v)) +
                                 " lies on segment " +
                                 std::to_string(pslg.segment_number(SegmentId(i)))});
    }
  }
}

}  // namespace

std::int64_t Pslg::point_number(VertexId v) const {
  return v.index() < point_numbers.size() ? point_numbers[v.index()]
                                          : base + static_cast<std::int64_t>(v.index());
}

std::int64_t Pslg::segment_number(SegmentId s) const {
  return base + static_cast<std::int64_t>(s.index());
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
  std::optional<std::pair<SegmentId, SegmentId>> found;
  for_each_bad_meeting(pslg, [&](SegmentId r, SegmentId s, SegmentMeeting) {
    found = {r, s};
    return false;
  });
  return found;
}

void check_ids_and_range(const Pslg& pslg) {
  check_entities(pslg.entities, pslg.points.size(), pslg.source);
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
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
    const std::string where =
        pslg.source + ", segment " + std::to_string(pslg.segment_number(SegmentId(i)));
    for (const VertexId v : {s.a, s.b}) {
      if (v.index() >= pslg.points.size()) {
        throw InputError(where, "point index " + std::to_string(v.value) + " is out of range",
                         "there are " + std::to_string(pslg.points.size()) +
                             " points, counted from 0 in this array");
      }
    }
    if (s.curve && s.curve->index() >= pslg.entities.curves.size()) {
      throw InputError(where, "its curve is missing", "add the curve to Pslg::entities");
    }
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

std::vector<PslgViolation> validate(const Pslg& pslg) {
  try {
    check_ids_and_range(pslg);
  } catch (const InputError& error) {
    const bool range = error.problem().starts_with("coordinate");
    return {{range ? "P1" : "P2", error.where() + ": " + error.problem()}};
  }
  std::vector<PslgViolation> found;
  find_duplicate_points(pslg, found);
  check_segment_pairs(pslg, found);
  check_points_on_segments(pslg, found);
  return found;
}

}  // namespace lepp

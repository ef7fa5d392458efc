#include "lepp/triangulation/sharp_vertex.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/triangulation/lepp.hpp"

namespace lepp {

namespace {

VertexId other_end(const Mesh& mesh, HalfEdge e, VertexId v) {
  return mesh.origin(e) == v ? mesh.destination(e) : mesh.origin(e);
}

// The next constrained edge at `center` counter-clockwise from e = center -> u, through triangles:
//
//         w      e is seen from the triangle on its left; the edge that comes back to the center
//        /       is seen from there too (w -> center)
//   center --e-- u
HalfEdge next_constrained(const Mesh& mesh, HalfEdge e) {
  HalfEdge back = previous_edge(e);
  while (!mesh.is_constrained(back)) back = previous_edge(*mesh.twin(back));
  return back;
}

// The same clockwise from e = u -> center, as the half-edge that leaves the center.
HalfEdge previous_constrained(const Mesh& mesh, HalfEdge e) {
  HalfEdge out = next_edge(e);
  while (!mesh.is_constrained(out)) out = next_edge(*mesh.twin(out));
  return out;
}

bool wedge_below(const Mesh& mesh, VertexId center, VertexId u, VertexId w,
                 bool (*below)(Point, Point, Point)) {
  const Point c = mesh.point(center), a = mesh.point(u), b = mesh.point(w);
  return orient2d(c, a, b) > 0 && below(a, c, b);
}

// Constrained edges linked to `edge` on its counter-clockwise side (or clockwise), in order.
class FanWalk {
 public:
  FanWalk(const Mesh& mesh, VertexId center) : mesh_(mesh), center_(center) {}

  std::vector<HalfEdge> counter_clockwise(HalfEdge edge) const {
    std::vector<HalfEdge> linked;
    std::optional<HalfEdge> out = leaving(edge);
    const VertexId start = other_end(mesh_, edge, center_);
    while (out) {
      const HalfEdge back = next_constrained(mesh_, *out);
      const VertexId u = mesh_.destination(*out), w = mesh_.origin(back);
      if (w == start || !wedge_below(mesh_, center_, u, w, is_below_60_deg)) break;
      linked.push_back(back);
      out = mesh_.twin(back);
    }
    return linked;
  }

  std::vector<HalfEdge> clockwise(HalfEdge edge) const {
    std::vector<HalfEdge> linked;
    std::optional<HalfEdge> back = arriving(edge);
    const VertexId start = other_end(mesh_, edge, center_);
    while (back) {
      const HalfEdge out = previous_constrained(mesh_, *back);
      const VertexId u = mesh_.destination(out), w = mesh_.origin(*back);
      if (u == start || !wedge_below(mesh_, center_, u, w, is_below_60_deg)) break;
      linked.push_back(out);
      back = mesh_.twin(out);
    }
    return linked;
  }

 private:
  std::optional<HalfEdge> leaving(HalfEdge e) const {
    return mesh_.origin(e) == center_ ? std::optional(e) : mesh_.twin(e);
  }
  std::optional<HalfEdge> arriving(HalfEdge e) const {
    return mesh_.destination(e) == center_ ? std::optional(e) : mesh_.twin(e);
  }

  const Mesh& mesh_;
  VertexId center_;
};

// The corner of t with the smallest angle faces its shortest edge.
HalfEdge shortest_edge(const Mesh& mesh, TriangleId t) { return edges_by_length(mesh, t)[0]; }

// Input segments that the origin of `leaving` lies on or is an end of, as seen from there: where
// the mesh touches itself in a corner, other triangles see others.
std::vector<SegmentId> segments_at(const Mesh& mesh, HalfEdge leaving) {
  std::vector<SegmentId> found;
  const auto add = [&](std::span<const SegmentId> segments) {
    found.insert(found.end(), segments.begin(), segments.end());
  };
  const VertexOrigin& origin = mesh.origin_of(mesh.origin(leaving));
  if (origin.kind == VertexOrigin::Kind::on_segment) {
    add(mesh.segments_of(SegmentSetId(origin.index)));
  } else if (origin.kind == VertexOrigin::Kind::input) {
    const HalfEdge first = first_of_fan(mesh, leaving);
    std::optional<HalfEdge> e = first;
    do {
      for (const HalfEdge side : {*e, previous_edge(*e)}) {
        if (mesh.is_constrained(side)) add(mesh.segments_of(side));
      }
      e = turn_counter_clockwise(mesh, *e);
    } while (e && *e != first);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::optional<VertexId> common_end(const Segment& r, const Segment& s) {
  if (r.a == s.a || r.a == s.b) return r.a;
  if (r.b == s.a || r.b == s.b) return r.b;
  return std::nullopt;
}

bool is_seditious(const Mesh& mesh, VertexId u, VertexId w, const Segment& r, const Segment& s) {
  const auto center = common_end(r, s);
  if (!center || *center == u || *center == w) return false;
  const Point c = mesh.point(*center);
  const Point r_end = mesh.point(r.a == *center ? r.b : r.a);
  const Point s_end = mesh.point(s.a == *center ? s.b : s.a);
  if (!is_below_60_deg(r_end, c, s_end)) return false;
  return is_same_radius(std::sqrt(squared_distance(c, mesh.point(u))),
                        std::sqrt(squared_distance(c, mesh.point(w))), c);
}

bool is_interior(const Mesh& mesh, VertexId v) {
  return mesh.origin_of(v).kind == VertexOrigin::Kind::interior;
}

// True if no segment of one list is in the other or shares an end with one of the other.
bool are_separate(const Mesh& mesh, std::span<const SegmentId> some,
                  std::span<const SegmentId> others) {
  return std::ranges::none_of(some, [&](SegmentId r) {
    return std::ranges::any_of(others, [&](SegmentId s) {
      return r == s || common_end(mesh.segments()[r.index()], mesh.segments()[s.index()]);
    });
  });
}

double distance_to_segment(Point p, Point a, Point b) {
  const Point ab = b - a;
  const double s = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
  return std::sqrt(squared_distance(p, a + s * ab));
}

}  // namespace

bool is_same_radius(double r, double s, Point center) {
  constexpr double part = 1e-9, ulps = 4 * 0x1p-52;
  const double rounding = ulps * std::max(std::abs(center.x), std::abs(center.y));
  return std::abs(r - s) <= part * std::max(r, s) + rounding;
}

Fan fan_at(const Mesh& mesh, HalfEdge edge, VertexId center) {
  const FanWalk walk(mesh, center);
  Fan fan{center, walk.clockwise(edge)};
  std::ranges::reverse(fan.edges);
  fan.edges.push_back(edge);
  std::unordered_set<VertexId> known;  // only asked, never walked through
  for (const HalfEdge e : fan.edges) known.insert(other_end(mesh, e, center));
  for (const HalfEdge e : walk.counter_clockwise(edge)) {
    // A full circle of wedges meets its other end.
    if (known.insert(other_end(mesh, e, center)).second) fan.edges.push_back(e);
  }
  if (fan.edges.size() == 1) return {center, {}};
  return fan;
}

bool smallest_angle_between_constrained(const Mesh& mesh, TriangleId t) {
  const HalfEdge e = shortest_edge(mesh, t);
  return mesh.is_constrained(next_edge(e)) && mesh.is_constrained(previous_edge(e));
}

std::vector<std::uint8_t> corners_in_sharp_wedges(const Mesh& mesh) {
  std::vector<std::uint8_t> bits(mesh.triangle_count(), 0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge first{TriangleId(t), i};  // each wedge starts at one constrained half-edge
      if (!mesh.is_constrained(first)) continue;
      const HalfEdge last = next_constrained(mesh, first);
      const VertexId center = mesh.origin(first);
      if (!wedge_below(mesh, center, mesh.destination(first), mesh.origin(last), is_below_60_deg)) {
        continue;
      }
      for (HalfEdge e = first;; e = *mesh.twin(previous_edge(e))) {
        bits[e.triangle.index()] |= static_cast<std::uint8_t>(1U << next_corner(e.edge));
        if (previous_edge(e) == last) break;
      }
    }
  }
  return bits;
}

std::uint32_t smallest_corner(const Mesh& mesh, TriangleId t) {
  return shortest_edge(mesh, t).edge;
}

bool shortest_edge_is_seditious(const Mesh& mesh, TriangleId t) {
  const HalfEdge e = shortest_edge(mesh, t);
  const VertexId u = mesh.origin(e), w = mesh.destination(e);
  if (mesh.origin_of(u).kind == VertexOrigin::Kind::interior) return false;
  if (mesh.origin_of(w).kind == VertexOrigin::Kind::interior) return false;
  const auto at_u = segments_at(mesh, e), at_w = segments_at(mesh, next_edge(e));
  for (const SegmentId r : at_u) {
    for (const SegmentId s : at_w) {
      if (r == s) continue;
      if (is_seditious(mesh, u, w, mesh.segments()[r.index()], mesh.segments()[s.index()])) {
        return true;
      }
    }
  }
  return false;
}

bool segments_meet_sharply(const Mesh& mesh) {
  // Pairs (vertex, other end) would need a sort; up to four other ends per vertex do not.
  struct Ends {
    std::array<VertexId, 4> other;
    std::uint32_t count = 0;
  };
  std::vector<Ends> at(mesh.vertex_count());
  const auto meets_sharply = [&](VertexId center, VertexId other) {
    Ends& ends = at[center.index()];
    if (ends.count == ends.other.size()) return true;
    for (std::uint32_t i = 0; i < ends.count; ++i) {
      if (ends.other[i] == other) continue;
      if (is_below_60_deg(mesh.point(ends.other[i]), mesh.point(center), mesh.point(other))) {
        return true;
      }
    }
    ends.other[ends.count++] = other;
    return false;
  };
  return std::ranges::any_of(mesh.segments(), [&](const Segment& s) {
    return meets_sharply(s.a, s.b) || meets_sharply(s.b, s.a);
  });
}

bool at_input_feature(const Mesh& mesh, TriangleId t, double floor) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    const VertexId a = mesh.origin(e), b = mesh.destination(e), c = mesh.apex(e);
    const Point p = mesh.point(a), q = mesh.point(b);
    if ((mesh.is_input(a) || mesh.is_input(b)) && !is_interior(mesh, a) && !is_interior(mesh, b) &&
        squared_distance(p, q) < floor * floor &&
        are_separate(mesh, segments_at(mesh, e), segments_at(mesh, next_edge(e)))) {
      return true;
    }
    if (!is_interior(mesh, c) && mesh.is_constrained(e) &&
        distance_to_segment(mesh.point(c), p, q) < floor &&
        are_separate(mesh, segments_at(mesh, previous_edge(e)), mesh.segments_of(e))) {
      return true;
    }
  }
  return false;
}

}  // namespace lepp

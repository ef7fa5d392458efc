#include "lepp/triangulation/segments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/segment_intersection.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/split.hpp"

namespace lepp {

namespace {

using VertexPair = std::pair<VertexId, VertexId>;

// A crossing is met one at a time; only rounding can pile them up.
constexpr std::size_t max_detours = 64;

class SegmentInserter {
 public:
  SegmentInserter(Mesh& mesh, const Pslg& pslg, Crossings crossings, TriangulationReport& report)
      : mesh_(mesh), pslg_(pslg), crossings_(crossings), report_(report) {}

  void insert(SegmentId id) {
    segment_ = id;
    const Segment& segment = mesh_.segments()[id.index()];
    // Vertices the segment must pass, next one on top: its end, and crossings met on the way.
    std::vector<VertexId> targets{segment.b};
    VertexId at = segment.a;
    while (!targets.empty()) {  // each turn moves `at` towards the top, or adds a crossing
      const VertexId target = targets.back();
      if (at == target) {
        targets.pop_back();
      } else if (const auto next = step(at, target, targets)) {
        at = *next;
      }
    }
  }

 private:
  int side(VertexId a, VertexId b, VertexId c) const {
    return orient2d(mesh_.point(a), mesh_.point(b), mesh_.point(c));
  }

  // Constrains one edge from `at` towards `target` and returns its end; or finds a crossing, puts
  // its vertex on `targets` and returns nothing.
  std::optional<VertexId> step(VertexId at, VertexId target, std::vector<VertexId>& targets) {
    const HalfEdge first = leaving_towards(at, target);
    if (mesh_.origin(first) == at || mesh_.destination(first) == at) {
      const VertexId end =
          mesh_.origin(first) == at ? mesh_.destination(first) : mesh_.origin(first);
      if (end != target) ++report_.points_on_segments;
      constrain(first, at, end);
      return end;
    }
    crossed_.clear();
    HalfEdge e = first;  // an edge that the line at -> target crosses, seen from the side of `at`
    VertexId end = target;
    while (true) {
      if (mesh_.is_constrained(e)) {
        if (targets.size() > max_detours) throw too_close_error(e, mesh_.point(at));
        targets.push_back(cross(e, at, target));
        return std::nullopt;
      }
      crossed_.emplace_back(mesh_.origin(e), mesh_.destination(e));
      const HalfEdge across = *mesh_.twin(e);
      const VertexId apex = mesh_.apex(across);
      const int apex_side = side(at, target, apex);
      if (apex_side == 0) {
        end = apex;
        break;
      }
      // Of the two other edges of that triangle, the one with an end on each side comes next.
      const HalfEdge one = next_edge(across), other = previous_edge(across);
      e = side(at, target, mesh_.origin(one)) * apex_side < 0 ? one : other;
    }
    if (end != target) ++report_.points_on_segments;
    flip_away(at, end);
    constrain(*mesh_.find_edge(at, end), at, end);
    return end;
  }

  // The edge at `at` that points exactly at `target`, or the edge opposite `at` that the line to
  // `target` crosses.
  HalfEdge leaving_towards(VertexId at, VertexId target) const {
    std::optional<HalfEdge> found;
    const Point p = mesh_.point(at), q = mesh_.point(target);
    for_each_in_fan(mesh_, at, [&](TriangleId t, std::uint32_t corner) {
      const HalfEdge opposite{t, corner};
      const VertexId u = mesh_.origin(opposite), w = mesh_.destination(opposite);
      const int from_u = side(at, u, target), from_w = side(at, target, w);
      if (from_u == 0 && dot_sign(q, p, mesh_.point(u)) > 0) {
        found = HalfEdge{t, previous_corner(corner)};
      } else if (from_w == 0 && dot_sign(q, p, mesh_.point(w)) > 0) {
        found = HalfEdge{t, next_corner(corner)};
      } else if (from_u > 0 && from_w > 0) {
        found = opposite;
      }
      return !found;
    });
    return *found;
  }

  void constrain(HalfEdge e, VertexId from, VertexId to) {
    if (mesh_.is_constrained(e)) ++report_.overlapping_edges;
    const double t_from = parameter(from), t_to = parameter(to);
    const bool forward = mesh_.origin(e) == from;
    mesh_.add_owner(e, segment_, forward ? t_from : t_to, forward ? t_to : t_from);
  }

  // Where vertex v lies on the curve of the current segment.
  double parameter(VertexId v) const {
    const Segment& s = mesh_.segments()[segment_.index()];
    if (v == s.a) return s.t_a;
    if (v == s.b) return s.t_b;
    const Point a = mesh_.point(s.a), b = mesh_.point(s.b);
    const double along = std::sqrt(squared_distance(a, mesh_.point(v)) / squared_distance(a, b));
    return s.t_a + along * (s.t_b - s.t_a);
  }

  // Flips the edges in crossed_ until none crosses the line from a to b, which then is an edge.
  void flip_away(VertexId a, VertexId b) {
    std::deque<VertexPair> crossing(crossed_.begin(), crossed_.end());
    std::vector<VertexPair> made;
    while (!crossing.empty()) {  // there is always an edge left that can be flipped [sloan1993]
      const auto [u, w] = crossing.front();
      crossing.pop_front();
      const HalfEdge e = *mesh_.find_edge(u, w);
      if (!is_flippable(mesh_, e)) {
        crossing.emplace_back(u, w);
        continue;
      }
      const HalfEdge diagonal = flip(mesh_, e);
      const VertexId p = mesh_.origin(diagonal), q = mesh_.destination(diagonal);
      const bool ends_here = p == a || p == b || q == a || q == b;
      if (!ends_here && side(a, b, p) * side(a, b, q) < 0) crossing.emplace_back(p, q);
      else made.emplace_back(p, q);
    }
    restore_around(made, a, b);
  }

  void restore_around(const std::vector<VertexPair>& made, VertexId a, VertexId b) {
    const HalfEdge segment = *mesh_.find_edge(a, b);
    mesh_.set_constrained_flag(segment, true);  // hold it while its neighbours are flipped
    mesh_.set_constrained_flag(*mesh_.twin(segment), true);
    std::vector<HalfEdge> suspects;
    for (const auto& [p, q] : made) {
      const auto e = mesh_.find_edge(p, q);
      for (const TriangleId t : {e->triangle, mesh_.twin(*e)->triangle}) {
        suspects.insert(suspects.end(), {{t, 0}, {t, 1}, {t, 2}});
      }
    }
    restore_delaunay(mesh_, suspects);
    const HalfEdge held = *mesh_.find_edge(a, b);
    mesh_.set_constrained_flag(held, false);
    mesh_.set_constrained_flag(*mesh_.twin(held), false);
  }

  // The vertex where the line at -> target crosses constrained edge e, made if necessary.
  VertexId cross(HalfEdge e, VertexId at, VertexId target) {
    const VertexId u = mesh_.origin(e), w = mesh_.destination(e);
    const Point a = mesh_.point(at), b = mesh_.point(target);
    const Point c = mesh_.point(u), d = mesh_.point(w);
    const Point p = in_supported_range(crossing_point(a, b, c, d));
    if (crossings_ == Crossings::refuse) throw crossing_error(e, p);
    if (p == c) return u;
    if (p == d) return w;
    if (report_.crossings_split >= crossing_limit()) throw too_close_error(e, p);
    for (const Point candidate : near(p)) {
      if (candidate == a || candidate == b || !can_split_edge(mesh_, e, candidate)) continue;
      ++report_.crossings_split;
      const auto number = pslg_.points.size() + report_.crossings_split - 1;
      const VertexOrigin origin{VertexOrigin::Kind::input, static_cast<std::uint32_t>(number)};
      const double along = std::sqrt(squared_distance(c, candidate) / squared_distance(c, d));
      const ConstrainedEdge& record = mesh_.constrained_edge(e);
      const double t_u = u < w ? record.t_low : record.t_high;
      const double t_w = u < w ? record.t_high : record.t_low;
      return insert_on_edge(mesh_, e, candidate, origin, t_u + along * (t_w - t_u)).vertex;
    }
    if (const auto v = bend(e)) return *v;
    throw too_close_error(e, p);
  }

  // Where a vertex z lies within a few ulp of constrained edge e = u -> w, no double fits between
  // them: e gives way, and its segments run u -> z -> w instead.
  std::optional<VertexId> bend(HalfEdge e) {
    const VertexId u = mesh_.origin(e), w = mesh_.destination(e);
    for (const HalfEdge side : {e, *mesh_.twin(e)}) {
      const VertexId z = mesh_.apex(side);
      if (++bends_ > crossing_limit() || !is_within_rounding(z, u, w)) continue;
      const auto owners_now = mesh_.segments_of(e);
      const std::vector<SegmentId> owners(owners_now.begin(), owners_now.end());
      if (shares_owner(u, z, owners) || shares_owner(z, w, owners)) continue;  // would fold back
      const ConstrainedEdge record = mesh_.constrained_edge(e);
      const double t_u = u < w ? record.t_low : record.t_high;
      const double t_w = u < w ? record.t_high : record.t_low;
      const double along = std::sqrt(squared_distance(mesh_.point(u), mesh_.point(z)) /
                                     squared_distance(mesh_.point(u), mesh_.point(w)));
      const double t_z = t_u + std::min(along, 1.0) * (t_w - t_u);
      mesh_.erase_record(u, w);
      mesh_.set_constrained_flag(e, false);
      mesh_.set_constrained_flag(*mesh_.twin(e), false);
      for (const SegmentId s : owners) {
        add_owner_between(u, z, s, t_u, t_z);
        add_owner_between(z, w, s, t_z, t_w);
      }
      std::vector<HalfEdge> suspects{e};
      restore_delaunay(mesh_, suspects);
      return z;
    }
    return std::nullopt;
  }

  bool shares_owner(VertexId a, VertexId b, const std::vector<SegmentId>& owners) const {
    const HalfEdge edge = *mesh_.find_edge(a, b);
    if (!mesh_.is_constrained(edge)) return false;
    return std::ranges::any_of(mesh_.segments_of(edge), [&](SegmentId s) {
      return s == segment_ || std::ranges::find(owners, s) != owners.end();
    });
  }

  void add_owner_between(VertexId a, VertexId b, SegmentId s, double t_a, double t_b) {
    const HalfEdge edge = *mesh_.find_edge(a, b);
    const bool forward = mesh_.origin(edge) == a;
    mesh_.add_owner(edge, s, forward ? t_a : t_b, forward ? t_b : t_a);
  }

  bool is_within_rounding(VertexId z, VertexId u, VertexId w) const {
    const Point a = mesh_.point(u), b = mesh_.point(w), c = mesh_.point(z);
    const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    const Point ab = b - a;
    const double s = dot(c - a, ab) / dot(ab, ab);
    const double distance = std::abs(lepp::cross(ab, c - a)) / std::sqrt(dot(ab, ab));
    return s > 0 && s < 1 && distance <= 8 * 0x1p-52 * largest;
  }

  static std::array<Point, 9> near(Point p) {
    const double up = std::numeric_limits<double>::infinity();
    const double x0 = std::nextafter(p.x, -up), x1 = std::nextafter(p.x, up);
    const double y0 = std::nextafter(p.y, -up), y1 = std::nextafter(p.y, up);
    return {p,        Point{x0, p.y}, Point{x1, p.y}, Point{p.x, y0}, Point{p.x, y1},
            {x0, y0}, {x0, y1},       {x1, y0},       {x1, y1}};
  }

  std::size_t crossing_limit() const {
    const std::size_t n = mesh_.segments().size();
    return n * n + 1000;
  }

  InputError crossing_error(HalfEdge e, Point p) const {
    return {pslg_.source, names(e) + " cross at " + to_text(p),
            "give them a common point there, or use --split-crossings (Crossings::split)"};
  }

  InputError too_close_error(HalfEdge e, Point p) const {
    return {pslg_.source, names(e) + " cross at " + to_text(p) + ", too close to a point to split",
            "move or merge the points there"};
  }

  std::string names(HalfEdge e) const {
    const SegmentId other = mesh_.segments_of(e)[0];
    return pslg_.segment_name(std::min(segment_, other)) + " and " +
           pslg_.segment_name(std::max(segment_, other));
  }

  Mesh& mesh_;
  const Pslg& pslg_;
  Crossings crossings_;
  TriangulationReport& report_;
  SegmentId segment_;
  std::vector<VertexPair> crossed_;
  std::size_t bends_ = 0;
};

}  // namespace

void insert_segments(Mesh& mesh, const Pslg& pslg, Crossings crossings,
                     TriangulationReport& report) {
  SegmentInserter inserter(mesh, pslg, crossings, report);
  for (std::size_t i = 0; i < mesh.segments().size(); ++i) inserter.insert(SegmentId(i));
}

}  // namespace lepp

#include "support/plain/segments.hpp"

#include <cmath>
#include <deque>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/segment_intersection.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/triangulation/flip.hpp"

namespace lepp::plain {

namespace {

using VertexPair = std::pair<VertexId, VertexId>;

class SegmentInserter {
 public:
  SegmentInserter(Mesh& mesh, const Pslg& pslg, TriangulationReport& report)
      : mesh_(mesh), pslg_(pslg), report_(report) {}

  void insert(SegmentId id) {
    segment_ = id;
    const Segment& segment = mesh_.segments()[id.index()];
    VertexId at = segment.a;
    while (at != segment.b) at = step(at, segment.b);  // each turn comes closer to b
  }

 private:
  int side(VertexId a, VertexId b, VertexId c) const {
    return orient2d(mesh_.point(a), mesh_.point(b), mesh_.point(c));
  }

  // Constrains one edge from `at` towards `target` and returns its end.
  VertexId step(VertexId at, VertexId target) {
    const HalfEdge first = leaving_towards(at, target);
    VertexId end = target;
    if (mesh_.origin(first) == at || mesh_.destination(first) == at) {
      end = mesh_.origin(first) == at ? mesh_.destination(first) : mesh_.origin(first);
      constrain(first);
    } else {
      end = cross_edges(first, at, target);
      flip_away(at, end);
      constrain(*mesh_.find_edge(at, end));
      restore_around();
    }
    if (end != target) ++report_.points_on_segments;
    return end;
  }

  // Collects the edges that the line from `at` to `target` crosses, beginning with `e`, up to the
  // first vertex on the line, which is returned.
  VertexId cross_edges(HalfEdge e, VertexId at, VertexId target) {
    crossed_.clear();
    while (true) {
      if (mesh_.is_constrained(e)) throw crossing_error(e, at, target);
      crossed_.emplace_back(mesh_.origin(e), mesh_.destination(e));
      const HalfEdge across = *mesh_.twin(e);
      const VertexId apex = mesh_.apex(across);
      const int apex_side = side(at, target, apex);
      if (apex_side == 0) return apex;
      // Of the two other edges of that triangle, the one with an end on each side comes next.
      const HalfEdge one = next_edge(across), other = previous_edge(across);
      e = side(at, target, mesh_.origin(one)) * apex_side < 0 ? one : other;
    }
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

  void constrain(HalfEdge e) {
    if (mesh_.is_constrained(e)) ++report_.overlapping_edges;
    mesh_.add_owner(e, segment_, parameter(mesh_.origin(e)), parameter(mesh_.destination(e)));
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
    made_.clear();
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
      else made_.emplace_back(p, q);
    }
  }

  void restore_around() {
    std::vector<HalfEdge> suspects;
    for (const auto& [p, q] : made_) {
      const auto e = mesh_.find_edge(p, q);
      for (const TriangleId t : {e->triangle, mesh_.twin(*e)->triangle}) {
        suspects.insert(suspects.end(), {{t, 0}, {t, 1}, {t, 2}});
      }
    }
    restore_delaunay(mesh_, suspects);
  }

  InputError crossing_error(HalfEdge e, VertexId at, VertexId target) const {
    const SegmentId other = mesh_.segments_of(e)[0];
    const Point p = crossing_point(mesh_.point(at), mesh_.point(target),
                                   mesh_.point(mesh_.origin(e)), mesh_.point(mesh_.destination(e)));
    return {pslg_.source,
            pslg_.segment_name(std::min(segment_, other)) + " and " +
                pslg_.segment_name(std::max(segment_, other)) + " cross at " + to_text(p),
            "give them a common point there"};
  }

  Mesh& mesh_;
  const Pslg& pslg_;
  TriangulationReport& report_;
  SegmentId segment_;
  std::vector<VertexPair> crossed_, made_;
};

}  // namespace

void insert_segments(Mesh& mesh, const Pslg& pslg, TriangulationReport& report) {
  SegmentInserter inserter(mesh, pslg, report);
  for (std::size_t i = 0; i < mesh.segments().size(); ++i) inserter.insert(SegmentId(i));
}

}  // namespace lepp::plain

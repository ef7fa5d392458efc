#include "lepp/triangulation/segments.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/segment_intersection.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/triangulation/hole.hpp"

namespace lepp {

namespace {

using Code = RawTriangulation::Code;

constexpr std::size_t max_further = 10'000'000;

class SegmentInserter {
 public:
  SegmentInserter(RawTriangulation& raw, const Pslg& pslg, TriangulationReport& report)
      : raw_(raw), pslg_(pslg), report_(report), hole_(raw) {
    pieces_.first.reserve(pslg.segments.size());
  }

  // From both ends inwards: `a` and `b` bound what is still missing.
  void insert(SegmentId segment, VertexId a, VertexId b) {
    segment_ = segment;
    while (a != b) {
      const Search search = find_edge(a, b);
      if (search.edge) {
        add_piece(*search.edge, a, b, pieces_);
        break;
      }
      // The vertex with the shorter fan is the one that has been searched in full.
      if (search.from_b) b = advance(b, a, true);
      else a = advance(a, b, false);
    }
    append_backwards(pieces_.first, from_b_.first);
    append_backwards(pieces_.further, from_b_.further);
  }

  SegmentPieces take_pieces() { return std::move(pieces_); }

 private:
  struct Search {
    std::optional<Code> edge;  // a -> b or b -> a
    bool from_b = false;       // the fan that was seen from end to end is that of b
  };

  // Turns around a and b at the same time, so a vertex with many edges costs no more than the
  // other one has.
  Search find_edge(VertexId a, VertexId b) const {
    const Code first_a = raw_.leaving[a.index()], first_b = raw_.leaving[b.index()];
    Code at_a = first_a, at_b = first_b;
    while (true) {
      if (raw_.destination(at_a) == b) return {at_a, false};
      at_a = raw_.turn(at_a);
      if (at_a == first_a) return {std::nullopt, false};
      if (raw_.destination(at_b) == a) return {at_b, true};
      at_b = raw_.turn(at_b);
      if (at_b == first_b) return {std::nullopt, true};
    }
  }

  int side(VertexId a, VertexId b, VertexId c) const {
    return orient2d(raw_.point(a), raw_.point(b), raw_.point(c));
  }

  // Constrains the edge from `at` to the first vertex on the way to `target`, and returns it.
  VertexId advance(VertexId at, VertexId target, bool backwards) {
    SegmentPieces& pieces = backwards ? from_b_ : pieces_;
    const Code first = towards(at, target);
    if (raw_.origin(first) == at) {
      const VertexId end = raw_.destination(first);
      ++report_.points_on_segments;
      add_piece(first, backwards ? end : at, backwards ? at : end, pieces);
      return end;
    }
    hole_.start(at, first);
    while (true) {
      if (raw_.is_constrained(hole_.crossed())) throw crossing_error(hole_.crossed(), at, target);
      const VertexId apex = hole_.apex_across();
      const int turn = side(at, target, apex);
      if (turn == 0) {
        if (apex != target) ++report_.points_on_segments;
        hole_.fill();
        pieces.first.push_back({segment_, backwards ? apex : at, backwards ? at : apex});
        return apex;
      }
      hole_.pass(turn);
    }
  }

  // The edge that leaves `at` exactly towards `target`, or the edge opposite `at` that the line to
  // `target` crosses.
  Code towards(VertexId at, VertexId target) const {
    const Point p = raw_.point(at), q = raw_.point(target);
    // The side of the target that a spoke at -> u lies on: -1 right of it, 1 left.
    const auto turn = [&](VertexId u) {
      return u == RawTriangulation::ghost ? 0 : orient2d(p, q, raw_.point(u));
    };
    Code e = raw_.leaving[at.index()];
    VertexId u = raw_.destination(e);
    int turn_u = turn(u);
    while (true) {  // ends: the target lies in the hull, so in one of the triangles around `at`
      if (turn_u == 0 && u != RawTriangulation::ghost && dot_sign(q, p, raw_.point(u)) > 0)
        return e;
      const VertexId w = raw_.apex(e);
      const int turn_w = turn(w);
      if (turn_u < 0 && turn_w > 0) return RawTriangulation::next(e);
      e = raw_.turn(e);
      u = w;
      turn_u = turn_w;
    }
  }

  void add_piece(Code e, VertexId a, VertexId b, SegmentPieces& pieces) {
    if (raw_.is_constrained(e)) {
      ++report_.overlapping_edges;
      const std::size_t known = pieces_.further.size() + from_b_.further.size();
      if (known >= max_further + pslg_.segments.size()) throw too_many_overlaps();
      pieces.further.push_back({segment_, a, b});
      return;
    }
    raw_.constrain(e);
    pieces.first.push_back({segment_, a, b});
  }

  static void append_backwards(std::vector<SegmentPiece>& pieces, std::vector<SegmentPiece>& more) {
    pieces.insert(pieces.end(), more.rbegin(), more.rend());
    more.clear();
  }

  RefusedError too_many_overlaps() const {
    return {pslg_.source,
            "segments lie on each other along more than 10 million edges, and " +
                pslg_.segment_name(segment_) + " adds more",
            "is this the right file? Remove segments that lie on others"};
  }

  // An edge has no owner of its own in the kernel: it is looked up, once, to complain.
  SegmentId owner(VertexId u, VertexId w) const {
    const auto found = std::ranges::find_if(pieces_.first, [&](const SegmentPiece& p) {
      return std::minmax(p.a, p.b) == std::minmax(u, w);
    });
    return found->segment;
  }

  InputError crossing_error(Code e, VertexId at, VertexId target) const {
    const VertexId u = raw_.origin(e), w = raw_.destination(e);
    const Point p =
        crossing_point(raw_.point(at), raw_.point(target), raw_.point(u), raw_.point(w));
    const SegmentId other = owner(u, w), r = std::min(segment_, other),
                    s = std::max(segment_, other);
    return {pslg_.source,
            pslg_.segment_name(r) + " and " + pslg_.segment_name(s) + " cross at " + to_text(p),
            "give them a common point there, or use --split-crossings (Crossings::split)"};
  }

  RawTriangulation& raw_;
  const Pslg& pslg_;
  TriangulationReport& report_;
  SegmentHole hole_;
  SegmentPieces pieces_;
  SegmentPieces from_b_;  // of the segment that is being inserted, from its end b inwards
  SegmentId segment_;
};

}  // namespace

SegmentPieces insert_segments(RawTriangulation& raw, const Pslg& pslg,
                              const std::vector<VertexId>& vertex_of, TriangulationReport& report) {
  SegmentInserter inserter(raw, pslg, report);
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment& segment = pslg.segments[s];
    inserter.insert(SegmentId(s), vertex_of[segment.a.index()], vertex_of[segment.b.index()]);
  }
  return inserter.take_pieces();
}

}  // namespace lepp

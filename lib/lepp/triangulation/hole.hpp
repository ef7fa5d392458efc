#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "lepp/triangulation/raw_triangulation.hpp"

namespace lepp {

/// The triangles that a segment crosses on its way from one vertex to another, and how to fill the
/// hole that they leave with the segment as an edge. Kept between segments to save allocations.
class SegmentHole {
 public:
  explicit SegmentHole(RawTriangulation& raw) : raw_(raw) {}

  /// Starts at vertex `from`, with edge `e` opposite it the first one crossed.
  void start(VertexId from, RawTriangulation::Code e);
  /// Steps across `e`, crossed last, and says which vertex lies behind it.
  VertexId apex_across() const { return raw_.apex(raw_.twin(e_)); }
  /// The edge crossed last, seen from the side of `from`.
  RawTriangulation::Code crossed() const { return e_; }
  /// The vertex behind lies left (side > 0) or right of the segment: the next edge is crossed.
  void pass(int side);
  /// The vertex behind is the end: fills the hole, with the edge from -> end constrained.
  ///
  /// Every point of the border sees the segment, so each half of the hole is triangulated by one
  /// scan along its border that cuts off convex corners [toussaint1982]; flips then make it
  /// Delaunay. Triangles that were not crossed stay: the segment only takes visibility away.
  void fill();

 private:
  using Code = RawTriangulation::Code;
  // An edge of the hole's border, in a triangle that will be removed, and what lies beyond it.
  struct Border {
    Code edge, outside;
    VertexId origin;
    bool constrained;
  };
  // A vertex on the scan's stack and the edge to it from the one below: what lies on the other
  // side of that edge is a border (an index) or a new triangle (its edge).
  struct Entry {
    VertexId vertex;
    Code behind;
    bool is_border;
  };

  void add_border(std::vector<Border>& side, Code edge);
  void find_doubles();
  void join_border();
  /// Triangulates left of border edges [begin, end), `last` being where the last of them ends.
  /// \return the edge of a new triangle that closes the half, along the segment
  Code scan(std::size_t begin, std::size_t end, VertexId last);
  Code cut_corner(VertexId w, const Entry& to_w);
  void attach(Code edge, const Entry& entry);

  RawTriangulation& raw_;
  Code e_ = 0;
  std::vector<std::uint32_t> removed_;
  std::vector<Border> left_, right_;  // both from the segment's start to its end
  std::vector<Border> border_;        // counter-clockwise around each half: right, then left
  std::vector<std::pair<Code, std::size_t>> doubles_;  // border edges that occur twice, and where
  std::vector<Code> inside_;  // for each border edge, the new triangle's edge along it
  std::vector<Entry> stack_;
  std::vector<Code> suspects_;
};

}  // namespace lepp

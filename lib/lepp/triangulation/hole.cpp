#include "lepp/triangulation/hole.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "lepp/geometry/predicates.hpp"

namespace lepp {

//            w                     e = u -> w, seen from `from`; beyond it lies x, left or right
//          / | \                   of the segment from -> end. The border grows by x -> w, or by
//     from  e|  x   ... end        u -> x, and the other one of the two is crossed next.
//          \ | /
//            u
void SegmentHole::start(VertexId from, Code e) {
  assert(raw_.apex(e) == from);
  static_cast<void>(from);
  removed_ = {RawTriangulation::triangle_of(e)};
  left_.clear();
  right_.clear();
  add_border(right_, RawTriangulation::previous(e));  // from -> u
  add_border(left_, RawTriangulation::next(e));       // w -> from
  e_ = e;
}

void SegmentHole::pass(int side) {
  const Code f = raw_.twin(e_), to_x = RawTriangulation::next(f),
             from_x = RawTriangulation::previous(f);
  removed_.push_back(RawTriangulation::triangle_of(f));
  if (side > 0) {
    add_border(left_, from_x);
    e_ = to_x;
  } else {
    add_border(right_, to_x);
    e_ = from_x;
  }
}

void SegmentHole::fill() {
  const Code f = raw_.twin(e_);
  removed_.push_back(RawTriangulation::triangle_of(f));
  add_border(right_, RawTriangulation::next(f));
  add_border(left_, RawTriangulation::previous(f));
  const VertexId from = right_.front().origin, end = raw_.apex(f);
  border_ = right_;
  border_.insert(border_.end(), left_.rbegin(), left_.rend());
  inside_.resize(border_.size());

  find_doubles();

  suspects_.clear();
  const Code back = scan(0, right_.size(), end);
  const Code along = scan(right_.size(), border_.size(), from);
  raw_.link(back, along);
  raw_.constrain(along);
  join_border();
  raw_.restore_delaunay(suspects_);
}

// A border edge with a removed triangle beyond it has the hole on both sides.
void SegmentHole::find_doubles() {
  doubles_.clear();
  for (const std::uint32_t t : removed_) raw_.set_label(t, 1);
  for (std::size_t i = 0; i < border_.size(); ++i) {
    if (raw_.label(RawTriangulation::triangle_of(border_[i].outside)) == 1) {
      doubles_.emplace_back(border_[i].edge, i);
    }
  }
  for (const std::uint32_t t : removed_) raw_.set_label(t, 0);
  std::ranges::sort(doubles_);
}

void SegmentHole::join_border() {
  for (const auto& [edge, i] : doubles_) {  // their `outside` was an edge of a removed triangle
    const auto other =
        std::ranges::lower_bound(doubles_, std::pair(border_[i].outside, std::size_t{0}));
    border_[i].outside = inside_[other->second];
  }
  for (std::size_t i = 0; i < border_.size(); ++i) {
    raw_.link(inside_[i], border_[i].outside);
    raw_.set_constrained(inside_[i], border_[i].constrained);
  }
}

void SegmentHole::add_border(std::vector<Border>& side, Code edge) {
  side.push_back({edge, raw_.twin(edge), raw_.origin(edge), raw_.is_constrained(edge)});
}

SegmentHole::Code SegmentHole::scan(std::size_t begin, std::size_t end, VertexId last) {
  stack_ = {{border_[begin].origin, 0, false}};
  for (std::size_t i = begin; i < end; ++i) {
    Entry next{i + 1 < end ? border_[i + 1].origin : last, static_cast<Code>(i), true};
    while (stack_.size() > 1) {
      const Entry& b = stack_.back();
      const Entry& a = stack_[stack_.size() - 2];
      if (orient2d(raw_.point(a.vertex), raw_.point(b.vertex), raw_.point(next.vertex)) <= 0) break;
      next.behind = cut_corner(next.vertex, next);
      next.is_border = false;
    }
    stack_.push_back(next);
  }
  assert(stack_.size() == 2);
  return stack_.back().behind;
}

// Makes the triangle of the two uppermost entries and w, and takes the upper one off the stack.
SegmentHole::Code SegmentHole::cut_corner(VertexId w, const Entry& to_w) {
  const std::uint32_t t = removed_.back();
  removed_.pop_back();
  const Entry b = stack_.back();
  stack_.pop_back();
  raw_.set_corners(t, stack_.back().vertex, b.vertex, w);
  raw_.leave_from(t);
  attach(RawTriangulation::code(t, 2), b);
  attach(RawTriangulation::code(t, 0), to_w);
  return RawTriangulation::code(t, 1);
}

void SegmentHole::attach(Code edge, const Entry& entry) {
  if (entry.is_border) {
    inside_[entry.behind] = edge;
  } else {
    raw_.link(edge, entry.behind);
    suspects_.push_back(edge);
  }
}

}  // namespace lepp

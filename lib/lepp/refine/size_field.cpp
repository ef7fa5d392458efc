#include "lepp/refine/size_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void check(const std::vector<SizeSource>& sources, double grading) {
  if (!(grading >= 0 && std::isfinite(grading))) {
    throw InputError("grading", to_text(grading) + " is out of range", "give a number from 0 on");
  }
  for (const SizeSource& s : sources) {
    if (!std::isfinite(s.at.x) || !std::isfinite(s.at.y)) {
      throw InputError("size source at " + to_text(s.at), "lies nowhere", "give finite numbers");
    }
    if (!(s.size > 0 && std::isfinite(s.size))) {
      throw InputError("size source at " + to_text(s.at), "asks for size " + to_text(s.size),
                       "give a length above 0");
    }
  }
}

struct Range {
  std::size_t begin, end;
  std::size_t middle() const { return begin + (end - begin) / 2; }
  bool empty() const { return begin == end; }
};

// Halving 2^64 sources ends after 64 steps; each step leaves one other half to be visited.
constexpr std::size_t deepest = 66;

}  // namespace

SizeField::SizeField(std::vector<SizeSource> sources, double grading) : grading_(grading) {
  check(sources, grading);
  std::vector<Node> nodes;
  nodes.reserve(sources.size());
  for (const SizeSource& s : sources) nodes.push_back({s, s.at, s.at, s.size, infinity});
  build(nodes);
  nodes_ = std::make_shared<const std::vector<Node>>(std::move(nodes));
}

// The root splits the longer side of the box. Every range is visited after the one it is part of.
void SizeField::build(std::vector<Node>& nodes) {
  std::vector<Range> pending{{0, nodes.size()}};
  while (!pending.empty()) {  // ends: ranges are halved
    const Range range = pending.back();
    pending.pop_back();
    if (range.empty()) continue;
    const auto begin = nodes.begin() + static_cast<std::ptrdiff_t>(range.begin);
    const auto end = nodes.begin() + static_cast<std::ptrdiff_t>(range.end);
    Point low{infinity, infinity}, high{-infinity, -infinity};
    double least = infinity, least_around = infinity;
    for (auto it = begin; it != end; ++it) {
      const Point at = it->source.at;
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
      least = std::min(least, it->source.size);
      if (it->source.holds_around_it) least_around = std::min(least_around, it->source.size);
    }
    const bool wide = high.x - low.x > high.y - low.y;
    const auto middle = nodes.begin() + static_cast<std::ptrdiff_t>(range.middle());
    std::nth_element(begin, middle, end, [&](const Node& a, const Node& b) {
      const Point p = a.source.at, q = b.source.at;
      if (wide && p.x != q.x) return p.x < q.x;
      return p.y != q.y ? p.y < q.y : p.x < q.x;
    });
    middle->low = low;
    middle->high = high;
    middle->least = least;
    middle->least_around = least_around;
    pending.push_back({range.begin, range.middle()});
    pending.push_back({range.middle() + 1, range.end});
  }
}

double SizeField::lower_bound(const Node& node, Point p) const {
  const double dx = std::max({node.low.x - p.x, p.x - node.high.x, 0.0});
  const double dy = std::max({node.low.y - p.y, p.y - node.high.y, 0.0});
  return node.least + grading_ * std::sqrt(dx * dx + dy * dy);
}

double SizeField::operator()(Point p) const {
  const std::vector<Node>& nodes = *nodes_;
  std::array<Range, deepest> pending;
  std::size_t count = 0;
  if (!nodes.empty()) pending[count++] = {0, nodes.size()};
  double best = infinity;
  while (count > 0) {
    const Range range = pending[--count];
    const Node& node = nodes[range.middle()];
    if (lower_bound(node, p) >= best) continue;
    const Point d = node.source.at - p;
    best = std::min(best, node.source.size + grading_ * std::sqrt(dot(d, d)));
    const Range left{range.begin, range.middle()}, right{range.middle() + 1, range.end};
    const double to_left = left.empty() ? infinity : lower_bound(nodes[left.middle()], p);
    const double to_right = right.empty() ? infinity : lower_bound(nodes[right.middle()], p);
    const bool left_first = to_left <= to_right;
    if (std::max(to_left, to_right) < best) pending[count++] = left_first ? right : left;
    if (std::min(to_left, to_right) < best) pending[count++] = left_first ? left : right;
  }
  return best;
}

double SizeField::least_within(Point a, Point b, Point c, double bound) const {
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [bottom, top] = std::minmax({a.y, b.y, c.y});
  const std::vector<Node>& nodes = *nodes_;
  std::array<Range, deepest> pending;
  std::size_t count = 0;
  if (!nodes.empty()) pending[count++] = {0, nodes.size()};
  while (count > 0) {
    const Range range = pending[--count];
    const Node& node = nodes[range.middle()];
    const bool apart =
        node.low.x > right || node.high.x < left || node.low.y > top || node.high.y < bottom;
    if (apart || node.least_around >= bound) continue;
    const auto& [p, size, holds] = node.source;
    if (holds && size < bound && orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 &&
        orient2d(c, a, p) >= 0) {
      bound = size;
    }
    if (range.begin < range.middle()) pending[count++] = {range.begin, range.middle()};
    if (range.middle() + 1 < range.end) pending[count++] = {range.middle() + 1, range.end};
  }
  return bound;
}

std::vector<SizeSource> sizes_of_segments(const Pslg& pslg) {
  constexpr double larger = 1.25;
  std::vector<SizeSource> sources;
  for (const Segment& s : pslg.segments) {
    const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
    const double length = std::sqrt(squared_distance(a, b));
    if (length > 0) sources.push_back({midpoint(a, b), larger * length});
  }
  return sources;
}

}  // namespace lepp

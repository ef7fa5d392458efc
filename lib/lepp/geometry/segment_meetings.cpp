#include "lepp/geometry/segment_meetings.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "lepp/geometry/near_pairs.hpp"
#include "lepp/geometry/predicates.hpp"

namespace lepp {

namespace {

// A segment by the first copies of its ends, the smaller one first.
struct Key {
  VertexId low, high;
  SegmentId id;
  friend auto operator<=>(const Key&, const Key&) = default;
};

class Finder {
 public:
  Finder(const Pslg& pslg, std::size_t most)
      : pslg_(pslg), most_(most), first_(first_copies(pslg.points)) {}

  SegmentMeetings run() {
    find_duplicates();
    find_repeated_segments();
    find_lone_points();
    compare_near_pairs();
    return std::move(found_);
  }

 private:
  Point at(VertexId v) const { return pslg_.points[v.index()]; }

  void find_duplicates() {
    for (std::size_t i = 0; i < first_.size(); ++i) {
      if (first_[i] != VertexId(i)) found_.duplicate_points.emplace_back(first_[i], VertexId(i));
    }
  }

  // Leaves in distinct_ the first copies of the segments that have a length.
  void find_repeated_segments() {
    std::vector<Key> keys;
    for (std::size_t i = 0; i < pslg_.segments.size(); ++i) {
      const VertexId a = first_[pslg_.segments[i].a.index()];
      const VertexId b = first_[pslg_.segments[i].b.index()];
      if (a == b) found_.zero_length.emplace_back(i);
      else keys.push_back({std::min(a, b), std::max(a, b), SegmentId(i)});
    }
    std::ranges::sort(keys);
    for (std::size_t i = 0, first = 0; i < keys.size(); ++i) {
      if (std::tie(keys[i].low, keys[i].high) != std::tie(keys[first].low, keys[first].high)) {
        first = i;
      }
      if (i == first) distinct_.push_back(keys[i]);
      else found_.repeated_segments.emplace_back(keys[first].id, keys[i].id);
    }
    std::ranges::sort(distinct_, {}, &Key::id);
    std::ranges::sort(found_.repeated_segments, {},
                      [](const auto& pair) { return std::pair(pair.second, pair.first); });
  }

  void find_lone_points() {
    std::vector<bool> taken(pslg_.points.size(), false);
    for (const Key& key : distinct_) taken[key.low.index()] = taken[key.high.index()] = true;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (!taken[i] && first_[i] == VertexId(i)) lone_.emplace_back(i);
    }
  }

  void compare_near_pairs() {
    std::vector<Strip> strips;
    strips.reserve(distinct_.size() + lone_.size());
    for (const Key& key : distinct_) strips.push_back({at(key.low), at(key.high)});
    for (const VertexId v : lone_) strips.push_back({at(v), at(v)});
    for_each_near_pair(strips, [&](std::uint32_t i, std::uint32_t j) {
      if (j < distinct_.size()) compare(distinct_[i], distinct_[j]);
      else compare(distinct_[i], lone_[j - distinct_.size()]);
      return true;
    });
    put_in_order();
  }

  void compare(const Key& r, const Key& s) {
    const SegmentMeeting meeting = meeting_of(r, s);
    if (meeting == SegmentMeeting::apart || meeting == SegmentMeeting::at_shared_end) return;
    found_.pairs.push_back({r.id, s.id, meeting});
    keep_room();
  }

  // A meeting may be found several times. The copies go whenever the lists have grown long.
  void keep_room() {
    if (found_.pairs.size() + found_.points_on_segments.size() >= 2 * most_) put_in_order();
  }

  void put_in_order() {
    drop_copies(found_.pairs, [](const SegmentPair& p) { return std::tie(p.first, p.second); });
    drop_copies(found_.points_on_segments,
                [](const PointOnSegment& p) { return std::tie(p.point, p.segment); });
    if (found_.pairs.size() + found_.points_on_segments.size() <= most_) return;
    throw RefusedError(pslg_.source,
                       "segments meet each other, or pass through points, in more than " +
                           std::to_string(most_) + " places",
                       "is this the right file? Meshing it would need as many points");
  }

  // Neighbours in a chain are by far the most frequent pairs: one test tells nearly all of them.
  SegmentMeeting meeting_of(const Key& r, const Key& s) const {
    const bool from_low = r.low == s.low || r.low == s.high;
    const bool from_high = r.high == s.low || r.high == s.high;
    if (from_low || from_high) {
      const VertexId hub = from_low ? r.low : r.high;
      const Point p = at(from_low ? r.high : r.low), q = at(s.low == hub ? s.high : s.low);
      if (orient2d(at(hub), p, q) != 0) return SegmentMeeting::at_shared_end;
    }
    return segments_meet(at(r.low), at(r.high), at(s.low), at(s.high));
  }

  void compare(const Key& r, VertexId v) {
    if (!is_on_segment(at(v), at(r.low), at(r.high))) return;
    found_.points_on_segments.push_back({v, r.id});
    keep_room();
  }

  template <class List, class Projection>
  static void drop_copies(List& list, Projection order) {
    std::ranges::sort(list, {}, order);
    const auto same = [&](const auto& p, const auto& q) { return order(p) == order(q); };
    list.erase(std::unique(list.begin(), list.end(), same), list.end());
  }

  const Pslg& pslg_;
  std::size_t most_;
  std::vector<VertexId> first_;
  std::vector<Key> distinct_;
  std::vector<VertexId> lone_;
  SegmentMeetings found_;
};

}  // namespace

bool SegmentMeetings::none() const {
  return duplicate_points.empty() && zero_length.empty() && repeated_segments.empty() &&
         pairs.empty() && points_on_segments.empty();
}

SegmentMeetings find_segment_meetings(const Pslg& pslg, std::size_t most) {
  return Finder(pslg, most).run();
}

std::vector<VertexId> first_copies(const std::vector<Point>& points) {
  std::vector<std::pair<Point, VertexId>> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) order.emplace_back(points[i], i);
  std::ranges::sort(order);
  std::vector<VertexId> first(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& [p, v] = order[k];
    const bool copy = k > 0 && order[k - 1].first == p;
    first[v.index()] = copy ? first[order[k - 1].second.index()] : v;
  }
  return first;
}

Point meeting_point(const Pslg& pslg, const SegmentPair& pair) {
  const Segment& r = pslg.segments[pair.first.index()];
  const Segment& s = pslg.segments[pair.second.index()];
  const auto at = [&](VertexId v) { return pslg.points[v.index()]; };
  const auto end_inside = [&](const Segment& of, const Segment& on) -> std::optional<Point> {
    for (const VertexId v : {of.a, of.b}) {
      const Point p = at(v), a = at(on.a), b = at(on.b);
      if (p != a && p != b && is_on_segment(p, a, b)) return p;
    }
    return std::nullopt;
  };
  if (const auto p = end_inside(s, r)) return *p;
  if (const auto p = end_inside(r, s)) return *p;
  return crossing_point(at(r.a), at(r.b), at(s.a), at(s.b));
}

}  // namespace lepp

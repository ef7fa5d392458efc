#include "lepp/geometry/split_crossings.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_map>

#include "lepp/geometry/near_pairs.hpp"
#include "lepp/geometry/pixel.hpp"
#include "lepp/geometry/segment_meetings.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/geometry/track.hpp"

namespace lepp {

namespace {

constexpr int max_rounds = 32;

struct HashOfPoint {
  std::size_t operator()(Point p) const {
    const auto bits = [](double c) { return std::bit_cast<std::uint64_t>(c + 0.0); };  // -0 is 0
    const std::uint64_t mixed = bits(p.x) * 0x9e3779b97f4a7c15U ^ std::rotl(bits(p.y), 29);
    return static_cast<std::size_t>((mixed ^ (mixed >> 31)) * 0xbf58476d1ce4e5b9U);
  }
};

// A place where a piece is to be cut.
struct Cut {
  std::size_t piece;
  VertexId at;
  friend auto operator<=>(const Cut&, const Cut&) = default;
};

class Splitter {
 public:
  explicit Splitter(const Pslg& pslg) : input_(pslg), work_(pslg), tracks_(pslg.segments.size()) {
    for (std::size_t i = 0; i < tracks_.size(); ++i) tracks_[i].segment = SegmentId(i);
    if (!pslg.point_numbers.empty()) next_number_ = std::ranges::max(pslg.point_numbers) + 1;
    lay_pieces();
  }

  SplitPslg run() {
    int rounds = 0;
    while (true) {  // between two turns the pieces of a segment are a chain between its ends
      const SegmentMeetings found = find_segment_meetings(work_);
      if (found.pairs.empty() && found.points_on_segments.empty()) break;
      if (rounds == max_rounds) throw still_crossing(found);
      cut_where_they_meet(found);
      cut_at_hot_points();
      share_with_copies(cuts_, found);
      if (!apply_cuts()) take_detours(found);
      lay_pieces();
      ++rounds;
    }
    if (rounds > 0) number_segments();
    const std::size_t made = work_.points.size() - input_.points.size();
    return {std::move(work_), std::move(of_), made, on_segments_, rounds};
  }

 private:
  Point at(VertexId v) const { return work_.points[v.index()]; }
  const Segment& piece(SegmentId s) const { return work_.segments[s.index()]; }
  const Segment& whole(std::size_t piece) const { return input_.segments[of_[piece].index()]; }

  void number_segments() {
    work_.segment_numbers.clear();
    for (const SegmentId s : of_) work_.segment_numbers.push_back(input_.segment_number(s));
  }

  void cut_where_they_meet(const SegmentMeetings& found) {
    cuts_.clear();
    crossings_.clear();
    hot_.clear();
    moving_.clear();
    moves_.assign(work_.segments.size(), false);
    for (const SegmentPair& pair : found.pairs) {
      if (pair.meeting == SegmentMeeting::crossing) {
        cut_at_crossing(pair);
      } else {
        cut_at_ends(pair.first, pair.second);
        cut_at_ends(pair.second, pair.first);
      }
    }
    for (const auto& [v, s] : found.points_on_segments) cut(s, v);
  }

  void cut(SegmentId s, VertexId v) { cuts_.push_back({s.index(), v}); }

  void cut_at_ends(SegmentId of, SegmentId s) {
    const Point a = at(piece(s).a), b = at(piece(s).b);
    for (const VertexId v : {piece(of).a, piece(of).b}) {
      if (at(v) != a && at(v) != b && is_on_segment(at(v), a, b)) cut(s, v);
    }
  }

  // At the rounded crossing; where that is not between the ends of a piece, at the end next to it.
  void cut_at_crossing(const SegmentPair& pair) {
    const Segment &r = piece(pair.first), &s = piece(pair.second);
    VertexId v = vertex_at(crossing_point(at(r.a), at(r.b), at(s.a), at(s.b)));
    v = not_beyond_ends(r, v);
    v = not_beyond_ends(s, v);
    for (const SegmentId id : {pair.first, pair.second}) {
      if (not_beyond_ends(piece(id), v) == v) cut(id, v);
      crossings_.push_back({id.index(), v});
      move(id.index());
    }
    hot_.push_back(v);
  }

  VertexId not_beyond_ends(const Segment& s, VertexId v) const {
    if (order_along(at(s.a), at(s.b), at(s.a), at(v)) <= 0) return s.a;
    if (order_along(at(s.a), at(s.b), at(v), at(s.b)) <= 0) return s.b;
    return v;
  }

  VertexId vertex_at(Point p) {
    if (vertex_at_.empty()) {
      vertex_at_.reserve(2 * work_.points.size());
      for (std::size_t i = 0; i < work_.points.size(); ++i) {
        vertex_at_.try_emplace(work_.points[i], i);
      }
    }
    const auto [known, is_new] = vertex_at_.try_emplace(p, work_.points.size());
    if (is_new) {
      work_.points.push_back(p);
      if (!work_.point_numbers.empty()) work_.point_numbers.push_back(next_number_++);
    }
    return known->second;
  }

  // Where a piece is cut at a rounded point it moves, by less than a pixel. So that nothing slips
  // from one side of a point to the other, a piece that moves is cut at all points whose pixel it
  // meets, and there every other piece that meets that pixel, which then moves as well.
  void cut_at_hot_points() {
    if (hot_.empty()) return;
    const std::vector<Cut> meets = pieces_and_pixels();
    std::vector<Cut> by_point = meets;
    std::ranges::sort(by_point, {}, [](const Cut& c) { return std::pair(c.at, c.piece); });
    std::vector<bool> is_hot(work_.points.size(), false);
    for (const VertexId v : hot_) is_hot[v.index()] = true;
    while (!hot_.empty() || !moving_.empty()) {  // each point and each piece is taken once
      if (!hot_.empty()) {
        const VertexId v = hot_.back();
        hot_.pop_back();
        auto c = std::ranges::lower_bound(by_point, v, {}, &Cut::at);
        for (; c != by_point.end() && c->at == v; ++c) {
          cut(SegmentId(c->piece), v);
          move(c->piece);
        }
      } else {
        const std::size_t piece = moving_.back();
        moving_.pop_back();
        auto c = std::ranges::lower_bound(meets, piece, {}, &Cut::piece);
        for (; c != meets.end() && c->piece == piece; ++c) {
          if (!is_hot[c->at.index()]) hot_.push_back(c->at);
          is_hot[c->at.index()] = true;
        }
      }
    }
  }

  void move(std::size_t piece) {
    if (!moves_[piece]) moving_.push_back(piece);
    moves_[piece] = true;
  }

  // Which piece meets the pixel of which point, apart from its ends; in order.
  std::vector<Cut> pieces_and_pixels() {
    std::vector<Strip> strips;
    for (const Segment& s : work_.segments) strips.push_back({at(s.a), at(s.b)});
    const std::size_t pieces = strips.size();
    for (const Point p : work_.points) strips.push_back({p, p, reach(p)});
    std::vector<Cut> meets;
    for_each_near_pair(strips, [&](std::uint32_t i, std::uint32_t j) {
      if (i >= pieces || j < pieces) return true;
      const VertexId v(j - pieces);
      if (is_between(whole(i), v) && meets_pixel(i, v) && vertex_at(at(v)) == v) {
        meets.push_back({i, v});
      }
      return true;
    });
    std::ranges::sort(meets);
    meets.erase(std::unique(meets.begin(), meets.end()), meets.end());
    return meets;
  }

  // The unmoved segment or the piece as it is now.
  bool meets_pixel(std::size_t i, VertexId v) const {
    const Segment &s = work_.segments[i], &unmoved = whole(i);
    if (at(v) == at(s.a) || at(v) == at(s.b)) return false;
    return lepp::meets_pixel(at(s.a), at(s.b), at(v)) ||
           lepp::meets_pixel(at(unmoved.a), at(unmoved.b), at(v));
  }

  bool is_between(const Segment& s, VertexId v) const {
    return order_along(at(s.a), at(s.b), at(s.a), at(v)) > 0 &&
           order_along(at(s.a), at(s.b), at(v), at(s.b)) > 0;
  }

  // A segment that repeats another is cut where that is.
  static void share_with_copies(std::vector<Cut>& cuts, const SegmentMeetings& found) {
    sort_without_copies(cuts);
    std::vector<Cut> shared;
    for (const auto& [first, copy] : found.repeated_segments) {
      auto cut = std::ranges::lower_bound(cuts, first.index(), {}, &Cut::piece);
      for (; cut != cuts.end() && cut->piece == first.index(); ++cut) {
        shared.push_back({copy.index(), cut->at});
      }
    }
    cuts.insert(cuts.end(), shared.begin(), shared.end());
    sort_without_copies(cuts);
  }

  static void sort_without_copies(std::vector<Cut>& cuts) {
    std::ranges::sort(cuts);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  }

  // False if no track has to pass anything new.
  bool apply_cuts() {
    bool any = false;
    for (const Cut& cut : cuts_) {
      const Segment& unmoved = whole(cut.piece);
      if (!is_between(unmoved, cut.at)) continue;
      auto& passes = tracks_[of_[cut.piece].index()].passes;
      const auto here = std::ranges::lower_bound(
          passes, cut.at, [&](VertexId p, VertexId q) { return comes_before(unmoved, p, q); });
      if (here != passes.end() && at(*here) == at(cut.at)) continue;
      passes.insert(here, cut.at);
      any = true;
      if (cut.at.index() < input_.points.size()) ++on_segments_;
    }
    return any;
  }

  // Pieces that cross where both tracks have been already: those that do not end at the crossing
  // go through it, whatever the order along the segment.
  void take_detours(const SegmentMeetings& found) {
    share_with_copies(crossings_, found);
    for (const Cut& crossing : crossings_) {
      const Segment& s = work_.segments[crossing.piece];
      if (at(crossing.at) == at(s.a) || at(crossing.at) == at(s.b)) continue;
      tracks_[of_[crossing.piece].index()].detours.push_back({s.a, s.b, crossing.at});
    }
  }

  bool comes_before(const Segment& s, VertexId p, VertexId q) const {
    const int order = order_along(at(s.a), at(s.b), at(p), at(q));
    return order != 0 ? order > 0 : at(p) < at(q);
  }

  void lay_pieces() {
    work_.segments.clear();
    of_.clear();
    for (const Track& track : tracks_) {
      const Segment& s = input_.segments[track.segment.index()];
      if (track.passes.empty() && track.detours.empty()) {
        work_.segments.push_back(s);
      } else {
        const std::vector<VertexId> vertices = chain(track, s);
        for (std::size_t i = 1; i < vertices.size(); ++i) {
          const VertexId a = vertices[i - 1], b = vertices[i];
          work_.segments.push_back({a, b, s.curve, parameter(s, a), parameter(s, b)});
        }
      }
      of_.resize(work_.segments.size(), track.segment);
    }
  }

  double parameter(const Segment& s, VertexId v) const {
    if (v == s.a) return s.t_a;
    if (v == s.b) return s.t_b;
    const double length = squared_distance(at(s.a), at(s.b));
    const double share = std::min(1.0, std::sqrt(squared_distance(at(s.a), at(v)) / length));
    return s.t_a + share * (s.t_b - s.t_a);
  }

  InputError still_crossing(const SegmentMeetings& found) const {
    const auto name = [&](SegmentId s) { return input_.segment_name(of_[s.index()]); };
    if (found.pairs.empty()) {
      const auto& [v, s] = found.points_on_segments.front();
      return {input_.source, name(s) + " passes too close to the point at " + to_text(at(v)),
              "move or merge the points there"};
    }
    const SegmentPair& pair = found.pairs.front();
    return {input_.source,
            name(pair.first) + " and " + name(pair.second) + " cross at " +
                to_text(meeting_point(work_, pair)) + ", too close to other points to split",
            "move or merge the points there"};
  }

  const Pslg& input_;
  Pslg work_;
  std::vector<Track> tracks_;
  std::vector<SegmentId> of_;  // for each piece in work_ the segment in input_
  std::unordered_map<Point, VertexId, HashOfPoint> vertex_at_;
  std::vector<Cut> cuts_, crossings_;  // of this round
  std::vector<VertexId> hot_;          // points where pieces were cut, to be dealt with
  std::vector<std::size_t> moving_;    // pieces that were cut at a rounded point, likewise
  std::vector<bool> moves_;            // of each piece: it is or was in moving_
  std::int64_t next_number_ = 0;
  std::size_t on_segments_ = 0;
};

}  // namespace

SplitPslg split_crossings(const Pslg& pslg) { return Splitter(pslg).run(); }

}  // namespace lepp

#include "lepp/terrain/snap_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "lepp/terrain/cell_buckets.hpp"
#include "lepp/terrain/sample_space.hpp"

namespace lepp {

namespace {

constexpr int most_rounds = 6;
// Nobody is told of moves shorter than this, in cells: they are those of rounding.
constexpr double noticeable = 0x1p-20;

double part_of_way(Point a, Point b, Point p) { return dot(p - a, b - a) / squared_distance(a, b); }

double distance(Point a, Point b) { return std::sqrt(squared_distance(a, b)); }

// A place on a segment, and how far what made it is away.
struct Foot {
  double part, distance;
  Point place;
};

Foot foot_on(Point a, Point b, Point p) {
  const double part = std::clamp(part_of_way(a, b, p), 0.0, 1.0);
  Point place = a + part * (b - a);
  if (a.x == b.x) place.x = a.x;
  if (a.y == b.y) place.y = a.y;
  return {part, distance(place, p), place};
}

class Snapper {
 public:
  Snapper(const HeightGrid& grid, LineGraph& graph)
      : grid_(grid),
        graph_(graph),
        points_(graph.pslg.points),
        reach_(meeting_distance * std::min(1.0, grid.aspect())) {
    for (const Segment& s : graph.pslg.segments) {
      if (!is_outline(s)) continue;
      corners_.push_back(points_[s.a.index()]);
      corners_.push_back(points_[s.b.index()]);
    }
    std::ranges::sort(corners_);
  }

  std::size_t run() {
    cut_where_lines_meet(grid_, graph_);
    for (int round = 0; round < most_rounds; ++round) {
      const bool points_joined = join_points(), segments_bent = bend_segments();
      if (!points_joined && !segments_bent) break;
      cut_where_lines_meet(grid_, graph_);
    }
    return moved_;
  }

 private:
  Point point(VertexId v) const { return points_[v.index()]; }
  bool is_fixed(Point p) const {
    return std::ranges::binary_search(corners_, p) || sample_at(grid_, p);
  }
  void note(double distance) { moved_ += distance > noticeable ? 1 : 0; }

  // The sample with data nearest to `p`.
  std::optional<Point> sample_near(Point p) const {
    const double column = std::round(p.x), line = std::round(p.y / grid_.aspect());
    if (column < 0 || line < 0 || column >= grid_.columns || line >= grid_.rows)
      return std::nullopt;
    const auto c = static_cast<std::uint32_t>(column), l = static_cast<std::uint32_t>(line);
    if (!grid_.has_data(c, grid_.row_of_line(l))) return std::nullopt;
    return grid_.sample(c, l);
  }

  // ---- points -----------------------------------------------------------------------------------

  // Each becomes the sample, the point before it, or the place on the outline that it is near.
  bool join_points() {
    before_ = points_;
    becomes_.clear();
    for (std::size_t i = 0; i < points_.size(); ++i) becomes_.push_back(VertexId(i));
    on_outline_.assign(points_.size(), false);
    kept_.emplace(grid_);
    outline_.emplace(grid_);
    join_cuts_of_outline();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (on_outline_[i] && becomes_[i] == VertexId(i)) kept_->add(points_[i], number(i));
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!on_outline_[i] && kept_->has(points_[i])) join_point(VertexId(i));
    }
    return apply_joins();
  }

  static std::uint32_t number(std::size_t i) { return static_cast<std::uint32_t>(i); }

  VertexId end_of(VertexId v) const {
    while (becomes_[v.index()] != v) v = becomes_[v.index()];
    return v;
  }

  // On the outline a cut can only move along it, to the next corner or cut.
  void join_cuts_of_outline() {
    for (std::size_t i = 0; i < graph_.pslg.segments.size(); ++i) {
      const Segment& s = graph_.pslg.segments[i];
      if (!is_outline(s)) continue;
      on_outline_[s.a.index()] = on_outline_[s.b.index()] = true;
      outline_->add(point(s.a), point(s.b), reach_, number(i));
      const VertexId a = end_of(s.a), b = end_of(s.b);
      if (a == b || distance(point(a), point(b)) > reach_) continue;
      if (!is_fixed(point(b))) becomes_[b.index()] = a;
      else if (!is_fixed(point(a))) becomes_[a.index()] = b;
    }
  }

  void join_point(VertexId v) {
    Point& p = points_[v.index()];
    const auto sample = sample_near(p);
    if (sample && distance(*sample, p) <= reach_) p = *sample;
    else if (!nearest_kept(p, true)) p = on_outline(p);
    if (const auto other = nearest_kept(p, false)) becomes_[v.index()] = *other;
    else kept_->add(p, v.value);
  }

  std::optional<VertexId> nearest_kept(Point p, bool of_outline) const {
    std::optional<VertexId> nearest;
    double least = reach_;
    kept_->near(p, reach_, [&](std::uint32_t k) {
      const double d = distance(points_[k], p);
      if (d > least || (of_outline && !on_outline_[k])) return;
      if (nearest && d == least) return;
      nearest = VertexId(k);
      least = d;
    });
    return nearest;
  }

  // The place on the outline nearest to `p`, if that is near.
  Point on_outline(Point p) const {
    Point nearest = p;
    double least = reach_;
    outline_->near(p, reach_, [&](std::uint32_t i) {
      const Segment& s = graph_.pslg.segments[i];
      const Foot foot = foot_on(point(s.a), point(s.b), p);
      if (foot.distance >= least) return;
      nearest = foot.place;
      least = foot.distance;
    });
    return nearest;
  }

  bool apply_joins() {
    bool changed = false;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point p = point(end_of(VertexId(i)));
      if (p == before_[i] && becomes_[i] == VertexId(i)) continue;
      changed = true;
      note(distance(p, before_[i]));
    }
    if (!changed) return false;
    const Pslg old = std::exchange(graph_.pslg, {});
    const std::vector<EndHeights> heights = std::exchange(graph_.heights, {});
    graph_.pslg.points = old.points;
    graph_.pslg.entities = old.entities;
    graph_.pslg.source = old.source;
    for (std::size_t i = 0; i < old.segments.size(); ++i) {
      const Segment& s = old.segments[i];
      add_piece(graph_, end_of(s.a), end_of(s.b), *s.curve, heights[i], 0, 1);
    }
    return true;
  }

  // ---- segments ---------------------------------------------------------------------------------

  struct Cut {
    double part;
    VertexId at;
  };

  // A line that passes a point or a sample is led through it.
  bool bend_segments() {
    CellBuckets points(grid_);
    for (const Segment& s : graph_.pslg.segments) {
      points.add(point(s.a), s.a.value);
      points.add(point(s.b), s.b.value);
    }
    const std::vector<Segment> segments = std::exchange(graph_.pslg.segments, {});
    const std::vector<EndHeights> heights = std::exchange(graph_.heights, {});
    for (std::size_t i = 0; i < segments.size(); ++i) {
      add_cut_up(segments[i], heights[i], cuts_of(segments[i], points));
    }
    return graph_.pslg.segments.size() != segments.size();
  }

  std::vector<Cut> cuts_of(const Segment& s, const CellBuckets& points) {
    std::vector<Cut> cuts;
    const Point a = point(s.a), b = point(s.b);
    const double reach = is_outline(s) ? same_place : reach_;
    points.near(a, b, reach, [&](std::uint32_t k) {
      const Point p = points_[k];
      if (p == a || p == b) return;
      const Foot foot = foot_on(a, b, p);
      if (foot.distance > reach || !is_between(a, b, p, reach)) return;
      if (std::ranges::find(cuts, VertexId(k), &Cut::at) != cuts.end()) return;
      cuts.push_back({foot.part, VertexId(k)});
      note(foot.distance);
    });
    if (is_outline(s)) add_samples_beside(a, b, cuts);
    else add_samples_passed(a, b, cuts);
    std::ranges::sort(cuts, {}, [](const Cut& c) { return std::pair(c.part, c.at); });
    return cuts;
  }

  // Near an end only a point that is there already can be, and the two stay apart.
  static bool is_between(Point a, Point b, Point p, double reach) {
    return std::min(squared_distance(a, p), squared_distance(p, b)) > reach * reach;
  }

  void add_samples_beside(Point a, Point b, std::vector<Cut>& cuts) {
    const std::size_t count = cuts.size();
    std::vector<double> parts;
    for (const Cut& cut : cuts) parts.push_back(cut.part);
    for (std::size_t i = 0; i < count; ++i) {
      for (const auto& [part, place] : samples_beside(grid_, a, b, cuts[i].part)) {
        const auto is_there = [part = part](double p) { return std::abs(p - part) < 1e-12; };
        if (std::ranges::any_of(parts, is_there)) continue;
        parts.push_back(part);
        points_.push_back(place);
        cuts.push_back({part, VertexId(points_.size() - 1)});
      }
    }
  }

  // Column by column, or line by line.
  void add_samples_passed(Point a, Point b, std::vector<Cut>& cuts) {
    const double aspect = grid_.aspect();
    const bool is_wide = std::abs(b.x - a.x) >= std::abs(b.y - a.y) / aspect;
    const auto along = [&](Point p) { return is_wide ? p.x : p.y / aspect; };
    const auto [low, high] = std::minmax({along(a), along(b)});
    const double last = std::min(high, (is_wide ? grid_.columns : grid_.rows) - 1.0);
    const std::size_t count = cuts.size();
    for (double k = std::max(std::ceil(low), 0.0); k <= last; ++k) {
      const double part = (k - along(a)) / (along(b) - along(a));
      const auto sample = sample_near(a + part * (b - a));
      if (!sample || !is_between(a, b, *sample, reach_)) continue;
      const Foot foot = foot_on(a, b, *sample);
      if (foot.distance > reach_ || foot.distance <= same_place) continue;
      const auto end = cuts.begin() + static_cast<std::ptrdiff_t>(count);
      if (std::any_of(cuts.begin(), end, [&](const Cut& c) { return point(c.at) == *sample; }))
        continue;
      points_.push_back(*sample);
      cuts.push_back({foot.part, VertexId(points_.size() - 1)});
      note(foot.distance);
    }
  }

  void add_cut_up(const Segment& s, const EndHeights& heights, const std::vector<Cut>& cuts) {
    Cut last{0, s.a};
    for (const Cut& cut : cuts) {
      add_piece(graph_, last.at, cut.at, *s.curve, heights, last.part, cut.part);
      last = cut;
    }
    add_piece(graph_, last.at, s.b, *s.curve, heights, last.part, 1);
  }

  const HeightGrid& grid_;
  LineGraph& graph_;
  std::vector<Point>& points_;
  double reach_;                // in grid space
  std::vector<Point> corners_;  // of the outline, ascending
  std::size_t moved_ = 0;

  // Of the round in hand.
  std::vector<Point> before_;
  std::vector<VertexId> becomes_;
  std::vector<bool> on_outline_;
  std::optional<CellBuckets> kept_;     // points
  std::optional<CellBuckets> outline_;  // segments
};

}  // namespace

std::size_t snap_lines(const HeightGrid& grid, LineGraph& graph) {
  return Snapper(grid, graph).run();
}

}  // namespace lepp

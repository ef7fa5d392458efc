#include "lepp/terrain/domain_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/split_crossings.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/terrain/near_lines.hpp"

namespace lepp {

namespace {

constexpr double snap_tolerance = 0x1p-20;  // of a cell
constexpr double unset = std::numeric_limits<double>::quiet_NaN();

double snapped(double x) {
  const double whole = std::round(x);
  return std::abs(x - whole) <= snap_tolerance ? whole : x;
}

std::string name_of(const Breakline& line, std::size_t i) {
  return line.name.empty() ? "breakline " + std::to_string(i + 1) : line.name;
}

std::string name_of_ring(std::size_t polygon, std::size_t ring) {
  return "clip polygon " + std::to_string(polygon + 1) + ", ring " + std::to_string(ring + 1);
}

class Arranger {
 public:
  Arranger(const HeightGrid& grid, const Pslg& outline)
      : grid_(grid), outline_(outline), number_(outline.points.size(), none), near_(grid) {
    pslg_.source = outline.source;
    pslg_.entities = outline.entities;
    kind_.push_back(LineKind::outline);
  }

  Arrangement run(const DomainOptions& options) {
    for (std::size_t i = 0; i < options.breaklines.size(); ++i)
      add_breakline(options.breaklines[i], name_of(options.breaklines[i], i));
    for (std::size_t i = 0; i < options.clip.size(); ++i) {
      const CurveId curve = add_curve(LineKind::clip);
      for (std::size_t r = 0; r < options.clip[i].rings.size(); ++r)
        add_ring(options.clip[i].rings[r], curve, name_of_ring(i, r));
    }
    for (const Segment& s : outline_.segments) {
      if (is_near(s)) add_outline(s, pslg_);
    }
    heights_.resize(pslg_.segments.size());
    SplitPslg split = split_crossings(pslg_);
    if (add_samples_beside_cuts(split)) split = split_crossings(pslg_);
    std::vector<double> heights = heights_of_points(split);
    for (const Segment& s : outline_.segments) {
      if (!is_near(s)) add_outline(s, split.pslg);
    }
    heights.resize(split.pslg.points.size(), unset);
    split.pslg.segment_numbers.clear();
    return {std::move(split.pslg), std::move(kind_), std::move(heights)};
  }

 private:
  // What the line asks for at the ends of a segment, or nothing.
  struct EndHeights {
    double a = unset, b = unset;
  };

  CurveId add_curve(LineKind kind) {
    CurveEntity& curve = pslg_.entities.curves.emplace_back();
    curve.tag = static_cast<int>(pslg_.entities.curves.size());
    kind_.push_back(kind);
    return CurveId(kind_.size() - 1);
  }

  Point place(Point world, const std::string& name) const {
    if (!std::isfinite(world.x) || !std::isfinite(world.y))
      throw InputError(name, "has a coordinate that is not finite", "correct it");
    const Point p = grid_.to_grid(world);
    if (std::max(std::abs(p.x), std::abs(p.y)) > max_coordinate)
      throw InputError(name, "has a coordinate far beyond the grid, at " + to_text(world),
                       "correct it");
    return {snapped(p.x), snapped(p.y / grid_.aspect()) * grid_.aspect()};
  }

  void add_segment(std::size_t a, std::size_t b, CurveId curve, EndHeights heights) {
    pslg_.segments.push_back({VertexId(a), VertexId(b), curve});
    heights_.push_back(heights);
    near_.add(pslg_.points[a], pslg_.points[b]);
  }

  bool is_near(const Segment& s) const {
    return near_.is_near(outline_.points[s.a.index()], outline_.points[s.b.index()]);
  }

  // A segment of the outline, which no line can cut unless it is near one.
  void add_outline(const Segment& s, Pslg& to) {
    const auto vertex = [&](VertexId v) {
      std::uint32_t& number = number_[v.index()];
      if (number == none) {
        number = static_cast<std::uint32_t>(to.points.size());
        to.points.push_back(outline_.points[v.index()]);
      }
      return VertexId(number);
    };
    const VertexId a = vertex(s.a), b = vertex(s.b);
    to.segments.push_back({a, b, s.curve});
  }

  void add_breakline(const Breakline& line, const std::string& name) {
    const CurveId curve = add_curve(LineKind::breakline);
    const bool hard = !line.heights.empty();
    if (hard && line.heights.size() != line.points.size()) {
      throw InputError(name,
                       "has " + std::to_string(line.points.size()) + " points and " +
                           std::to_string(line.heights.size()) + " heights",
                       "give one height per point, or none");
    }
    double previous = unset;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const double height = hard ? line.heights[i] : unset;
      if (hard && !std::isfinite(height))
        throw InputError(name, "has a height that is not finite", "correct it, or give none");
      const Point p = place(line.points[i], name);
      if (i > 0 && p == pslg_.points.back()) continue;
      pslg_.points.push_back(p);
      const std::size_t last = pslg_.points.size() - 1;
      if (i > 0) add_segment(last - 1, last, curve, {previous, height});
      previous = height;
    }
  }

  void add_ring(const std::vector<Point>& ring, CurveId curve, const std::string& name) {
    const std::size_t first = pslg_.points.size();
    for (const Point world : ring) {
      const Point p = place(world, name);
      if (pslg_.points.size() == first || p != pslg_.points.back()) pslg_.points.push_back(p);
    }
    if (pslg_.points.size() > first + 1 && pslg_.points.back() == pslg_.points[first])
      pslg_.points.pop_back();
    const std::size_t count = pslg_.points.size() - first;
    if (count < 3) {
      throw InputError(name, "has " + std::to_string(count) + " places, which close off no area",
                       "give at least three");
    }
    for (std::size_t i = 0; i < count; ++i)
      add_segment(first + i, first + (i + 1) % count, curve, {});
  }

  // A cut is rounded, so it may bend a slanting segment of the outline away from samples on it. The
  // two samples on either side of a cut become points, then no piece that moves has any.
  // False if none were needed.
  bool add_samples_beside_cuts(const SplitPslg& split) {
    const std::size_t before = pslg_.points.size();
    for (std::size_t i = 1; i < split.segment_of.size(); ++i) {
      if (split.segment_of[i] != split.segment_of[i - 1]) continue;  // no cut between the two
      const Segment& s = pslg_.segments[split.segment_of[i].index()];
      if (s.curve == CurveId(0U)) add_samples_beside(s, split.pslg.segments[i].t_a);
    }
    return pslg_.points.size() != before;
  }

  void add_samples_beside(const Segment& s, double t) {
    const auto a = sample_at(pslg_.points[s.a.index()]), b = sample_at(pslg_.points[s.b.index()]);
    if (!a || !b) return;  // around an island
    const std::int64_t columns = b->first - a->first, lines = b->second - a->second;
    const std::int64_t pieces = std::gcd(columns, lines);
    if (columns == 0 || lines == 0 || pieces == 1) return;
    const auto piece = static_cast<std::int64_t>(t * double(pieces));
    for (std::int64_t k = std::max<std::int64_t>(piece - 1, 1); k <= piece + 2 && k < pieces; ++k) {
      pslg_.points.push_back(
          grid_.sample(static_cast<std::uint32_t>(a->first + k * (columns / pieces)),
                       static_cast<std::uint32_t>(a->second + k * (lines / pieces))));
    }
  }

  // Column and line, of a sample.
  std::optional<std::pair<std::int64_t, std::int64_t>> sample_at(Point p) const {
    const double line = p.y / grid_.aspect();
    if (p.x != std::round(p.x) || line != std::round(line)) return std::nullopt;
    return std::pair(static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(line));
  }

  // Along each hard segment; the parameters of its pieces run from 0 to 1.
  std::vector<double> heights_of_points(const SplitPslg& split) const {
    std::vector<double> heights(split.pslg.points.size(), unset);
    for (std::size_t i = 0; i < split.pslg.segments.size(); ++i) {
      const Segment& piece = split.pslg.segments[i];
      const EndHeights& ends = heights_[split.segment_of[i].index()];
      if (std::isnan(ends.a)) continue;
      for (const auto& [v, t] : {std::pair(piece.a, piece.t_a), std::pair(piece.b, piece.t_b)}) {
        double& height = heights[v.index()];
        if (std::isnan(height)) height = t == 1 ? ends.b : ends.a + t * (ends.b - ends.a);
      }
    }
    return heights;
  }

  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  const HeightGrid& grid_;
  const Pslg& outline_;
  std::vector<std::uint32_t> number_;  // of each point of the outline
  NearLines near_;
  Pslg pslg_;  // the lines and what of the outline is near them
  std::vector<LineKind> kind_;
  std::vector<EndHeights> heights_;  // one per segment
};

}  // namespace

Arrangement arrange(const HeightGrid& grid, const Pslg& outline, const DomainOptions& options) {
  return Arranger(grid, outline).run(options);
}

}  // namespace lepp

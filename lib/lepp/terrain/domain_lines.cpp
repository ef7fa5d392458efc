#include "lepp/terrain/domain_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/terrain/near_lines.hpp"
#include "lepp/terrain/snap_lines.hpp"

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

std::string name_of_ring(const ClipPolygon& polygon, std::size_t i, std::size_t ring) {
  const std::string of =
      polygon.name.empty() ? "clip polygon " + std::to_string(i + 1) : polygon.name;
  return of + ", ring " + std::to_string(ring + 1);
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
        add_ring(options.clip[i].rings[r], curve, name_of_ring(options.clip[i], i, r));
    }
    for (const Segment& s : outline_.segments) {
      if (is_near(s)) add_outline(s);
    }
    graph_.heights.resize(pslg_.segments.size());
    Arrangement result;
    result.places_joined = snap_lines(grid_, graph_);
    number_points();
    for (const Segment& s : outline_.segments) {
      if (!is_near(s)) add_outline(s);
    }
    graph_.heights.resize(pslg_.segments.size());
    result.fixed_heights = heights_of_points();
    for (const EndHeights& h : graph_.heights) result.hard_segments.push_back(!std::isnan(h.a));
    result.pslg = std::move(pslg_);
    result.kind = std::move(kind_);
    return result;
  }

 private:
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
    graph_.heights.push_back(heights);
    near_.add(pslg_.points[a], pslg_.points[b]);
  }

  bool is_near(const Segment& s) const {
    return near_.is_near(outline_.points[s.a.index()], outline_.points[s.b.index()]);
  }

  void add_outline(const Segment& s) {
    const auto vertex = [&](VertexId v) {
      std::uint32_t& number = number_[v.index()];
      if (number == none) {
        number = static_cast<std::uint32_t>(pslg_.points.size());
        pslg_.points.push_back(outline_.points[v.index()]);
      }
      return VertexId(number);
    };
    const VertexId a = vertex(s.a), b = vertex(s.b);
    pslg_.segments.push_back({a, b, s.curve});
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

  // The outline's points are where they were, but have other numbers.
  void number_points() {
    std::map<Point, VertexId> at;
    for (const Segment& s : pslg_.segments) {
      if (!is_outline(s)) continue;
      for (const VertexId v : {s.a, s.b}) at.emplace(pslg_.points[v.index()], v);
    }
    for (std::size_t i = 0; i < number_.size(); ++i) {
      if (number_[i] != none) number_[i] = at.at(outline_.points[i]).value;
    }
  }

  // Where two hard lines meet, the first one counts.
  std::vector<double> heights_of_points() const {
    std::vector<double> heights(pslg_.points.size(), unset);
    for (std::size_t i = 0; i < pslg_.segments.size(); ++i) {
      const Segment& s = pslg_.segments[i];
      for (const auto& [v, height] :
           {std::pair(s.a, graph_.heights[i].a), std::pair(s.b, graph_.heights[i].b)}) {
        if (std::isnan(heights[v.index()])) heights[v.index()] = height;
      }
    }
    return heights;
  }

  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  const HeightGrid& grid_;
  const Pslg& outline_;
  std::vector<std::uint32_t> number_;  // of each point of the outline
  NearLines near_;
  LineGraph graph_;  // the lines and what of the outline is near them, then all of it
  Pslg& pslg_ = graph_.pslg;
  std::vector<LineKind> kind_;
};

}  // namespace

Arrangement arrange(const HeightGrid& grid, const Pslg& outline, const DomainOptions& options) {
  return Arranger(grid, outline).run(options);
}

}  // namespace lepp

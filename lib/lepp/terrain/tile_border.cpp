#include "lepp/terrain/tile_border.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace lepp {

namespace {

using Samples = std::vector<std::uint32_t>;

bool is_close(std::span<const double> heights, std::uint32_t a, std::uint32_t b, double max_error) {
  const double start = heights[a], rise = heights[b] - start;
  for (std::uint32_t i = a + 1; i < b; ++i) {
    const double line = start + rise * (double(i - a) / double(b - a));
    if (!(std::abs(line - heights[i]) <= max_error)) return false;
  }
  return true;
}

// Halves pieces of the run a..b that are not close, or too long beside their neighbours, until none
// is. Each may bring about the other, so both are asked in every turn.
Samples pieces_of(std::span<const double> heights, std::uint32_t a, std::uint32_t b,
                  double max_error) {
  Samples ends{a, b};
  for (bool changed = a < b;
       changed;) {  // ends: each turn adds a sample, and there are finitely many
    changed = false;
    Samples next{a};
    const std::size_t pieces = ends.size() - 1;
    const auto length = [&](std::size_t i) { return ends[i + 1] - ends[i]; };
    for (std::size_t i = 0; i < pieces; ++i) {
      const std::uint32_t before = i == 0 ? 0 : length(i - 1);
      const std::uint32_t after = i + 1 == pieces ? 0 : length(i + 1);
      const bool is_long = length(i) > std::max(1U, 2 * std::min(before, after));
      if (is_long || !is_close(heights, ends[i], ends[i + 1], max_error)) {
        next.push_back(ends[i] + length(i) / 2);
        changed = true;
      }
      next.push_back(ends[i + 1]);
    }
    ends = std::move(next);
  }
  return ends;
}

// One side of the grid: where its samples are.
struct Side {
  Point start, step;
  std::vector<double> heights;

  Point place(std::size_t i) const { return start + double(i) * step; }
  // The index of a place on the side, whole where it is a sample.
  std::optional<double> index_of(Point p) const {
    const Point from_start = p - start;
    if (step.x > 0) return from_start.y == 0 ? std::optional(from_start.x) : std::nullopt;
    return from_start.x == 0 ? std::optional(from_start.y / step.y) : std::nullopt;
  }
};

Side horizontal(const HeightGrid& grid, std::uint32_t line) {
  Side side{grid.sample(0, line), {1, 0}, {}};
  for (std::uint32_t c = 0; c < grid.columns; ++c) {
    side.heights.push_back(grid.height(c, grid.row_of_line(line)));
  }
  return side;
}

Side vertical(const HeightGrid& grid, std::uint32_t column) {
  Side side{grid.sample(column, 0), {0, grid.aspect()}, {}};
  for (std::uint32_t line = 0; line < grid.rows; ++line) {
    side.heights.push_back(grid.height(column, grid.row_of_line(line)));
  }
  return side;
}

class Borders {
 public:
  Borders(TerrainDomain& domain, double max_error) : domain_(domain), max_error_(max_error) {
    const auto& points = domain.pslg.points;
    for (std::size_t i = 0; i < points.size(); ++i) at_.emplace(points[i], VertexId(i));
    domain.kept_border.assign(points.size(), false);
    domain.fixed_heights.resize(points.size(), std::numeric_limits<double>::quiet_NaN());
  }

  void fix(const Side& side, const Samples& corners) {
    const Samples samples = border_samples(side.heights, max_error_, corners);
    std::vector<Segment> segments;
    std::vector<bool> hard;
    for (std::size_t i = 0; i < domain_.pslg.segments.size(); ++i) {
      const std::size_t before = segments.size();
      cut(domain_.pslg.segments[i], side, samples, segments);
      const bool is_whole = segments.size() == before + 1;  // else its heights are the border's
      if (!domain_.hard_segments.empty())
        hard.resize(segments.size(), is_whole && domain_.hard_segments[i]);
    }
    domain_.pslg.segments = std::move(segments);
    domain_.hard_segments = std::move(hard);
  }

 private:
  // Appends the pieces of a segment.
  void cut(const Segment& s, const Side& side, const Samples& samples,
           std::vector<Segment>& pieces) {
    const auto a = side.index_of(domain_.pslg.points[s.a.index()]);
    const auto b = side.index_of(domain_.pslg.points[s.b.index()]);
    if (!a || !b) {
      pieces.push_back(s);
      return;
    }
    const auto t_at = [&](double i) { return s.t_a + (s.t_b - s.t_a) * ((i - *a) / (*b - *a)); };
    Segment piece = s;
    const auto [low, high] = std::minmax(*a, *b);
    auto first = std::ranges::upper_bound(samples, low, {}, [](auto i) { return double(i); });
    auto last = std::ranges::lower_bound(samples, high, {}, [](auto i) { return double(i); });
    Samples between(first, last);
    if (*b < *a) std::ranges::reverse(between);
    for (const std::uint32_t i : between) {
      piece.b = vertex_at(side.place(i));
      piece.t_b = t_at(i);
      pieces.push_back(piece);
      piece.a = piece.b;
      piece.t_a = piece.t_b;
    }
    piece.b = s.b;
    piece.t_b = s.t_b;
    pieces.push_back(piece);
    domain_.kept_border[s.a.index()] = domain_.kept_border[s.b.index()] = true;
  }

  VertexId vertex_at(Point p) {
    const auto [found, is_new] = at_.emplace(p, VertexId(domain_.pslg.points.size()));
    if (is_new) {
      domain_.pslg.points.push_back(p);
      domain_.fixed_heights.push_back(std::numeric_limits<double>::quiet_NaN());
      domain_.kept_border.push_back(true);
    }
    domain_.kept_border[found->second.index()] = true;
    return found->second;
  }

  TerrainDomain& domain_;
  double max_error_;
  std::map<Point, VertexId> at_;
};

}  // namespace

std::vector<std::uint32_t> border_samples(std::span<const double> heights, double max_error,
                                          std::span<const std::uint32_t> corners) {
  Samples samples;
  const auto n = static_cast<std::uint32_t>(heights.size());
  for (std::uint32_t first = 0; first < n; ++first) {
    if (std::isnan(heights[first])) continue;
    samples.push_back(first);
    while (first + 1 < n && !std::isnan(heights[first + 1])) {  // a run, from corner to corner
      std::uint32_t last = first + 1;
      const auto is_corner = [&](std::uint32_t i) {
        return std::ranges::binary_search(corners, i);
      };
      while (last + 1 < n && !std::isnan(heights[last + 1]) && !is_corner(last)) ++last;
      const Samples run = pieces_of(heights, first, last, max_error);
      samples.insert(samples.end(), run.begin() + 1, run.end());
      first = last;
    }
  }
  return samples;
}

BorderCorners border_corners(const GridPart& part) {
  BorderCorners corners;
  for (const GridSide side : {GridSide::south, GridSide::east, GridSide::north, GridSide::west}) {
    corners[static_cast<std::size_t>(side)] = border_corners(part, side);
  }
  return corners;
}

void fix_borders(const HeightGrid& grid, double max_error, TerrainDomain& domain,
                 const BorderCorners& corners) {
  Borders borders(domain, max_error);
  const auto of = [&](GridSide side) { return corners[static_cast<std::size_t>(side)]; };
  borders.fix(horizontal(grid, 0), of(GridSide::south));
  borders.fix(horizontal(grid, grid.rows - 1), of(GridSide::north));
  borders.fix(vertical(grid, 0), of(GridSide::west));
  borders.fix(vertical(grid, grid.columns - 1), of(GridSide::east));
}

NearBorder::NearBorder(const HeightGrid& grid, const TerrainDomain& domain)
    : corner_(grid.sample(grid.columns - 1, grid.rows - 1)) {
  for (std::size_t i = 0; i < domain.kept_border.size(); ++i) {
    if (!domain.kept_border[i]) continue;
    const Point p = domain.pslg.points[i];
    if (p.x == 0) ends_[0].push_back(p.y);
    if (p.x == corner_.x) ends_[1].push_back(p.y);
    if (p.y == 0) ends_[2].push_back(p.x);
    if (p.y == corner_.y) ends_[3].push_back(p.x);
  }
  for (auto& ends : ends_) std::ranges::sort(ends);
}

bool NearBorder::operator()(Point p) const {
  const std::array<double, 4> distances{p.x, corner_.x - p.x, p.y, corner_.y - p.y};
  for (std::size_t side = 0; side < 4; ++side) {
    const auto& ends = ends_[side];
    const auto after = std::ranges::lower_bound(ends, side < 2 ? p.y : p.x);
    if (after == ends.end()) continue;
    const double before = after == ends.begin() ? *after : *(after - 1);
    const double next = after + 1 == ends.end() ? *after : *(after + 1);
    if (distances[side] <= 2 * (next - before)) return true;
  }
  return false;
}

}  // namespace lepp

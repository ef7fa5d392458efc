#include "lepp/terrain/samples_inside.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "lepp/geometry/predicates.hpp"
#include "lepp/terrain/line_graph.hpp"

namespace lepp {

namespace {

// The first column whose sample on a line is on the edge from `low` up to `high`, or east of it.
std::uint32_t first_beyond(const HeightGrid& grid, Point low, Point high, std::uint32_t line) {
  const auto is_beyond = [&](std::uint32_t column) {
    return orient2d(low, high, grid.sample(column, line)) <= 0;
  };
  const double part = (grid.sample(0, line).y - low.y) / (high.y - low.y);
  const double x = std::ceil(low.x + part * (high.x - low.x));
  auto column = static_cast<std::uint32_t>(std::clamp(x, 0.0, double(grid.columns)));
  while (column > 0 && is_beyond(column - 1)) --column;
  while (column < grid.columns && !is_beyond(column)) ++column;
  return column;
}

// The lines from `low` up to before `high`.
std::pair<std::uint32_t, std::uint32_t> lines_between(const HeightGrid& grid, double low,
                                                      double high) {
  const auto first_from = [&](double y) {
    const double near = std::clamp(std::ceil(y / grid.aspect()), 0.0, double(grid.rows));
    auto line = static_cast<std::uint32_t>(near);
    while (line > 0 && grid.sample(0, line - 1).y >= y) --line;
    while (line < grid.rows && grid.sample(0, line).y < y) ++line;
    return line;
  };
  return {first_from(low), first_from(high)};
}

}  // namespace

SampleSet samples_inside(const HeightGrid& grid, const TerrainDomain& domain) {
  std::vector<std::vector<std::uint32_t>> firsts(grid.rows);  // by line
  for (const Segment& s : domain.pslg.segments) {
    if (!is_outline(s)) continue;
    Point low = domain.pslg.points[s.a.index()], high = domain.pslg.points[s.b.index()];
    if (low.y > high.y) std::swap(low, high);
    const auto [first, end] = lines_between(grid, low.y, high.y);
    for (std::uint32_t line = first; line < end; ++line) {
      firsts[line].push_back(first_beyond(grid, low, high, line));
    }
  }
  SampleSet inside(grid.size());
  for (std::uint32_t line = 0; line < grid.rows; ++line) {
    auto& of_line = firsts[line];
    std::ranges::sort(of_line);
    const std::size_t start = grid.index(0, grid.row_of_line(line));
    for (std::size_t i = 0; i + 1 < of_line.size(); i += 2) {
      inside.add(start + of_line[i], start + of_line[i + 1]);
    }
  }
  return inside;
}

}  // namespace lepp

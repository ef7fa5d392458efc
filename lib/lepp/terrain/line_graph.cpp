#include "lepp/terrain/line_graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "lepp/geometry/split_crossings.hpp"

namespace lepp {

namespace {

// False if none were needed.
bool add_samples_beside_cuts(const HeightGrid& grid, const SplitPslg& split, Pslg& pslg) {
  const std::size_t before = pslg.points.size();
  for (std::size_t i = 1; i < split.segment_of.size(); ++i) {
    if (split.segment_of[i] != split.segment_of[i - 1]) continue;  // no cut between the two
    const Segment& s = pslg.segments[split.segment_of[i].index()];
    if (!is_outline(s)) continue;
    const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
    for (const auto& beside : samples_beside(grid, a, b, split.pslg.segments[i].t_a)) {
      pslg.points.push_back(beside.second);
    }
  }
  return pslg.points.size() != before;
}

void drop_unused_points(Pslg& pslg) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(pslg.points.size(), unused);
  for (const Segment& s : pslg.segments) number[s.a.index()] = number[s.b.index()] = 0;
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == unused) continue;
    number[i] = next;
    pslg.points[next++] = pslg.points[i];
  }
  pslg.points.resize(next);
  for (Segment& s : pslg.segments) {
    s.a = VertexId(number[s.a.index()]);
    s.b = VertexId(number[s.b.index()]);
  }
}

}  // namespace

std::optional<std::pair<std::int64_t, std::int64_t>> sample_at(const HeightGrid& grid, Point p) {
  const double line = p.y / grid.aspect();
  if (p.x != std::round(p.x) || line != std::round(line)) return std::nullopt;
  return std::pair(static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(line));
}

void add_piece(LineGraph& graph, VertexId a, VertexId b, CurveId curve, const EndHeights& heights,
               double part_a, double part_b) {
  if (a == b) return;
  graph.pslg.segments.push_back({a, b, curve});
  graph.heights.push_back({heights.at(part_a), heights.at(part_b)});
}

std::vector<std::pair<double, Point>> samples_beside(const HeightGrid& grid, Point a, Point b,
                                                     double part) {
  const auto from = sample_at(grid, a), to = sample_at(grid, b);
  if (!from || !to) return {};  // around an island, or a piece that has no sample on it
  const std::int64_t columns = to->first - from->first, lines = to->second - from->second;
  const std::int64_t pieces = std::gcd(columns, lines);
  if (columns == 0 || lines == 0 || pieces == 1) return {};
  const auto piece = static_cast<std::int64_t>(part * double(pieces));
  std::vector<std::pair<double, Point>> samples;
  for (std::int64_t k = std::max<std::int64_t>(piece - 1, 1); k <= piece + 2 && k < pieces; ++k) {
    samples.emplace_back(
        double(k) / double(pieces),
        grid.sample(static_cast<std::uint32_t>(from->first + k * (columns / pieces)),
                    static_cast<std::uint32_t>(from->second + k * (lines / pieces))));
  }
  return samples;
}

void cut_where_lines_meet(const HeightGrid& grid, LineGraph& graph) {
  drop_unused_points(graph.pslg);  // they would cut what they lie on
  SplitPslg split = split_crossings(graph.pslg);
  if (add_samples_beside_cuts(grid, split, graph.pslg)) split = split_crossings(graph.pslg);
  const std::vector<EndHeights> heights = std::exchange(graph.heights, {});
  std::vector<Segment> pieces = std::move(split.pslg.segments);
  graph.pslg.points = std::move(split.pslg.points);
  graph.pslg.segments.clear();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Segment& s = pieces[i];
    add_piece(graph, s.a, s.b, *s.curve, heights[split.segment_of[i].index()], s.t_a, s.t_b);
  }
  drop_unused_points(graph.pslg);
}

}  // namespace lepp

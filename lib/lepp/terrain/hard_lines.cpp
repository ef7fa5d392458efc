#include "lepp/terrain/hard_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lepp/geometry/split_crossings.hpp"
#include "lepp/terrain/sample_space.hpp"
#include "lepp/terrain/world_tin.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp {

namespace {

using VertexPair = std::pair<VertexId, VertexId>;

VertexPair in_order(VertexId a, VertexId b) { return std::minmax(a, b); }

bool is_hard(const Tin& tin, SegmentId s) { return tin.hard_segments[s.index()]; }

// Heights by point of the pieces; a cut of a hard segment gets what that asks for there.
std::vector<double> heights_of_pieces(const Pslg& lines, const SplitPslg& split,
                                      const std::vector<double>& fixed_heights,
                                      const std::vector<bool>& hard_segments) {
  std::vector<double> heights = fixed_heights;
  heights.resize(split.pslg.points.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < split.segment_of.size() && !hard_segments.empty(); ++i) {
    const std::size_t of = split.segment_of[i].index();
    if (!hard_segments[of]) continue;
    const Segment &whole = lines.segments[of], &piece = split.pslg.segments[i];
    const double low = heights[whole.a.index()], high = heights[whole.b.index()];
    for (const auto& [v, t] : {std::pair(piece.a, piece.t_a), std::pair(piece.b, piece.t_b)}) {
      const double part = (t - whole.t_a) / (whole.t_b - whole.t_a);
      if (std::isnan(heights[v.index()])) heights[v.index()] = low + part * (high - low);
    }
  }
  return heights;
}

// After the split each piece is one edge, and so is each segment of the mesh.
std::vector<bool> hard_segments_of(const Mesh& mesh, const std::vector<VertexPair>& hard_edges) {
  if (hard_edges.empty()) return {};
  std::vector<bool> result;
  for (const Segment& s : mesh.segments()) {
    result.push_back(std::ranges::binary_search(hard_edges, in_order(s.a, s.b)));
  }
  return result;
}

}  // namespace

HardTriangulation triangulate_lines(const Pslg& lines, const std::vector<double>& fixed_heights,
                                    const std::vector<bool>& hard_segments) {
  check_ids_and_range(lines);
  const SplitPslg split = split_crossings(lines);
  Triangulation made = constrained_delaunay(split.pslg, {.threads = 1});
  const auto& vertex_of = made.report.vertex_of_point;
  const std::vector<double> asked = heights_of_pieces(lines, split, fixed_heights, hard_segments);
  HardTriangulation result;
  result.heights.assign(made.mesh.vertex_count(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < asked.size(); ++i) {  // several points may have become one vertex
    if (!vertex_of[i]) continue;
    double& height = result.heights[vertex_of[i]->index()];
    if (std::isnan(height)) height = asked[i];
  }
  std::vector<VertexPair> hard_edges;
  for (std::size_t i = 0; i < split.segment_of.size() && !hard_segments.empty(); ++i) {
    const Segment& s = split.pslg.segments[i];
    const auto a = vertex_of[s.a.index()], b = vertex_of[s.b.index()];
    if (hard_segments[split.segment_of[i].index()] && a && b) {
      hard_edges.push_back(in_order(*a, *b));
    }
  }
  std::ranges::sort(hard_edges);
  result.hard_segments = hard_segments_of(made.mesh, hard_edges);
  result.mesh = std::move(made.mesh);
  result.vertex_of_point = vertex_of;
  result.vertex_of_point.resize(lines.points.size());
  return result;
}

bool is_hard(const Tin& tin, HalfEdge e) {
  if (tin.hard_segments.empty() || !tin.mesh.is_constrained(e)) return false;
  return std::ranges::any_of(tin.mesh.segments_of(e), [&](SegmentId s) { return is_hard(tin, s); });
}

std::optional<double> height_on_hard_line(const Tin& tin, VertexId v) {
  if (tin.hard_segments.empty()) return std::nullopt;
  const VertexOrigin& origin = tin.mesh.origin_of(v);
  if (origin.kind != VertexOrigin::Kind::on_segment) return std::nullopt;
  for (const SegmentId s : tin.mesh.segments_of(SegmentSetId(origin.index))) {
    if (!is_hard(tin, s)) continue;
    const auto& [a, b, curve, t_a, t_b] = tin.mesh.segments()[s.index()];
    const Point p = tin.mesh.point(a), q = tin.mesh.point(b);
    const double part =
        std::clamp(dot(tin.mesh.point(v) - p, q - p) / squared_distance(p, q), 0.0, 1.0);
    const double low = tin.heights[a.index()], high = tin.heights[b.index()];
    return low + part * (high - low);
  }
  return std::nullopt;
}

std::vector<bool> hard_vertices(const Tin& tin) {
  std::vector<bool> hard(tin.mesh.vertex_count(), false);
  for (std::size_t i = 0; i < tin.hard_segments.size(); ++i) {
    if (!tin.hard_segments[i]) continue;
    const Segment& s = tin.mesh.segments()[i];
    hard[s.a.index()] = hard[s.b.index()] = true;
  }
  for (std::size_t i = 0; i < hard.size(); ++i) {
    if (!hard[i]) hard[i] = height_on_hard_line(tin, VertexId(i)).has_value();
  }
  return hard;
}

// ---- samples ------------------------------------------------------------------------------------

namespace {

class SamplesOnLines {
 public:
  explicit SamplesOnLines(const HeightGrid& grid)
      : grid_(grid),
        space_(grid),
        reach_(std::max(1e-7 * std::min(1.0, grid.aspect()), 8 * world_rounding(grid))) {}

  // Column by column, or line by line.
  void add(Point a, Point b, double low, double high) {
    const double aspect = grid_.aspect(), columns = grid_.columns, rows = grid_.rows;
    const bool is_wide = std::abs(b.x - a.x) >= std::abs(b.y - a.y) / aspect;
    const auto along = [&](Point p) { return is_wide ? p.x : p.y / aspect; };
    const auto [first, last] = std::minmax({along(a), along(b)});
    const double end = std::min(last + near, (is_wide ? columns : rows) - 1);
    for (double k = std::max(std::ceil(first - near), 0.0); k <= end; ++k) {
      const double part = std::clamp((k - along(a)) / (along(b) - along(a)), 0.0, 1.0);
      const Point p = a + part * (b - a);
      const Sample s = space_.nearest(p);
      if (std::sqrt(squared_distance(space_.place(s), p)) > reach_) continue;
      if (std::isnan(space_.height(s))) continue;
      found_.push_back({s.column, grid_.row_of_line(s.line), low + part * (high - low)});
    }
  }

  std::vector<HardSample> take() {
    const auto place = [](const HardSample& s) { return std::pair(s.row, s.column); };
    std::ranges::stable_sort(found_, {}, place);
    const auto again = std::ranges::unique(found_, {}, place);
    found_.erase(again.begin(), again.end());
    return std::move(found_);
  }

 private:
  static constexpr double near = 1e-3;  // of a sample beyond the end that is on it by rounding

  const HeightGrid& grid_;
  SampleSpace space_;
  double reach_;
  std::vector<HardSample> found_;
};

}  // namespace

std::vector<HardSample> samples_on_hard_lines(const HeightGrid& grid, const Tin& tin) {
  if (tin.hard_segments.empty()) return {};
  SamplesOnLines samples(grid);
  const Mesh& mesh = tin.mesh;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      const auto twin = mesh.twin(e);
      if ((twin && *twin < e) || !is_hard(tin, e)) continue;
      const VertexId a = mesh.origin(e), b = mesh.destination(e);
      samples.add(mesh.point(a), mesh.point(b), tin.heights[a.index()], tin.heights[b.index()]);
    }
  }
  return samples.take();
}

}  // namespace lepp

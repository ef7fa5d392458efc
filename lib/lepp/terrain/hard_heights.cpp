#include "lepp/terrain/hard_heights.hpp"

#include <algorithm>
#include <cmath>

namespace lepp {

HardHeights::HardHeights(const TerrainDomain& domain) {
  for (std::size_t i = 0; i < domain.fixed_heights.size(); ++i) {
    const double height = domain.fixed_heights[i];
    if (!std::isnan(height)) by_place_.emplace(domain.pslg.points[i], height);
  }
}

std::optional<double> HardHeights::at(const Mesh& mesh, VertexId v) const {
  if (by_place_.empty()) return std::nullopt;
  const Point p = mesh.point(v);
  if (const auto found = by_place_.find(p); found != by_place_.end()) return found->second;
  const VertexOrigin& origin = mesh.origin_of(v);
  if (origin.kind != VertexOrigin::Kind::on_segment) return std::nullopt;
  for (const SegmentId s : mesh.segments_of(SegmentSetId(origin.index))) {
    if (const auto height = on(mesh, mesh.segments()[s.index()], p)) return height;
  }
  return std::nullopt;
}

std::optional<double> HardHeights::on(const Mesh& mesh, const Segment& s, Point p) const {
  const Point a = mesh.point(s.a), b = mesh.point(s.b);
  const auto low = by_place_.find(a), high = by_place_.find(b);
  if (low == by_place_.end() || high == by_place_.end()) return std::nullopt;
  const double part = std::clamp(dot(p - a, b - a) / squared_distance(a, b), 0.0, 1.0);
  return low->second + part * (high->second - low->second);
}

}  // namespace lepp

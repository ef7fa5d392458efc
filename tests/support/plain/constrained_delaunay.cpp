#include "support/plain/constrained_delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/plain/delaunay.hpp"
#include "support/plain/regions.hpp"
#include "support/plain/segments.hpp"

namespace lepp::plain {

namespace {

// For each point the first point with the same coordinates.
std::vector<VertexId> first_copies(const Pslg& pslg, TriangulationReport& report) {
  std::vector<VertexId> order;
  for (std::size_t i = 0; i < pslg.points.size(); ++i) order.emplace_back(i);
  std::ranges::sort(order, {}, [&](VertexId v) { return std::pair(pslg.points[v.index()], v); });
  std::vector<VertexId> first(pslg.points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const VertexId v = order[k];
    const bool copy = k > 0 && pslg.points[order[k - 1].index()] == pslg.points[v.index()];
    first[v.index()] = copy ? first[order[k - 1].index()] : v;
    if (copy) ++report.duplicate_points;
  }
  return first;
}

// One vertex per distinct point, in input order.
std::vector<VertexId> add_vertices(Mesh& mesh, const Pslg& pslg, TriangulationReport& report) {
  const std::vector<VertexId> first = first_copies(pslg, report);
  std::vector<VertexId> vertex_of(pslg.points.size());
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    const bool is_first = first[i] == VertexId(i);
    vertex_of[i] = is_first ? mesh.add_vertex(pslg.points[i], {VertexOrigin::Kind::input,
                                                               static_cast<std::uint32_t>(i)})
                            : vertex_of[first[i].index()];
  }
  return vertex_of;
}

void add_segments(Mesh& mesh, const Pslg& pslg, const std::vector<VertexId>& vertex_of,
                  TriangulationReport& report) {
  std::vector<Segment> segments = pslg.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Segment& s = segments[i];
    s.a = vertex_of[s.a.index()];
    s.b = vertex_of[s.b.index()];
    if (s.a == s.b) ++report.zero_length_segments;
  }
  mesh.set_segments(std::move(segments));
}

void set_entities(Mesh& mesh, const Pslg& pslg, const std::vector<VertexId>& vertex_of) {
  Entities entities = pslg.entities;
  for (PointEntity& point : entities.points) point.vertex = vertex_of[point.vertex.index()];
  mesh.set_entities(std::move(entities));
}

// Nominally collinear points are not so in doubles; slivers of a few ulp are no mesh.
void check_width(const Mesh& mesh, const Pslg& pslg) {
  Point low = mesh.point(VertexId(0U)), high = low;
  double area = 0;
  for (const Point p : mesh.points()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    area += 0.5 * cross(b - a, c - a);
  }
  const double diameter = std::sqrt(squared_distance(low, high));
  const double largest =
      std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
  if (area / diameter > 0x1p-49 * largest) return;
  throw InputError(pslg.source,
                   "all " + std::to_string(pslg.points.size()) +
                       " points lie on one line up to rounding: no area to mesh",
                   "give at least three points that span an area");
}

}  // namespace

Triangulation constrained_delaunay(const Pslg& pslg) {
  check_ids_and_range(pslg);
  TriangulationReport report;
  Mesh hull;
  hull.set_source(pslg.source, pslg.base);
  const std::vector<VertexId> vertex_of = add_vertices(hull, pslg, report);
  if (!triangulate_vertices(hull)) {
    throw InputError(pslg.source,
                     hull.vertex_count() < 3
                         ? "has " + std::to_string(hull.vertex_count()) +
                               " distinct points: fewer than 3 non-collinear points"
                         : "all " + std::to_string(hull.vertex_count()) + " points are collinear",
                     "give at least three points that span an area");
  }
  set_entities(hull, pslg, vertex_of);
  add_segments(hull, pslg, vertex_of, report);
  insert_segments(hull, pslg, report);
  const auto regions = find_regions(hull, pslg, report);
  if (report.convex_hull) check_width(hull, pslg);
  Mesh mesh = extract_regions(hull, regions, report);

  report.vertex_of_point.resize(pslg.points.size());
  std::vector<std::optional<VertexId>> kept(pslg.points.size());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const VertexOrigin origin = mesh.origin_of(VertexId(v));
    if (origin.index < kept.size()) kept[origin.index] = VertexId(v);
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    report.vertex_of_point[i] = kept[hull.origin_of(vertex_of[i]).index];
  }
  return {std::move(mesh), std::move(report)};
}

}  // namespace lepp::plain

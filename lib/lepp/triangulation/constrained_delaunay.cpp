#include "lepp/triangulation/constrained_delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>

#include "lepp/geometry/split_crossings.hpp"
#include "lepp/triangulation/delaunay.hpp"
#include "lepp/triangulation/mesh_of_regions.hpp"
#include "lepp/triangulation/regions.hpp"
#include "lepp/triangulation/segments.hpp"
#include "lepp/triangulation/spatial_order.hpp"

namespace lepp {

namespace {

// Puts one vertex for each distinct point into `raw`, along a space-filling curve, and returns the
// vertex of each point.
std::vector<VertexId> add_vertices(RawTriangulation& raw, const Pslg& pslg,
                                   TriangulationReport& report) {
  raw.input = spatial_order(pslg.points);
  raw.points.reserve(raw.input.size());
  std::vector<VertexId> vertex_of(pslg.points.size());
  std::optional<std::uint32_t> lowest_copy;
  for (const std::uint32_t i : raw.input) {  // equal points follow each other, the first one first
    if (!raw.points.empty() && raw.points.back() == pslg.points[i]) {
      ++report.duplicate_points;
      lowest_copy = std::min(i, lowest_copy.value_or(i));
    } else {
      raw.input[raw.points.size()] = i;
      raw.points.push_back(pslg.points[i]);
    }
    vertex_of[i] = VertexId(raw.points.size() - 1);
  }
  raw.input.resize(raw.points.size());
  if (lowest_copy) {
    const VertexId kept(raw.input[vertex_of[*lowest_copy].index()]);
    report.first_duplicate = {pslg.point_number(kept), pslg.point_number(VertexId(*lowest_copy))};
    report.warnings.push_back(std::to_string(report.duplicate_points) +
                              " duplicate points merged, for example " +
                              std::to_string(report.first_duplicate.second) + " into " +
                              std::to_string(report.first_duplicate.first));
  }
  return vertex_of;
}

void check_count(const Pslg& pslg) {
  if (pslg.points.size() <= max_triangles / 2) return;
  throw RefusedError(pslg.source,
                     "has " + std::to_string(pslg.points.size()) +
                         " points: more than 5.3e8, the most that 32-bit numbers allow",
                     "split the domain");
}

void triangulate(RawTriangulation& raw, const Pslg& pslg, unsigned threads) {
  if (raw.points.size() >= 3 && triangulate_points(raw, {.threads = threads})) return;
  throw InputError(pslg.source,
                   raw.points.size() < 3
                       ? "has " + std::to_string(raw.points.size()) +
                             " distinct points: fewer than 3 non-collinear points"
                       : "all " + std::to_string(raw.points.size()) + " points are collinear",
                   "give at least three points that span an area");
}

// Twice the area of the convex hull: once around it, from ghost to ghost.
double twice_hull_area(const RawTriangulation& raw) {
  std::uint32_t first = 0;
  while (!raw.is_ghost(first)) ++first;
  const Point start = raw.point(raw.triangles[first].vertices[0]);
  double area = 0;
  std::uint32_t t = first;
  do {
    const auto& v = raw.triangles[t].vertices;
    area += cross(raw.point(v[1]) - start, raw.point(v[0]) - start);
    t = RawTriangulation::triangle_of(raw.twin(RawTriangulation::code(t, 0)));
  } while (t != first);
  return area;
}

// Nominally collinear points are not so in doubles; slivers of a few ulp are no mesh.
void check_width(const RawTriangulation& raw, const Pslg& pslg) {
  Point low = raw.points.front(), high = low;
  for (const Point p : raw.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double diameter = std::sqrt(squared_distance(low, high));
  const double largest =
      std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
  if (0.5 * twice_hull_area(raw) / diameter > 0x1p-49 * largest) return;
  throw InputError(pslg.source,
                   "all " + std::to_string(pslg.points.size()) +
                       " points lie on one line up to rounding: no area to mesh",
                   "give at least three points that span an area");
}

void note_zero_length(const Pslg& pslg, const std::vector<VertexId>& vertex_of,
                      TriangulationReport& report) {
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
    const Segment& s = pslg.segments[i];
    if (vertex_of[s.a.index()] != vertex_of[s.b.index()]) continue;
    if (++report.zero_length_segments == 1) {
      report.warnings.push_back(pslg.segment_name(SegmentId(i)) +
                                " has equal ends and was dropped");
    }
  }
}

void note(TriangulationReport& report, std::size_t count, const std::string& what) {
  if (count > 0) report.warnings.push_back(std::to_string(count) + " " + what);
}

// Starting a thread takes as long as a thousand points.
unsigned threads_for(const Pslg& pslg, const TriangulationOptions& options) {
  if (pslg.points.size() < 20'000) return 1;
  return options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
}

// Splits what crosses first; then nothing is left to refuse.
Triangulation split_and_triangulate(const Pslg& pslg, const TriangulationOptions& options) {
  check_ids_and_range(pslg);
  const SplitPslg split = split_crossings(pslg);
  Triangulation made = constrained_delaunay(split.pslg, {Crossings::refuse, options.threads});
  made.report.crossings_split = split.crossings_split;
  made.report.points_on_segments += split.points_on_segments;
  made.report.vertex_of_point.resize(pslg.points.size());
  note(made.report, split.crossings_split, "vertices added where segments cross");
  return made;
}

}  // namespace

Triangulation constrained_delaunay(const Pslg& pslg, const TriangulationOptions& options) {
  if (options.crossings == Crossings::split) return split_and_triangulate(pslg, options);
  check_ids_and_range(pslg);
  check_count(pslg);
  const unsigned threads = threads_for(pslg, options);
  TriangulationReport report;
  RawTriangulation raw;
  std::vector<VertexId> vertex_of = add_vertices(raw, pslg, report);
  triangulate(raw, pslg, threads);
  raw.find_leaving();
  note_zero_length(pslg, vertex_of, report);
  SegmentPieces pieces = insert_segments(raw, pslg, vertex_of, report);
  Regions regions = find_regions(raw, pslg, pieces, report, threads);
  if (report.convex_hull && !pslg.segments.empty()) {
    report.warnings.push_back("the segments close off no area: the domain is the convex hull");
  }
  if (report.convex_hull) check_width(raw, pslg);  // an area that segments close off is meant
  Mesh mesh = mesh_of_regions(std::move(raw), std::move(regions), pslg, std::move(pieces),
                              std::move(vertex_of), report, threads);
  note(report, report.points_outside, "points lie outside the domain and are not in the mesh");
  note(report, report.segments_outside, "segments lie partly or wholly outside the domain");
  return {std::move(mesh), std::move(report)};
}

}  // namespace lepp

#include <algorithm>
#include <cmath>
#include <string>

#include "support/invariants.hpp"
#include "support/mesh_edges.hpp"

namespace lepp::test {

namespace {

// Pieces may be bent where they cross within rounding of a vertex, each time by a few ulp; near
// zero by the gap of the supported range, where the next coordinate is 2^-140.
constexpr double tolerance = 64 * 0x1p-52;
constexpr double gap = 2 * min_coordinate;

// The distance of p from segment ab, and how far along it, 0 to 1, p lies.
struct Beside {
  double distance, along;
};

Beside beside(Point p, Point a, Point b) {
  const Point ab = b - a;
  const double length = std::sqrt(dot(ab, ab));
  const double along = dot(p - a, ab) / (length * length);
  const Point nearest = a + std::clamp(along, 0.0, 1.0) * ab;
  return {std::sqrt(squared_distance(p, nearest)), along};
}

// An input segment, and how much of it the pieces seen so far cover.
struct Covered {
  Point a, b;
  double sum = 0;
  double strayed = 0;  // the largest distance of a piece beyond the gap, over size()

  double size() const {
    return std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
  }
  void add(Point p, Point q) {
    const Beside from = beside(p, a, b), to = beside(q, a, b);
    sum += std::abs(to.along - from.along);
    strayed = std::max(strayed, (std::max(from.distance, to.distance) - gap) / size());
  }
  bool is_whole() const {
    const double slack =
        1e-9 + 100 * (tolerance * size() + gap) / std::sqrt(squared_distance(a, b));
    return a == b || std::abs(sum - 1) <= slack;
  }
};

}  // namespace

std::optional<std::string> broken_split_promise(const Mesh& mesh, const TriangulationReport& report,
                                                const Pslg& pslg) {
  const bool whole = report.convex_hull && pslg.holes.empty();
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    const auto v = report.vertex_of_point.at(i);
    if (v && mesh.point(*v) != pslg.points[i]) return "an input point moved";
    if (!v && whole) return "the hull lost a point";
  }
  std::vector<Covered> covered;
  for (const Segment& s : pslg.segments) {
    covered.push_back({pslg.points[s.a.index()], pslg.points[s.b.index()]});
  }
  const SortedEdges edges(mesh);
  for (const SortedEdges::Entry& entry : edges.entries()) {
    const HalfEdge e = entry.edge;
    const auto across = mesh.twin(e);
    if (!mesh.is_constrained(e) || (across && *across < e)) continue;
    for (const SegmentId owner : mesh.segments_of(e)) {
      const auto curve = mesh.segments()[owner.index()].curve;
      if (!curve) continue;  // a side of the hull that no segment asked for
      covered[curve->index()].add(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)));
    }
  }
  for (std::size_t s = 0; s < covered.size(); ++s) {
    if (covered[s].strayed > tolerance) {
      return "a piece of segment " + std::to_string(s) + " strays from it by " +
             std::to_string(covered[s].strayed / 0x1p-52) + " * 2^-52 of its coordinates";
    }
    if (whole && !covered[s].is_whole()) {
      return "the pieces of segment " + std::to_string(s) + " do not cover it";
    }
  }
  return std::nullopt;
}

}  // namespace lepp::test

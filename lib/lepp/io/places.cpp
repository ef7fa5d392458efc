#include "lepp/io/places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/io/boundary_loops.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp {

namespace {

// The square of the smallest height of a triangle: how far its centroid is from its sides, times
// three.
double squared_width(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  const double longest =
      std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  const double twice_area = 2 * signed_area(a, b, c);
  return twice_area * twice_area / longest;
}

Point centroid(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return a + (1.0 / 3) * ((b - a) + (c - a));  // differences first: safe far from the origin
}

// Triangles that are joined without crossing a constrained edge.
struct Part {
  TriangleId widest;
  double squared_width = -1;
  bool is_hole = false;
};

// The parts of a mesh in the order of their first triangles. visit(part, triangle) sees all.
template <class Visit>
std::vector<Part> parts_of(const Mesh& mesh, Visit visit) {
  std::vector<Part> parts;
  std::vector<bool> reached(mesh.triangle_count(), false);
  std::vector<TriangleId> open;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (reached[i]) continue;
    Part& part = parts.emplace_back();
    reached[i] = true;
    open.emplace_back(i);
    while (!open.empty()) {  // ends: each triangle is reached once
      const TriangleId t = open.back();
      open.pop_back();
      visit(part, t);
      const double width = squared_width(mesh, t);
      if (width > part.squared_width) part = {t, width, part.is_hole};
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (mesh.is_constrained({t, k})) continue;
        const auto across = mesh.twin({t, k});
        if (!across || reached[across->triangle.index()]) continue;
        reached[across->triangle.index()] = true;
        open.push_back(across->triangle);
      }
    }
  }
  return parts;
}

using Side = std::pair<Point, Point>;  // a boundary edge, the mesh on its left

Pslg pslg_of(const std::vector<Side>& sides) {
  Pslg pslg;
  for (const auto& [a, b] : sides) pslg.points.insert(pslg.points.end(), {a, b});
  std::ranges::sort(pslg.points);
  pslg.points.erase(std::unique(pslg.points.begin(), pslg.points.end()), pslg.points.end());
  const auto vertex = [&](Point p) {
    const auto found = std::ranges::lower_bound(pslg.points, p);
    return VertexId(static_cast<std::size_t>(found - pslg.points.begin()));
  };
  for (const auto& [a, b] : sides) pslg.segments.push_back({vertex(a), vertex(b), {}, 0, 1});
  return pslg;
}

Mesh triangulate(const Pslg& boundary, const std::string& source) {
  try {
    return constrained_delaunay(boundary).mesh;
  } catch (const InputError&) {
    const auto meeting = first_bad_meeting(boundary);
    if (!meeting) throw;
    const Segment& s = boundary.segments[meeting->first.index()];
    throw InputError(source + ", boundary near " + to_text(boundary.points[s.a.index()]),
                     "meets itself, so there is no telling where its holes are",
                     "write .msh or .vtu, which need no points in holes; lepp check says more");
  }
}

// The holes that `sides` close off, found by triangulating them alone: a part with the mesh beyond
// one of its constrained edges is a hole.
void add_by_triangulating(std::vector<Side> sides, const std::string& source,
                          std::vector<Point>& holes) {
  std::ranges::sort(sides);
  const Mesh filled = triangulate(pslg_of(sides), source);
  const auto parts = parts_of(filled, [&](Part& part, TriangleId t) {
    for (std::uint32_t k = 0; k < 3 && !part.is_hole; ++k) {
      const HalfEdge e{t, k};
      if (!filled.is_constrained(e)) continue;
      const Point a = filled.point(filled.origin(e)), b = filled.point(filled.destination(e));
      part.is_hole = std::ranges::binary_search(sides, Side(b, a));
    }
  });
  for (const Part& part : parts) {
    if (part.is_hole) holes.push_back(centroid(filled, part.widest));
  }
}

void append_sides(const Mesh& mesh, const BoundaryLoop& loop, std::vector<Side>& sides) {
  for (const HalfEdge e : loop.sides) {
    sides.emplace_back(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)));
  }
}

}  // namespace

std::vector<Place> places_of_parts(const Mesh& mesh) {
  std::vector<Place> places;
  for (const Part& part : parts_of(mesh, [](Part&, TriangleId) {})) {
    places.push_back({centroid(mesh, part.widest), mesh.region(part.widest)});
  }
  return places;
}

std::vector<Point> places_of_holes(const Mesh& mesh) {
  const std::vector<BoundaryLoop> loops = boundary_loops(mesh);
  const auto around_mesh = std::ranges::count_if(loops, [](const auto& l) { return l.area > 0; });
  const bool is_clear = std::ranges::all_of(
      loops, [](const BoundaryLoop& l) { return std::abs(l.area) > l.uncertainty; });
  std::vector<Point> holes;
  std::vector<Side> sides;
  if (around_mesh > 1 || !is_clear) {  // islands may lie in holes, so all loops count at once
    for (const BoundaryLoop& loop : loops) append_sides(mesh, loop, sides);
    add_by_triangulating(std::move(sides), mesh.source(), holes);
    return holes;
  }
  for (const BoundaryLoop& loop : loops) {
    if (loop.area > 0) continue;
    if (const auto centroid = centroid_inside(mesh, loop)) {
      holes.push_back(*centroid);
    } else {
      sides.clear();
      append_sides(mesh, loop, sides);
      add_by_triangulating(sides, mesh.source(), holes);
    }
  }
  return holes;
}

}  // namespace lepp

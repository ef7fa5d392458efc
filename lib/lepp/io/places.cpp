#include "lepp/io/places.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/dual_graph.hpp"

namespace lepp {

namespace {

// The smallest height of a triangle: how far its centroid is from its sides, times three.
double width(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  const double longest =
      std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  return 2 * signed_area(a, b, c) / std::sqrt(longest);
}

Point centroid(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return a + (1.0 / 3) * ((b - a) + (c - a));  // differences first: safe far from the origin
}

// The widest triangle of each part.
std::vector<TriangleId> widest(const Mesh& mesh, const std::vector<std::uint32_t>& part_of) {
  std::vector<TriangleId> best;
  std::vector<double> best_width;
  for (std::size_t i = 0; i < part_of.size(); ++i) {
    const TriangleId t(i);
    const double w = width(mesh, t);
    if (part_of[i] == best.size()) {
      best.push_back(t);
      best_width.push_back(w);
    } else if (w > best_width[part_of[i]]) {
      best[part_of[i]] = t;
      best_width[part_of[i]] = w;
    }
  }
  return best;
}

using Side = std::pair<Point, Point>;

// The boundary edges of a mesh, the mesh on their left.
std::set<Side> boundary_sides(const Mesh& mesh) {
  std::set<Side> sides;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{TriangleId(i), k};
      if (!mesh.is_boundary(e)) continue;
      sides.emplace(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)));
    }
  }
  return sides;
}

Pslg pslg_of(const std::set<Side>& sides) {
  Pslg pslg;
  std::map<Point, VertexId> vertex_at;
  const auto vertex = [&](Point p) {
    const auto [known, is_new] = vertex_at.try_emplace(p, pslg.points.size());
    if (is_new) pslg.points.push_back(p);
    return known->second;
  };
  for (const auto& [a, b] : sides) {
    const VertexId from = vertex(a), to = vertex(b);
    pslg.segments.push_back({from, to, {}, 0, 1});
  }
  return pslg;
}

}  // namespace

std::vector<Place> places_of_parts(const Mesh& mesh) {
  std::vector<Place> places;
  for (const TriangleId t : widest(mesh, dual_components(mesh).of_triangle)) {
    places.push_back({centroid(mesh, t), mesh.region(t)});
  }
  return places;
}

std::vector<Point> places_of_holes(const Mesh& mesh) {
  const std::set<Side> sides = boundary_sides(mesh);
  if (sides.empty()) return {};
  const Mesh filled = constrained_delaunay(pslg_of(sides)).mesh;
  const auto part_of = dual_components(filled).of_triangle;
  const auto best = widest(filled, part_of);
  std::vector<bool> is_hole(best.size(), false);
  for (std::size_t i = 0; i < part_of.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {  // a side with the mesh beyond it: this is a hole
      const HalfEdge e{TriangleId(i), k};
      const Point a = filled.point(filled.origin(e)), b = filled.point(filled.destination(e));
      if (filled.is_constrained(e) && sides.contains({b, a})) is_hole[part_of[i]] = true;
    }
  }
  std::vector<Point> holes;
  for (std::size_t part = 0; part < best.size(); ++part) {
    if (is_hole[part]) holes.push_back(centroid(filled, best[part]));
  }
  return holes;
}

}  // namespace lepp

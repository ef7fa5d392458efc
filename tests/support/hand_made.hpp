#pragma once

// Meshes spelled out triangle by triangle, for tests that must not depend on a triangulator.

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp::test {

using Corners = std::array<std::uint32_t, 3>;

/// A mesh of counter-clockwise triangles: links neighbours, makes a segment of each boundary edge
/// and each edge between regions, and gives each region a surface whose tag is its number + 1.
/// \param regions  one per triangle, or empty: all region 0
inline Mesh from_triangles(const std::vector<Point>& points, const std::vector<Corners>& triangles,
                           const std::vector<std::uint32_t>& regions = {}) {
  Mesh mesh;
  mesh.set_source("hand made", 0);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    mesh.add_vertex(points[i], {VertexOrigin::Kind::input, i});
  }
  Entities entities;
  std::map<std::pair<std::uint32_t, std::uint32_t>, HalfEdge> sides;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [a, b, c] = triangles[i];
    const SurfaceId region(regions.empty() ? 0U : regions[i]);
    const TriangleId t = mesh.add_triangle(VertexId(a), VertexId(b), VertexId(c), region);
    while (entities.surfaces.size() <= region.index()) {
      const auto tag = static_cast<int>(entities.surfaces.size() + 1);
      entities.surfaces.emplace_back().tag = tag;
    }
    for (std::uint32_t e = 0; e < 3; ++e) {
      const HalfEdge side{t, e};
      const std::uint32_t from = mesh.origin(side).value, to = mesh.destination(side).value;
      const auto twin = sides.find({to, from});
      if (twin != sides.end()) mesh.link(side, twin->second);
      sides[{from, to}] = side;
    }
  }
  mesh.set_entities(std::move(entities));
  std::vector<HalfEdge> constrained;
  std::vector<Segment> segments;
  for (const auto& [ends, side] : sides) {
    const bool seen = ends.first > ends.second && sides.contains({ends.second, ends.first});
    if (seen || !mesh.separates_regions(side)) continue;
    constrained.push_back(side);
    segments.push_back({VertexId(ends.first), VertexId(ends.second), {}});
  }
  mesh.set_segments(std::move(segments));
  for (std::uint32_t s = 0; s < constrained.size(); ++s) {
    mesh.add_owner(constrained[s], SegmentId(s), 0, 1);
  }
  return mesh;
}

struct ExtraSegment {
  std::uint32_t a, b;
  std::optional<std::uint32_t> curve;
};

/// Adds segments of curves as owners of the edges between their ends. Once per mesh.
inline void add_segments(Mesh& mesh, const std::vector<ExtraSegment>& extra) {
  std::vector<Segment> segments(mesh.segments().begin(), mesh.segments().end());
  const std::size_t first = segments.size();
  for (const ExtraSegment& s : extra) {
    Segment& segment = segments.emplace_back(Segment{VertexId(s.a), VertexId(s.b), {}});
    if (s.curve) segment.curve = CurveId(*s.curve);
  }
  mesh.set_segments(std::move(segments));
  for (std::size_t i = 0; i < extra.size(); ++i) {
    const HalfEdge e = *mesh.find_edge(VertexId(extra[i].a), VertexId(extra[i].b));
    const bool forwards = mesh.origin(e) == VertexId(extra[i].a);
    mesh.add_owner(e, SegmentId(first + i), forwards ? 0 : 1, forwards ? 1 : 0);
  }
}

/// The unit square, cut along the diagonal 0-2:
///
///   3 --- 2
///   |   / |
///   | /   |
///   0 --- 1
inline Mesh square() {
  return from_triangles({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
}

/// A regular hexagon with sides of length 1 around vertex 6, which lies in the origin.
inline Mesh hexagon() {
  const double h = std::sqrt(0.75);
  return from_triangles({{1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}, {0, 0}},
                        {{6, 0, 1}, {6, 1, 2}, {6, 2, 3}, {6, 3, 4}, {6, 4, 5}, {6, 5, 0}});
}

/// The quadrilateral a b c d of two triangles (a, b, c) and (a, c, d), which may lie in two
/// regions.
inline Mesh two_triangles(Point a, Point b, Point c, Point d, std::uint32_t second_region = 0) {
  return from_triangles({a, b, c, d}, {{0, 1, 2}, {0, 2, 3}}, {0, second_region});
}

struct GridOptions {
  std::uint32_t columns = 4, rows = 4;
  Point corner{0, 0};
  double spacing = 1;
  double jitter = 0;          ///< largest shift of a vertex, in spacings
  std::uint32_t regions = 1;  ///< vertical stripes
  unsigned seed = 1;
};

/// Vertices of a grid, shifted at random: inner ones freely, those on the boundary and on the lines
/// between stripes along them. Each square is cut along its Delaunay diagonal. With a jitter up to
/// 0.15 the mesh is Delaunay and has no obtuse angle opposite a constrained edge, though many
/// inside.
/// \pre  columns is a multiple of regions
inline Mesh grid(const GridOptions& o) {
  std::mt19937 random(o.seed);
  const auto shift = [&] {  // the same on every standard library
    return o.jitter * (static_cast<double>(random()) / 2147483648.0 - 1);
  };
  const std::uint32_t stripe = o.columns / o.regions;
  std::vector<Point> points;
  for (std::uint32_t j = 0; j <= o.rows; ++j) {
    for (std::uint32_t i = 0; i <= o.columns; ++i) {
      Point p{static_cast<double>(i), static_cast<double>(j)};
      if (i % stripe != 0) p.x += shift();
      if (j != 0 && j != o.rows) p.y += shift();
      points.push_back(o.corner + o.spacing * p);
    }
  }
  std::vector<Corners> triangles;
  std::vector<std::uint32_t> regions;
  for (std::uint32_t j = 0; j < o.rows; ++j) {
    for (std::uint32_t i = 0; i < o.columns; ++i) {
      const std::uint32_t a = j * (o.columns + 1) + i, b = a + 1, c = b + o.columns + 1, d = c - 1;
      if (incircle(points[a], points[b], points[c], points[d]) > 0) {
        triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
      } else {
        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      }
      regions.insert(regions.end(), 2, i / stripe);
    }
  }
  return from_triangles(points, triangles, regions);
}

}  // namespace lepp::test

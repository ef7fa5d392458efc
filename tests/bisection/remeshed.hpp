#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "lepp/refine/refine.hpp"
#include "lepp/refine/size_field.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/fields.hpp"
#include "support/shapes.hpp"

// Domains that are meshed anew, and integrals over their meshes.

namespace lepp::test {

inline double smooth(Point p) { return std::sin(3 * p.x) * std::exp(p.y); }

inline void add_surface(Pslg& pslg, Point inside) {
  pslg.entities.surfaces.push_back({});
  pslg.seeds.push_back({inside, SurfaceId(pslg.entities.surfaces.size() - 1)});
}

/// 1 +-----------+      a square with a hole, and a bent interface between regions 0 and 1
///   |  1  __----|
///   |__---  /\  |
///   | 0    /__\ |
/// 0 +-----------+
inline Pslg divided_square() {
  Pslg pslg = polygon({0, 0, 1, 0, 1, 1, 0, 1});
  add_chain(pslg, {{0, 0.3}, {0.5, 0.55}, {1, 0.7}}, false);
  add_chain(pslg, {{0.6, 0.15}, {0.9, 0.15}, {0.75, 0.35}}, true);
  pslg.holes = {{0.75, 0.2}};
  add_surface(pslg, {0.1, 0.1});
  add_surface(pslg, {0.5, 0.9});
  return pslg;
}

inline void add_circle(Pslg& pslg, double radius, std::size_t chords) {
  const auto first = static_cast<std::uint32_t>(pslg.points.size());
  const CurveId curve(pslg.entities.curves.size());
  pslg.entities.curves.push_back({});
  pslg.entities.curves.back().geometry =
      EllipseArc{{0, 0}, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi};
  for (std::size_t i = 0; i < chords; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(chords);
    const double angle = 2 * std::numbers::pi * t;
    pslg.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    const auto a = static_cast<std::uint32_t>(i);
    const auto b = static_cast<std::uint32_t>((i + 1) % chords);
    Segment segment{VertexId(first + a), VertexId(first + b), curve};
    segment.t_a = t;
    segment.t_b = t + 1.0 / static_cast<double>(chords);
    pslg.segments.push_back(segment);
  }
}

/// A disc in a ring: region 0 within radius 0.6, region 1 to radius 1; both circles are curves.
inline Pslg disc_in_ring(std::size_t chords = 8) {
  Pslg pslg;
  add_circle(pslg, 1, chords);
  add_circle(pslg, 0.6, chords);
  add_surface(pslg, {0, 0});
  add_surface(pslg, {0.8, 0});
  return pslg;
}

/// Refined to random sizes around `h`, so that no two meshes have much in common.
inline Mesh random_mesh(const Pslg& pslg, double h, Random& random) {
  std::vector<SizeSource> sources;
  for (int i = 0; i < 12; ++i) {
    sources.push_back({{random.real(-1, 1), random.real(-1, 1)}, random.real(0.3, 1) * h});
  }
  Mesh mesh = constrained_delaunay(pslg).mesh;
  REQUIRE(refine(mesh, {.max_edge = h, .size = SizeField(sources, 0.5)}).goal_reached);
  return mesh;
}

inline std::vector<double> integrals_by_region(const Mesh& mesh,
                                               const std::vector<double>& densities) {
  std::vector<double> sums(2, 0.0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    sums[mesh.region(TriangleId(t)).index()] += densities[t] * area_of(mesh, TriangleId(t));
  }
  return sums;
}

/// Of the function that is linear on triangles.
inline double integral_of(const Mesh& mesh, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const VertexId v : mesh.vertices(TriangleId(t))) {
      sum += values[v.index()] * area_of(mesh, TriangleId(t)) / 3;
    }
  }
  return sum;
}

inline double squared_integral_of(const Mesh& mesh, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = mesh.vertices(TriangleId(t));
    const double u = values[a.index()], v = values[b.index()], w = values[c.index()];
    sum += area_of(mesh, TriangleId(t)) / 6 * (u * u + v * v + w * w + u * v + v * w + w * u);
  }
  return sum;
}

}  // namespace lepp::test

#include "lepp/terrain/surface_metric.hpp"

#include "lepp/triangulation/lepp.hpp"

namespace lepp {

namespace {

// Angles, in radians, by which two opposite ones may exceed 180 degrees: far above rounding, so
// that four corners on a circle keep their diagonal, and far below what anyone sees.
constexpr double forgiven = 1e-9;

// An angle as a vector: its cosine and sine times the lengths of its legs.
struct Angle {
  double cos, sin, legs;
};

Angle angle_at(const SpacePoint& apex, const SpacePoint& a, const SpacePoint& b) {
  const SpacePoint u = a - apex, w = b - apex, n = cross(u, w);
  return {dot(u, w), std::sqrt(dot(n, n)), std::sqrt(dot(u, u) * dot(w, w))};
}

}  // namespace

bool breaks_sphere(const Quad& quad) {
  const Angle c = angle_at(quad.c, quad.a, quad.b), d = angle_at(quad.d, quad.a, quad.b);
  return c.sin * d.cos + c.cos * d.sin < -forgiven * (c.legs * d.legs);
}

double cos_dihedral(const Quad& quad) {
  const SpacePoint along = quad.b - quad.a;
  const SpacePoint left = cross(along, quad.c - quad.a), right = cross(quad.d - quad.a, along);
  return dot(left, right) / std::sqrt(dot(left, left) * dot(right, right));
}

HalfEdge SurfaceMetric::longest_edge(TriangleId t) const {
  const Mesh& mesh = terrain_.mesh();
  const auto [a, b, c] = corners(t);
  const std::array lengths{squared_distance(b, c), squared_distance(c, a), squared_distance(a, b)};
  HalfEdge longest{t, 0};
  for (const std::uint32_t i : {1U, 2U}) {
    const double length = lengths[i], most = lengths[longest.edge];
    if (length < most) continue;
    const auto ends = [&](HalfEdge e) {
      return std::minmax({mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e))});
    };
    if (length > most || ends({t, i}) > ends(longest)) longest.edge = i;
  }
  return longest;
}

HalfEdge SurfaceMetric::terminal_edge(TriangleId start) const {
  const Mesh& mesh = terrain_.mesh();
  HalfEdge e = longest_edge(start);
  while (!mesh.is_constrained(e)) {  // ends: the key strictly grows each step
    const HalfEdge across = *mesh.twin(e), next = longest_edge(across.triangle);
    if (next == across) break;
    e = next;
  }
  return e;
}

}  // namespace lepp

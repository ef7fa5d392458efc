#include <algorithm>
#include <compare>
#include <span>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/voronoi/voronoi_boxes.hpp"

namespace lepp {

namespace {

double opposite_cotangent(const Mesh& mesh, HalfEdge e) {
  return cotangent(mesh.point(mesh.origin(e)), mesh.point(mesh.apex(e)),
                   mesh.point(mesh.destination(e)));
}

double opposite_angle_deg(const Mesh& mesh, HalfEdge e) {
  return angles_deg(mesh.point(mesh.apex(e)), mesh.point(mesh.origin(e)),
                    mesh.point(mesh.destination(e)))[0];
}

// The double must not contradict the exact sign.
double clamped(double factor, int sign) {
  if (sign == 0) return 0;
  return sign > 0 ? std::max(factor, 0.0) : std::min(factor, 0.0);
}

bool counts_alone(const Mesh& mesh, HalfEdge e) {
  return mesh.is_constrained(e) || mesh.separates_regions(e);
}

// Calls visit(e) for one half of each edge whose sides count together, and for each half of others.
template <class Visit>
void for_each_counted(const Mesh& mesh, Visit visit) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (counts_alone(mesh, e) || e < *mesh.twin(e)) visit(e);
    }
  }
}

// One side: cot(a) has the sign of the angle's cosine. Both: cot(a) + cot(b) = sin(a + b) /
// (sin a sin b) is positive iff a + b < 180 degrees, that is, iff the apex on the far side lies
// outside the circle through the near triangle.
int sign_of_factor(const Mesh& mesh, HalfEdge e) {
  if (counts_alone(mesh, e)) {
    return dot_sign(mesh.point(mesh.origin(e)), mesh.point(mesh.apex(e)),
                    mesh.point(mesh.destination(e)));
  }
  const auto [a, b, c] = mesh.corners(e.triangle);
  return -incircle(a, b, c, mesh.point(mesh.apex(*mesh.twin(e))));
}

EdgeFactor factor_of(const Mesh& mesh, HalfEdge e, int sign) {
  double cotangents = opposite_cotangent(mesh, e), angles = opposite_angle_deg(mesh, e);
  if (!counts_alone(mesh, e)) {
    const HalfEdge across = *mesh.twin(e);
    cotangents += opposite_cotangent(mesh, across);
    angles += opposite_angle_deg(mesh, across);
  }
  const auto [k, l] = std::minmax({mesh.origin(e), mesh.destination(e)});
  return {k, l, mesh.region(e.triangle), clamped(0.5 * cotangents, sign), sign, angles};
}

// In the order of edge_factors(). The two sides of a constrained edge inside a region are told
// apart by `e`, so no two are equal.
struct CountedEdge {
  VertexId k, l;
  SurfaceId region;
  HalfEdge e;
  friend auto operator<=>(const CountedEdge&, const CountedEdge&) = default;
};

CountedEdge counted(const Mesh& mesh, HalfEdge e) {
  const auto [k, l] = std::minmax({mesh.origin(e), mesh.destination(e)});
  return {k, l, mesh.region(e.triangle), e};
}

// Sorted by k with one count, then among the few that share k.
std::vector<CountedEdge> sorted_edges(const Mesh& mesh) {
  std::vector<std::size_t> end(mesh.vertex_count() + 1,
                               0);  // of the edges of k, once all are there
  for_each_counted(mesh, [&](HalfEdge e) { ++end[counted(mesh, e).k.index() + 1]; });
  for (std::size_t k = 1; k < end.size(); ++k) end[k] += end[k - 1];
  std::vector<CountedEdge> edges(end.back());
  for_each_counted(mesh, [&](HalfEdge e) {
    const CountedEdge edge = counted(mesh, e);
    edges[end[edge.k.index()]++] = edge;
  });
  for (std::size_t k = 0, begin = 0; k < mesh.vertex_count(); begin = end[k++]) {
    std::ranges::sort(std::span(edges).subspan(begin, end[k] - begin));
  }
  return edges;
}

}  // namespace

std::vector<EdgeFactor> edge_factors(const Mesh& mesh) {
  const std::vector<CountedEdge> edges = sorted_edges(mesh);
  std::vector<EdgeFactor> factors;
  factors.reserve(edges.size());
  for (const CountedEdge& edge : edges) {
    factors.push_back(factor_of(mesh, edge.e, sign_of_factor(mesh, edge.e)));
  }
  return factors;
}

std::vector<EdgeFactor> negative_edge_factors(const Mesh& mesh) {
  std::vector<CountedEdge> negative;
  for_each_counted(mesh, [&](HalfEdge e) {
    if (sign_of_factor(mesh, e) < 0) negative.push_back(counted(mesh, e));
  });
  std::ranges::sort(negative);
  std::vector<EdgeFactor> factors;
  for (const CountedEdge& edge : negative) factors.push_back(factor_of(mesh, edge.e, -1));
  return factors;
}

}  // namespace lepp

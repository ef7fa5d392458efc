#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

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

EdgeFactor factor_between(const Mesh& mesh, HalfEdge e, double cotangents, int sign, double angle) {
  const auto [k, l] = std::minmax({mesh.origin(e), mesh.destination(e)});
  return {k, l, mesh.region(e.triangle), clamped(0.5 * cotangents, sign), sign, angle};
}

// cot(a) has the sign of the angle's cosine.
EdgeFactor factor_of_side(const Mesh& mesh, HalfEdge e) {
  const int sign = dot_sign(mesh.point(mesh.origin(e)), mesh.point(mesh.apex(e)),
                            mesh.point(mesh.destination(e)));
  return factor_between(mesh, e, opposite_cotangent(mesh, e), sign, opposite_angle_deg(mesh, e));
}

// cot(a) + cot(b) = sin(a + b) / (sin a sin b): positive iff a + b < 180 degrees, that is, iff the
// apex on the far side lies outside the circle through the near triangle.
EdgeFactor factor_of_both_sides(const Mesh& mesh, HalfEdge e, HalfEdge across) {
  const auto [a, b, c] = mesh.corners(e.triangle);
  const int sign = -incircle(a, b, c, mesh.point(mesh.apex(across)));
  return factor_between(mesh, e, opposite_cotangent(mesh, e) + opposite_cotangent(mesh, across),
                        sign, opposite_angle_deg(mesh, e) + opposite_angle_deg(mesh, across));
}

}  // namespace

std::vector<EdgeFactor> edge_factors(const Mesh& mesh) {
  std::vector<EdgeFactor> factors;
  factors.reserve(mesh.triangle_count() * 3 / 2 + 3);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      const auto across = mesh.twin(e);
      if (!across || mesh.is_constrained(e) || mesh.separates_regions(e)) {
        factors.push_back(factor_of_side(mesh, e));
      } else if (e < *across) {
        factors.push_back(factor_of_both_sides(mesh, e, *across));
      }
    }
  }
  std::ranges::stable_sort(factors, {},
                           [](const EdgeFactor& f) { return std::tuple(f.k, f.l, f.region); });
  return factors;
}

}  // namespace lepp

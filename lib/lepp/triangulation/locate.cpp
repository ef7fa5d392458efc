#include "lepp/triangulation/locate.hpp"

#include "lepp/geometry/predicates.hpp"

namespace lepp {

namespace {

// The edge of `t` that has p on its right, starting the search at corner `first`.
std::optional<HalfEdge> edge_towards(const Mesh& mesh, TriangleId t, std::uint32_t first, Point p) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    const HalfEdge e{t, (first + k) % 3};
    if (orient2d(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)), p) < 0) return e;
  }
  return std::nullopt;
}

Location inside(const Mesh& mesh, TriangleId t, Point p) {
  Location location{t, {}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    if (orient2d(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)), p) == 0) {
      location.on_edge = e;
    }
  }
  return location;
}

}  // namespace

std::optional<Location> locate(const Mesh& mesh, Point p, TriangleId hint) {
  TriangleId t = hint;
  for (std::size_t step = 0; step < mesh.triangle_count(); ++step) {
    // The corner to start at changes from step to step, so the walk cannot circle for ever in a
    // triangulation that is constrained.
    const auto e = edge_towards(mesh, t, static_cast<std::uint32_t>(step % 3), p);
    if (!e) return inside(mesh, t, p);
    const auto across = mesh.twin(*e);
    if (!across) break;
    t = across->triangle;
  }
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (!edge_towards(mesh, TriangleId(i), 0, p)) return inside(mesh, TriangleId(i), p);
  }
  return std::nullopt;
}

}  // namespace lepp

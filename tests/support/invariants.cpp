#include "support/invariants.hpp"

#include <algorithm>
#include <numeric>

#include "lepp/geometry/text.hpp"
#include "support/mesh_edges.hpp"
#include "support/oracle.hpp"

namespace lepp::test {

namespace {

using Broken = std::optional<std::string>;

std::string name(const Mesh& mesh, HalfEdge e) {
  return "edge " + to_text(mesh.point(mesh.origin(e))) + " - " +
         to_text(mesh.point(mesh.destination(e)));
}

template <class Visit>
Broken first_broken_edge(const Mesh& mesh, Visit visit) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (Broken broken = visit(HalfEdge{TriangleId(t), i})) return broken;
    }
  }
  return std::nullopt;
}

Broken broken_ids(const Mesh& mesh) {
  if (mesh.triangle_count() == 0) return "there is no triangle";
  std::vector<bool> used(mesh.vertex_count(), false);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const VertexId v : mesh.vertices(TriangleId(t))) {
      if (v.index() >= used.size()) return "a triangle names a vertex that is not there";
      used[v.index()] = true;
    }
  }
  if (std::find(used.begin(), used.end(), false) != used.end()) return "a vertex is unused";
  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  std::sort(points.begin(), points.end());
  const auto twice = std::adjacent_find(points.begin(), points.end());
  if (twice != points.end()) return "two vertices at " + to_text(*twice);
  return std::nullopt;
}

Broken broken_orientation(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    if (oracle_orient2d(a, b, c) <= 0) {
      return "triangle " + to_text(a) + " " + to_text(b) + " " + to_text(c) + " is not ccw";
    }
  }
  return std::nullopt;
}

Broken broken_neighbours(const Mesh& mesh, const SortedEdges& edges) {
  const auto& all = edges.entries();
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i - 1].key == all[i].key) return name(mesh, all[i].edge) + ": two on one side";
  }
  return first_broken_edge(mesh, [&](HalfEdge e) -> Broken {
    if (mesh.twin(e) == edges.find(mesh.destination(e), mesh.origin(e))) return std::nullopt;
    return name(mesh, e) + " has the wrong neighbour";
  });
}

Broken broken_leaving(const Mesh& mesh) {
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const HalfEdge e = mesh.leaving(VertexId(v));
    if (e.triangle.index() >= mesh.triangle_count() || mesh.origin(e) != VertexId(v)) {
      return "leaving() is wrong at " + to_text(mesh.point(VertexId(v)));
    }
  }
  return std::nullopt;
}

// Directions of (0, pi] are above, those of (-pi, 0] are not.
bool is_above(Point direction_from, Point to) {
  return to.y > direction_from.y || (to.y == direction_from.y && to.x < direction_from.x);
}

// A wedge below pi covers the direction (1, 0) where it begins below and ends above. Around an
// inner vertex exactly one triangle does, around others at most one.
Broken broken_turns(const Mesh& mesh) {
  std::vector<int> covered(mesh.vertex_count(), 0);
  std::vector<bool> inner(mesh.vertex_count(), true);
  first_broken_edge(mesh, [&](HalfEdge e) -> Broken {
    const VertexId v = mesh.apex(e);
    const Point p = mesh.point(v);
    const bool begins = !is_above(p, mesh.point(mesh.origin(e)));
    if (begins && is_above(p, mesh.point(mesh.destination(e)))) ++covered[v.index()];
    if (mesh.is_boundary(e)) {
      inner[mesh.origin(e).index()] = inner[mesh.destination(e).index()] = false;
    }
    return std::nullopt;
  });
  for (std::size_t v = 0; v < covered.size(); ++v) {
    if (covered[v] > 1 || (inner[v] && covered[v] != 1)) {
      return "triangles overlap around " + to_text(mesh.point(VertexId(v)));
    }
  }
  return std::nullopt;
}

// vertices - edges + triangles = 2 * components - boundary cycles, where a vertex counts once for
// each of its fans.
Broken broken_euler(const Mesh& mesh) {
  std::vector<int> open_fans(mesh.vertex_count(), 0);
  std::vector<bool> walked(3 * mesh.triangle_count(), false);
  std::int64_t half_edges = 0, boundary_edges = 0, cycles = 0;
  const auto number = [](HalfEdge e) { return 3 * e.triangle.index() + e.edge; };
  first_broken_edge(mesh, [&](HalfEdge first) -> Broken {
    ++half_edges;
    if (!mesh.is_boundary(first)) return std::nullopt;
    ++boundary_edges;
    ++open_fans[mesh.origin(first).index()];
    if (walked[number(first)]) return std::nullopt;
    ++cycles;
    for (HalfEdge e = first; !walked[number(e)];) {  // each edge of the cycle once
      walked[number(e)] = true;
      e = next_edge(e);
      while (const auto across = mesh.twin(e)) e = next_edge(*across);
    }
    return std::nullopt;
  });
  std::int64_t fans = 0;
  for (const int open : open_fans) fans += std::max(open, 1);
  const std::int64_t edges = (half_edges + boundary_edges) / 2;
  const std::int64_t components = parts_of(mesh, JoinAcross::all_edges).count;
  const auto triangles = static_cast<std::int64_t>(mesh.triangle_count());
  if (fans - edges + triangles == 2 * components - cycles) return std::nullopt;
  return "Euler's formula does not hold";
}

Broken broken_constraints(const Mesh& mesh) {
  return first_broken_edge(mesh, [&](HalfEdge e) -> Broken {
    const auto f = mesh.twin(e);
    const bool constrained = mesh.is_constrained(e);
    if (!f && !constrained) return name(mesh, e) + " is boundary, not constrained";
    if (!f) return std::nullopt;
    if (constrained != mesh.is_constrained(*f)) return name(mesh, e) + ": flags differ";
    if (!constrained && mesh.region(e.triangle) != mesh.region(f->triangle)) {
      return name(mesh, e) + " lies between regions, not constrained";
    }
    return std::nullopt;
  });
}

}  // namespace

std::optional<std::string> broken_topology(const Mesh& mesh) {
  if (Broken broken = broken_ids(mesh)) return broken;
  if (Broken broken = broken_orientation(mesh)) return broken;
  const SortedEdges edges(mesh);
  if (Broken broken = broken_neighbours(mesh, edges)) return broken;
  if (Broken broken = broken_leaving(mesh)) return broken;
  if (Broken broken = broken_turns(mesh)) return broken;
  if (Broken broken = broken_euler(mesh)) return broken;
  return broken_constraints(mesh);
}

std::optional<std::string> broken_delaunay(const Mesh& mesh) {
  return first_broken_edge(mesh, [&](HalfEdge e) -> Broken {
    const auto f = mesh.twin(e);
    if (!f || *f < e || mesh.is_constrained(e)) return std::nullopt;
    const auto [a, b, c] = mesh.corners(e.triangle);
    if (oracle_incircle(a, b, c, mesh.point(mesh.apex(*f))) <= 0) return std::nullopt;
    return name(mesh, e) + " is not Delaunay";
  });
}

std::optional<std::string> broken_invariant(const Triangulation& result, const Pslg& pslg,
                                            const Arrangement& arrangement, Crossings crossings) {
  if (Broken broken = broken_topology(result.mesh)) return broken;
  if (Broken broken = broken_delaunay(result.mesh)) return broken;
  if (crossings == Crossings::refuse || arrangement.crossings.empty()) {
    return broken_promise(result.mesh, result.report, pslg, arrangement);
  }
  return broken_split_promise(result.mesh, result.report, pslg);
}

}  // namespace lepp::test

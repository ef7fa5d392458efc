// Properties of what works on a mesh: locate, flip, split insertion.

#include <doctest/doctest.h>

#include <algorithm>

#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/invariants.hpp"
#include "support/mesh_edges.hpp"
#include "support/oracle.hpp"
#include "support/small_pslg.hpp"
#include "support/trial.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// The mesh of a PSLG; cases that have none are discarded.
Mesh mesh_of(const SmallPslg& small) {
  const Pslg pslg = small.pslg_without_crossings();
  Trial trial = try_pslg(pslg, arrange(pslg), Crossings::refuse);
  RC_PRE(trial.result.has_value());
  return std::move(trial.result->mesh);
}

bool is_in(const Mesh& mesh, TriangleId t, Point p) {
  const auto [a, b, c] = mesh.corners(t);
  return oracle_orient2d(a, b, p) >= 0 && oracle_orient2d(b, c, p) >= 0 &&
         oracle_orient2d(c, a, p) >= 0;
}

bool is_in_any(const Mesh& mesh, Point p) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (is_in(mesh, TriangleId(t), p)) return true;
  }
  return false;
}

void require_valid(const Mesh& mesh, bool delaunay) {
  if (const auto broken = broken_topology(mesh)) RC_FAIL(*broken);
  const auto broken = delaunay ? broken_delaunay(mesh) : std::nullopt;
  if (broken) RC_FAIL(*broken);
  RC_ASSERT(validate(mesh, {.delaunay = delaunay}).summary() == "valid");
}

std::vector<std::uint64_t> edge_keys(const Mesh& mesh) {
  std::vector<std::uint64_t> keys;
  const SortedEdges edges(mesh);
  for (const auto& entry : edges.entries()) keys.push_back(entry.key);
  return keys;
}

TriangleId any_triangle(const Mesh& mesh) {
  return TriangleId(*rc::gen::inRange<std::size_t>(0, mesh.triangle_count()));
}

}  // namespace

TEST_CASE("locate finds the triangle from any hint, and nothing outside") {
  CHECK(holds("locate", [](const SmallPslg& small, const LatticePoint& query) {
    const Mesh mesh = mesh_of(small);
    const TriangleId hint = any_triangle(mesh);
    for (const Point p : {query.place(), query.place() + Point{0.5, 0.25}}) {
      const auto found = locate(mesh, p, hint);
      RC_ASSERT(found.has_value() == is_in_any(mesh, p));
      if (!found) continue;
      RC_ASSERT(is_in(mesh, found->triangle, p));
      bool on_edge = false;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{found->triangle, i};
        const Point a = mesh.point(mesh.origin(e)), b = mesh.point(mesh.destination(e));
        const bool here = oracle_orient2d(a, b, p) == 0;
        on_edge = on_edge || here;
        if (found->on_edge == e) RC_ASSERT(here);
      }
      RC_ASSERT(found->on_edge.has_value() == on_edge);
    }
  }));
}

TEST_CASE("flipping an edge twice gives the mesh back; make_delaunay repairs any flips") {
  CHECK(holds("flip", [](const SmallPslg& small) {
    Mesh mesh = mesh_of(small);
    const auto before = edge_keys(mesh);
    const bool unique = is_unique(mesh);
    const auto flips = *rc::gen::inRange(1, 12);
    for (int i = 0; i < flips; ++i) {
      const HalfEdge e{any_triangle(mesh), *rc::gen::inRange(0U, 3U)};
      if (mesh.is_boundary(e) || mesh.is_constrained(e) || !is_flippable(mesh, e)) continue;
      const auto here = edge_keys(mesh);
      const HalfEdge back = flip(mesh, flip(mesh, e));
      RC_ASSERT(edge_keys(mesh) == here);
      flip(mesh, back);
      require_valid(mesh, false);
    }
    make_delaunay(mesh);
    require_valid(mesh, true);
    if (unique) RC_ASSERT(edge_keys(mesh) == before);
  }));
}

TEST_CASE("insertions leave a constrained Delaunay mesh and tell which triangles changed") {
  CHECK(holds("insertion", [](const SmallPslg& small, const std::vector<LatticePoint>& inserted) {
    Mesh mesh = mesh_of(small);
    for (const LatticePoint& lattice : inserted) {
      const Point p = lattice.place() + Point{0.25, 0.125};
      const auto where = locate(mesh, p);
      if (!where) continue;
      const Mesh before = mesh;
      const VertexOrigin origin{VertexOrigin::Kind::interior, 0};
      Insertion insertion;
      if (!where->on_edge) {
        insertion = insert_in_triangle(mesh, where->triangle, p, origin);
      } else if (can_split_edge(mesh, *where->on_edge, p)) {
        insertion = insert_on_edge(mesh, *where->on_edge, p, origin);
      } else {
        continue;  // at a vertex
      }
      require_valid(mesh, true);
      RC_ASSERT(mesh.point(insertion.vertex) == p);
      const auto& changed = insertion.changed;
      RC_ASSERT(std::is_sorted(changed.begin(), changed.end()));
      for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const TriangleId id(t);
        const bool differs =
            t >= before.triangle_count() || mesh.vertices(id) != before.vertices(id);
        RC_ASSERT(differs == std::binary_search(changed.begin(), changed.end(), id));
      }
    }
  }));
}

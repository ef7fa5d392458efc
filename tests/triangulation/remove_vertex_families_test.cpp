// Random insertions into every family of inputs, undone in random order.

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/remove_vertex.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/gen_pslg.hpp"
#include "support/random.hpp"
#include "support/trial.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

std::vector<std::pair<VertexId, VertexId>> edges_of(const Mesh& mesh) {
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      edges.push_back(std::minmax(mesh.origin(e), mesh.destination(e)));
    }
  }
  std::ranges::sort(edges);
  return edges;
}

TriangleId any_triangle(const Mesh& mesh, Random& random) {
  return TriangleId(std::size_t{random.below(static_cast<std::uint32_t>(mesh.triangle_count()))});
}

// About `wanted` Steiner points, in triangles and on edges, wherever they fit.
void insert_some(Mesh& mesh, int wanted, Random& random) {
  for (int i = 0; i < wanted; ++i) {
    const TriangleId t = any_triangle(mesh, random);
    const HalfEdge e{t, random.below(3)};
    const auto [a, b, c] = mesh.corners(t);
    if (mesh.is_constrained(e)) {
      split_halfway(mesh, e, 0);
    } else if (const Point p = in_supported_range(midpoint(midpoint(a, b), c));
               is_inside(mesh, t, p)) {
      insert_in_triangle(mesh, t, p, {});
    }
  }
}

}  // namespace

TEST_CASE("what is inserted into 1,000 meshes can be removed again, and each step is valid") {
  int meshes = 0, removed = 0, bent = 0, same_edges = 0;
  for (std::uint64_t seed = 0; meshes < 1000 && seed < 3000; ++seed) {
    const auto family = static_cast<std::size_t>(seed % family_names.size());
    CAPTURE(family_names[family]);
    CAPTURE(seed);
    Random random(seed);
    Mesh mesh;
    try {
      mesh = constrained_delaunay(generate_pslg(Family(family), seed)).mesh;
    } catch (const InputError&) {
      continue;
    }
    ++meshes;
    const auto edges = edges_of(mesh);
    const std::size_t inputs = mesh.vertex_count();
    insert_some(mesh, 10, random);
    while (mesh.vertex_count() > inputs) {
      const VertexId v(inputs +
                       random.below(static_cast<std::uint32_t>(mesh.vertex_count() - inputs)));
      const Removability why = removability(mesh, v);
      if (!is_removable(why)) {
        REQUIRE(why == Removability::bent);
        ++bent;
        break;
      }
      REQUIRE(remove_vertex(mesh, v).has_value());
      REQUIRE(validate(mesh).summary() == "valid");
      ++removed;
    }
    if (mesh.vertex_count() > inputs) continue;
    if (is_unique(mesh)) {
      REQUIRE(edges_of(mesh) == edges);
      ++same_edges;
    } else {
      REQUIRE(edges_of(mesh).size() == edges.size());
    }
  }
  CHECK(meshes == 1000);
  CHECK(removed > 3000);
  CHECK(bent < 500);
  CHECK(same_edges > 100);
}

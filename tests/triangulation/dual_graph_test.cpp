#include "lepp/triangulation/dual_graph.hpp"

#include <doctest/doctest.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_concepts.hpp>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/dual_graph_bgl.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

// A square cut in three by two interfaces, one of which dangles.
Mesh three_rooms() {
  Pslg pslg = test::polygon({0, 0, 6, 0, 6, 4, 0, 4});
  test::add_chain(pslg, {{2, 0}, {2, 4}}, false);
  test::add_chain(pslg, {{4, 0}, {4, 3}}, false);
  pslg.points.push_back({1, 2});
  pslg.points.push_back({5, 2});
  return constrained_delaunay(pslg).mesh;
}

}  // namespace

TEST_CASE("components are joined across unconstrained edges only") {
  const Mesh mesh = three_rooms();
  const DualComponents components = dual_components(mesh);
  CHECK(components.count == 2);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    const bool left = a.x + b.x + c.x < 6;
    CHECK((components.of_triangle[t] == components.of_triangle[0]) ==
          (left == (mesh.corners(TriangleId(0U))[0].x + mesh.corners(TriangleId(0U))[1].x +
                        mesh.corners(TriangleId(0U))[2].x <
                    6)));
  }
}

TEST_CASE("a Mesh is a graph that Boost.Graph's algorithms run over") {
  BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Mesh>));
  BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Mesh>));
  const Mesh mesh = three_rooms();
  std::vector<std::size_t> distance(mesh.triangle_count(), 0);
  std::vector<boost::default_color_type> color(mesh.triangle_count());
  boost::breadth_first_search(mesh, std::size_t{0},
                              boost::visitor(boost::make_bfs_visitor(boost::record_distances(
                                                 distance.data(), boost::on_tree_edge())))
                                  .color_map(boost::make_iterator_property_map(
                                      color.begin(), boost::identity_property_map())));
  const DualComponents components = dual_components(mesh);
  for (std::size_t t = 1; t < mesh.triangle_count(); ++t) {
    CHECK((distance[t] > 0) == (components.of_triangle[t] == components.of_triangle[0]));
  }
}

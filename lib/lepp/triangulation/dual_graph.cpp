#include "lepp/triangulation/dual_graph.hpp"

#include <boost/graph/connected_components.hpp>

#include "lepp/triangulation/dual_graph_bgl.hpp"

namespace lepp {

DualComponents dual_components(const Mesh& mesh) {
  DualComponents components;
  components.of_triangle.resize(mesh.triangle_count());
  components.count = boost::connected_components(
      mesh, boost::make_iterator_property_map(components.of_triangle.begin(),
                                              boost::identity_property_map()));
  return components;
}

}  // namespace lepp

#pragma once

// Lets the algorithms of Boost.Graph run over a Mesh as it is: the dual graph, whose vertices are
// the triangles and whose edges are the unconstrained edges between two of them. Optional: no
// other header of lepp includes this one, and it needs Boost's headers.
//
//   std::vector<std::uint32_t> component(mesh.triangle_count());
//   boost::connected_components(mesh, component.data());

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/irange.hpp>
#include <cstddef>
#include <utility>

#include "lepp/triangulation/mesh.hpp"

namespace lepp::bgl {

/// Walks the edges of one triangle that lead to a neighbour.
class OutEdgeIterator : public boost::iterator_facade<OutEdgeIterator, HalfEdge,
                                                      boost::forward_traversal_tag, HalfEdge> {
 public:
  OutEdgeIterator() = default;
  OutEdgeIterator(const Mesh& mesh, HalfEdge e) : mesh_(&mesh), e_(e) { skip_closed(); }

 private:
  friend class boost::iterator_core_access;
  HalfEdge dereference() const { return e_; }
  bool equal(const OutEdgeIterator& other) const { return e_ == other.e_; }
  void increment() {
    ++e_.edge;
    skip_closed();
  }
  void skip_closed() {
    while (e_.edge < 3 && (mesh_->is_constrained(e_) || mesh_->is_boundary(e_))) ++e_.edge;
  }

  const Mesh* mesh_ = nullptr;
  HalfEdge e_;
};

struct DualGraphCategory : virtual boost::vertex_list_graph_tag,
                           virtual boost::incidence_graph_tag {};

}  // namespace lepp::bgl

template <>
struct boost::graph_traits<lepp::Mesh> {
  using vertex_descriptor = std::size_t;  ///< index of a triangle
  using edge_descriptor = lepp::HalfEdge;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using traversal_category = lepp::bgl::DualGraphCategory;
  using out_edge_iterator = lepp::bgl::OutEdgeIterator;
  using vertex_iterator = boost::range_iterator<boost::integer_range<std::size_t>>::type;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  static vertex_descriptor null_vertex() { return static_cast<std::size_t>(-1); }
};

template <>
struct boost::property_map<lepp::Mesh, boost::vertex_index_t> {
  using type = boost::identity_property_map;
  using const_type = type;
};

namespace lepp {

// Found by argument-dependent lookup from the algorithms of Boost.Graph.
inline auto vertices(const Mesh& mesh) {
  const auto range = boost::irange(std::size_t{0}, mesh.triangle_count());
  return std::pair(range.begin(), range.end());
}
inline std::size_t num_vertices(const Mesh& mesh) { return mesh.triangle_count(); }
inline auto out_edges(std::size_t t, const Mesh& mesh) {
  const TriangleId id(t);
  return std::pair(bgl::OutEdgeIterator(mesh, {id, 0}), bgl::OutEdgeIterator(mesh, {id, 3}));
}
inline std::size_t out_degree(std::size_t t, const Mesh& mesh) {
  const auto [first, last] = out_edges(t, mesh);
  return static_cast<std::size_t>(std::distance(first, last));
}
inline std::size_t source(HalfEdge e, const Mesh&) { return e.triangle.index(); }
inline std::size_t target(HalfEdge e, const Mesh& mesh) { return mesh.twin(e)->triangle.index(); }
inline boost::identity_property_map get(boost::vertex_index_t, const Mesh&) { return {}; }

}  // namespace lepp

#include "lepp/triangulation/spatial_numbering.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "lepp/triangulation/spatial_order.hpp"

namespace lepp {

namespace {

std::vector<std::uint32_t> inverse(std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> number_of(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    number_of[order[i]] = static_cast<std::uint32_t>(i);
  }
  return number_of;
}

std::size_t input_vertices(const Mesh& mesh) {
  std::size_t count = 0;
  while (count < mesh.vertex_count() && mesh.is_input(VertexId(count))) ++count;
  return count;
}

// By the corner that comes first, those with the same in their old order: a counting sort.
std::vector<std::uint32_t> triangles_by_first_corner(const Mesh& mesh) {
  std::vector<std::uint32_t> begin(mesh.vertex_count() + 1, 0);
  const auto first = [](const Triangle& t) { return std::ranges::min(t.vertices).index(); };
  for (const Triangle& t : mesh.triangles()) ++begin[first(t) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> order(mesh.triangle_count());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[begin[first(mesh.triangles()[i])]++] = static_cast<std::uint32_t>(i);
  }
  return order;
}

}  // namespace

SpatialNumbering::SpatialNumbering(Mesh& mesh) : mesh_(mesh) {
  const std::size_t inputs = input_vertices(mesh);
  input_ = spatial_order(mesh.points().first(inputs));
  std::vector<std::uint32_t> order = input_;
  for (const std::uint32_t i : spatial_order(mesh.points().subspan(inputs))) {
    order.push_back(static_cast<std::uint32_t>(inputs) + i);
  }
  mesh.renumber_vertices(inverse(order));
  mesh.renumber_triangles(inverse(triangles_by_first_corner(mesh)));
}

void SpatialNumbering::undo() {
  std::vector<std::uint32_t> number_of = input_;
  for (std::size_t v = input_.size(); v < mesh_.vertex_count(); ++v) {
    number_of.push_back(static_cast<std::uint32_t>(v));
  }
  mesh_.renumber_vertices(number_of);
}

}  // namespace lepp

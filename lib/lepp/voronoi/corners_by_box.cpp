#include "lepp/voronoi/corners_by_box.hpp"

#include <algorithm>

namespace lepp {

namespace {

// Offsets into an array that holds the corners at each vertex, vertex by vertex.
std::vector<std::uint32_t> offsets_by_vertex(const Mesh& mesh) {
  std::vector<std::uint32_t> begin(mesh.vertex_count() + 1, 0);
  for (const Triangle& t : mesh.triangles()) {
    for (const VertexId v : t.vertices) ++begin[v.index() + 1];
  }
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  return begin;
}

}  // namespace

CornersByBox::CornersByBox(const Mesh& mesh) : corners_(3 * mesh.triangle_count()) {
  const std::vector<std::uint32_t> begin = offsets_by_vertex(mesh);
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      corners_[end[mesh.vertex(TriangleId(t), i).index()]++] = {TriangleId(t), i};
    }
  }
  first_box_.reserve(mesh.vertex_count() + 1);
  regions_.reserve(mesh.vertex_count());
  begin_.reserve(mesh.vertex_count() + 1);
  const auto region_of = [&](TriangleCorner c) { return mesh.region(c.triangle); };
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    first_box_.push_back(static_cast<std::uint32_t>(regions_.size()));
    const std::span here = std::span(corners_).subspan(begin[v], begin[v + 1] - begin[v]);
    if (!std::ranges::is_sorted(here, {}, region_of)) {
      std::ranges::stable_sort(here, {}, region_of);
    }
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (i != 0 && region_of(here[i]) == region_of(here[i - 1])) continue;
      regions_.push_back(region_of(here[i]));
      begin_.push_back(begin[v] + static_cast<std::uint32_t>(i));
    }
  }
  first_box_.push_back(static_cast<std::uint32_t>(regions_.size()));
  begin_.push_back(begin.back());
}

}  // namespace lepp

#include "lepp/terrain/world_tin.hpp"

#include <utility>

namespace lepp {

namespace {

std::string title_of(const std::string& source) {
  std::string name = source.substr(source.find_last_of('/') + 1);
  for (char& c : name) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return name.empty() ? "terrain" : name;
}

}  // namespace

WorldTin to_world(Tin tin, const HeightGrid& grid) {
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    const VertexId v(i);
    tin.mesh.move_vertex(v, grid.to_world(tin.mesh.point(v)));
  }
  return {std::move(tin.mesh), std::move(tin.heights), grid.crs, grid.degrees,
          title_of(grid.source)};
}

}  // namespace lepp

#include "lepp/voronoi/voronoi_boxes.hpp"

#include <utility>

#include "lepp/voronoi/box_cutter.hpp"
#include "lepp/voronoi/corners_by_box.hpp"

namespace lepp {

VoronoiBoxes voronoi_boxes(const Mesh& mesh) {
  const CornersByBox corners(mesh);
  VoronoiBoxes result;
  const std::size_t triangles = mesh.triangle_count();
  result.boxes.reserve(corners.box_count());
  result.faces.reserve(triangles + mesh.vertex_count() + corners.box_count());
  result.corners.reserve(13 * triangles);
  result.piece_begin.reserve(3 * triangles + 1);
  result.piece_triangle.reserve(3 * triangles);
  result.piece_begin.push_back(0);
  BoxCutter cutter(mesh, corners, BoxCutter::Faces::make);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) cutter.cut(VertexId(v), result);
  return result;
}

std::vector<double> box_areas(const Mesh& mesh, const VoronoiBoxes& boxes) {
  std::vector<double> areas(mesh.vertex_count(), 0.0);
  for (const VoronoiBox& box : boxes.boxes) areas[box.vertex.index()] += box.area;
  return areas;
}

}  // namespace lepp

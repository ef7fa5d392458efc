#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lepp/triangulation/mesh.hpp"
#include "lepp/voronoi/voronoi_boxes.hpp"

namespace lepp {

/// Values to show on a mesh: one per vertex, or one per triangle.
struct NamedValues {
  std::string name;
  std::vector<double> values;
};

struct VtuData {
  std::vector<NamedValues> at_vertices = {};
  std::vector<NamedValues> at_triangles = {};
  std::vector<double> heights = {};  ///< z coordinates, one per vertex; empty: all 0
};

/// Writes a VTK unstructured grid (.vtu, ASCII) of the triangles, with cell data `region` (tag of
/// the surface), `min_angle_deg`, `max_angle_deg` and `admissible` (1 where every edge factor of
/// the triangle's region has the exact sign >= 0), and with the caller's values.
/// \pre   each list of values has one per vertex or triangle, and finite
/// \throw OutputError
void write_vtu(const Mesh& mesh, const std::filesystem::path& path, const VtuData& data = {});

/// Writes the pieces of Voronoi boxes as polygons, with cell data `vertex`, `region` (tag) and
/// `box_area`.
/// \throw OutputError
void write_boxes_vtu(const Mesh& mesh, const VoronoiBoxes& boxes,
                     const std::filesystem::path& path);

}  // namespace lepp

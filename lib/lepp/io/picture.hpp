#pragma once

#include <filesystem>

#include "lepp/triangulation/mesh.hpp"
#include "lepp/voronoi/voronoi_boxes.hpp"

namespace lepp {

struct PictureOptions {
  double width = 1000;                  ///< longest side of the drawing, in SVG user units, > 0
  const VoronoiBoxes* boxes = nullptr;  ///< drawn over the triangles if given
};

/// Draws a mesh as SVG: triangles filled by region, thin edges, interfaces and other constrained
/// edges thicker, the boundary thickest. y points up; line widths do not depend on coordinates.
/// \throw OutputError
void write_picture(const Mesh& mesh, const std::filesystem::path& path,
                   const PictureOptions& options = {});

}  // namespace lepp

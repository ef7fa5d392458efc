#pragma once

#include <string>
#include <vector>

#include "lepp/terrain/height_grid.hpp"
#include "lepp/terrain/tin.hpp"

namespace lepp {

/// A TIN as files hold it: world coordinates, and what is known about them.
struct WorldTin {
  Mesh mesh;
  std::vector<double> heights;  ///< one per vertex, up, in the unit of the grid
  std::string crs;              ///< coordinate reference system as WKT, or empty
  bool degrees = false;         ///< x and y are longitude and latitude
  std::string title;            ///< one line, without folder: what files call it
};

/// Moves a TIN from grid space (height_grid.hpp) to the world. Triangles stay counter-clockwise but
/// for rounding, which validate() tells: M1 to M5 are to be checked again. Triangles that are
/// Delaunay in grid space need not be in the world where cells are not square there (degrees).
WorldTin to_world(Tin tin, const HeightGrid& grid);

}  // namespace lepp

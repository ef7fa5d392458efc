#pragma once

#include <string>
#include <vector>

#include "lepp/geometry/error.hpp"
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

/// Moves a TIN from grid space (height_grid.hpp) to the world. M1 to M5 are to be checked again.
/// Triangles that are Delaunay in grid space need not be in the world where cells are not square
/// there (degrees).
/// \throw InputError  rounding turns triangles over
WorldTin to_world(Tin tin, const HeightGrid& grid);

/// How far rounding moves a place in world coordinates, in cells, at most.
double world_rounding(const HeightGrid& grid);
/// \throw InputError  that is more than 1e-4: places between samples would be lost
void check_world_rounding(const HeightGrid& grid);
/// What to do about it: "--origin 500000 4649776".
std::string advice_to_count_from_nearby(const HeightGrid& grid);
/// Says that triangles are too thin for the grid's world coordinates.
InputError rounding_error(const HeightGrid& grid);
/// True if every triangle is.
bool is_counterclockwise(const Mesh& mesh);

/// Makes world coordinates count from `origin`, in the grid; what they then are, no coordinate
/// reference system says.
void count_from(Point origin, HeightGrid& grid);

}  // namespace lepp

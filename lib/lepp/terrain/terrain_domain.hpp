#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lepp/geometry/pslg.hpp"
#include "lepp/terrain/height_grid.hpp"

namespace lepp {

/// A line that the TIN keeps as a chain of edges, in world coordinates.
struct Breakline {
  std::vector<Point> points;
  std::vector<double> heights;  ///< hard: one per point; soft: empty, heights are the grid's
  std::string name;             ///< what messages call it
};

/// A polygon in world coordinates: outer ring first, then holes; rings need not repeat the first
/// point at the end. Inside is what an odd number of its rings surrounds.
struct ClipPolygon {
  std::vector<std::vector<Point>> rings;
  std::string name = {};  ///< what messages call it
};

struct DomainOptions {
  std::vector<ClipPolygon> clip = {};  ///< the union of them; empty: all of the grid
  std::vector<Breakline> breaklines = {};
  /// A sample that stands alone on a side of the grid gets a triangle inside the grid, with a
  /// corner at the sample, in place of a square around it: for a grid whose neighbours, not known
  /// here, have the samples of that side too.
  bool islands_stay_inside = false;
};

/// What is to be meshed, in grid space (height_grid.hpp).
struct TerrainDomain {
  /// Curve 0 is the outline, of all parts and holes; curve i + 1 breakline i. Groups "outline",
  /// "breaklines" and "terrain".
  Pslg pslg;
  /// Heights that hard breaklines ask for, one per point of `pslg`; NaN: the grid's. Where a line
  /// crosses another line or the outline, its height there; of two hard lines, that of the first.
  std::vector<double> fixed_heights;
  /// One per segment of `pslg`, or empty: the heights along it are asked for, linear between those
  /// of its ends. Segments of the outline can be hard, too, and soft ones can join hard points.
  std::vector<bool> hard_segments = {};
  /// One per point of `pslg`, or empty: sides of the domain between two points marked here are
  /// never cut, so that the mesh beyond, of another tile, can end at the same vertices.
  std::vector<bool> kept_border = {};
  std::vector<std::string> warnings;
};

/// The outline of the samples that have data, holes where they have none, cut by clip polygons,
/// with breaklines inside. No closed triangle of a mesh of it has a sample without data in it, and
/// every sample with data (inside the clip polygons) is in one.
///
/// Covered are cells whose four samples have data, and the triangle of three that have; notches
/// with no sample in them are filled, and straight runs of the outline are one segment
/// (outline.hpp). A sample that no such cell has, alone or in a chain, gets a square of its own
/// around it, half a cell from corner to corner or less, so that it is covered, too. Every other
/// corner of the outline is a sample, until clip polygons cut it.
/// \throw InputError  no data at all; a grid of one row or column; lines that are no numbers;
///                    clip polygons that leave nothing
/// Cost   O(samples / 64 + n log n) for n samples along the outline; with lines that of a
///        constrained_delaunay() of both
/// Source docs/algorithms/terrain_domain.md
TerrainDomain terrain_domain(const HeightGrid& grid, const DomainOptions& options = {});

/// The height of the grid at a place in grid space: bilinear within cells whose four samples have
/// data; linear in the triangle of the three that have; else that of the nearest sample with data.
double height_at(const HeightGrid& grid, Point p);

}  // namespace lepp

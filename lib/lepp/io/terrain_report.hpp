#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lepp/io/report.hpp"
#include "lepp/terrain/simplify.hpp"

namespace lepp {

/// Wall-clock time of each part of a terrain run. Parts that did not run are 0.
struct TerrainSeconds {
  double read = 0, domain = 0, simplify = 0, nonobtuse = 0, fit = 0, measure = 0, check = 0,
         write = 0, total = 0;
};

/// A TIN that a run made: one per level of detail, or per tile.
struct TerrainFigures {
  std::string output;  ///< its file; empty if none was written
  std::string name;    ///< "level 1", "tile 0 2"; empty: the whole
  std::size_t vertices = 0, triangles = 0;
  TerrainError error;
  Point error_at;                             ///< world coordinates of the sample
  std::string problem = {};                   ///< of a tile that was not written: why; else empty
  std::optional<TerrainError> unfitted = {};  ///< before heights were fitted, if they were
  double min_angle_deg = 0;
  ReasonCounts below_bound = {};  ///< triangles below the bound of angles, by reason
};

/// How many triangles have their smallest angle from 5 i to 5 (i + 1) degrees.
using AngleHistogram = std::array<std::size_t, 12>;
AngleHistogram angle_histogram(const Mesh& mesh);

/// An edge that breaks the sphere criterion, by the surface metric, in world coordinates.
struct KeptEdge {
  Point a, b;
  KeptBy kept_by = KeptBy::constraint;
};

/// The TIN as a surface in space, heights and cells in one unit (surface_report.hpp).
struct TerrainInSpace {
  double min_angle_deg = 0, mean_min_angle_deg = 0;
  std::size_t tame = 0, untame = 0;  ///< insertions of the surface metric, after those of the plan
  std::vector<KeptEdge> kept_edges;  ///< by the surface metric
  double plan_angle_deg = 0;         ///< what the surface metric promises of angles in plan
};

/// The largest error with the first vertices of a TIN: `first` of them, then one more each.
struct PrefixErrors {
  std::size_t first = 0;
  std::vector<double> max_errors;
};

/// Everything a run of `lepp terrain` has to say. Angles are those of the plane with true cell
/// sizes; columns and rows count from 0, row 0 the first of the file.
struct TerrainReport {
  std::string input;
  std::size_t columns = 0, rows = 0;  ///< of the grid
  std::size_t samples = 0;            ///< with data
  double lowest = 0, highest = 0;     ///< heights
  std::string by, metric;
  std::optional<double> max_error, border_error;  ///< asked for
  std::optional<std::size_t> max_vertices;
  std::optional<double> min_angle_deg;
  std::optional<GridWindow> window;                  ///< that alone was read
  std::optional<std::array<std::size_t, 2>> tiling;  ///< rows and columns of tiles
  TerrainFigures whole;                              ///< of the finest level; over all tiles
  std::vector<TerrainFigures> levels;                ///< coarser ones, the coarsest first
  std::optional<PrefixErrors> prefixes;              ///< if asked for
  std::vector<TerrainFigures> tiles;  ///< row by row; the last one may have a problem
  double max_angle_deg_found = 0, mean_min_angle_deg = 0;
  AngleHistogram smallest_angles{};
  TerrainInSpace in_space;
  std::size_t obtuse_constrained = 0;
  std::optional<bool> admissible;
  std::optional<bool> error_kept;  ///< if a largest error was asked for
  bool goal_reached = false;
  bool valid = false;
  TerrainSeconds seconds;
  std::size_t peak_memory_bytes = 0;
  std::vector<std::string> warnings;
  std::vector<MeshViolation> violations;
};

/// As for RunReport (report.hpp): one JSON object; docs/report.md names its fields.
std::string to_json(const TerrainReport& report);

/// Line by line, for people.
std::string to_text(const TerrainReport& report);

}  // namespace lepp

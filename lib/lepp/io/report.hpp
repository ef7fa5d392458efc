#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/unfinished.hpp"
#include "lepp/triangulation/validate.hpp"
#include "lepp/voronoi/admissible.hpp"

namespace lepp {

/// The figures after one stage: a column of the paper's Tables 1 and 2.
struct StageFigures {
  std::string name;  ///< "triangulate", "refine" or "nonobtuse"
  Quality quality;
  std::size_t insertions = 0;  ///< vertices that the stage added
};

/// Wall-clock time of each part of a run. Parts that did not run are 0.
struct Seconds {
  double read = 0, triangulate = 0, refine = 0, nonobtuse = 0, measure = 0, voronoi = 0, check = 0,
         write = 0, total = 0;
};

struct GroupFigures {
  std::string name;
  int dimension = 0;
  int tag = 0;
  std::size_t entities = 0;  ///< points, curves or surfaces in the group
  double measure = 0;        ///< number of points, length or area
};

/// One figure for each Reason, in the order of the enumeration.
using ReasonCounts = std::array<std::size_t, 7>;

/// An edge without which the mesh would be admissible, in the user's numbers.
struct OffendingEdge {
  std::int64_t k = 0, l = 0;  ///< vertices, counted from the base of the input
  Point at_k, at_l;
  int region = 0;        ///< tag of the surface
  double factor = 0;     ///< the edge factor, negative
  double angle_deg = 0;  ///< sum of the angles opposite the edge inside the region
};
std::vector<OffendingEdge> offending_edges(const Mesh& mesh, const Certificate& certificate);

/// Everything a run of the program has to say. What does not apply stays empty.
struct RunReport {
  std::string input, output;
  Quality quality;  ///< of the mesh at the end
  std::size_t input_vertices = 0;
  std::size_t steiner_points = 0;
  ReasonCounts below_bound{};
  std::optional<bool> admissible;    ///< from a certificate
  std::optional<bool> goal_reached;  ///< of refinement
  std::optional<bool> valid;         ///< M1 to M5, and what was asked for
  std::vector<StageFigures> stages;
  Seconds seconds;
  std::size_t peak_memory_bytes = 0;
  std::vector<GroupFigures> groups;
  std::vector<std::string> warnings;
  std::vector<OffendingEdge> offending_edges;
  std::vector<MeshViolation> violations;  ///< of validate()
};

/// The report for machines: one JSON object, ended by a line end. Its keys are the names of the
/// fields above, with the figures of `quality` at the top; counts are the exact ones, and the
/// object `tolerant` has their twins that forgive 1e-9 degrees. What does not apply, and a figure
/// that is not finite, is null. `schema_version` grows when a key changes its meaning or goes away.
std::string to_json(const RunReport& report);

/// The report for people: a table with a column per stage, then what matters line by line.
std::string to_text(const RunReport& report);

ReasonCounts count_reasons(const std::vector<Unfinished>& unfinished);

/// The physical groups of a mesh with their lengths and areas.
std::vector<GroupFigures> group_figures(const Mesh& mesh);

/// The most memory this process has had so far; 0 where the system does not tell.
std::size_t peak_memory_bytes();

}  // namespace lepp

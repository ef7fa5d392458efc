#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "lepp/refine/refine.hpp"
#include "lepp/terrain/height_grid.hpp"
#include "lepp/terrain/sample_set.hpp"
#include "lepp/terrain/surface_report.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/terrain/tin.hpp"
#include "lepp/triangulation/unfinished.hpp"

namespace lepp {

/// How points are chosen.
enum class SimplifyBy {
  lepp,    ///< with angles in mind: a bound on every angle away from sharp input angles
  greedy,  ///< the worst sample of the worst triangle: fewest vertices, no bound on angles
};

/// In which metric edges are long and triangles Delaunay.
enum class TerrainMetric {
  planar,   ///< of the plane
  surface,  ///< of the surface in space: the paper's 3-D LEPP and sphere criterion
};

/// A level of detail: the first `vertices` of the TIN, triangulated with the same constraints.
struct TerrainLevel {
  std::size_t vertices = 0;
  double max_error = 0;  ///< found for this level
  /// Asked for, of a level that ends at a count. The domain alone may have more.
  std::optional<std::size_t> most_vertices = {};
  /// Triangles below the angle bound, as in SimplifyReport; ids are those of the level's TIN.
  std::vector<Unfinished> unfinished = {};
};

struct SimplifyOptions {
  double max_error = 0;  ///< largest |H - H*| at any sample with data, >= 0, in the unit of heights
  /// No more vertices than this, unless the domain alone has more, which leaves the goal
  /// unreached; with max_error = 0 as many as that allows.
  std::size_t max_vertices = std::numeric_limits<std::size_t>::max();
  SimplifyBy by = SimplifyBy::lepp;
  /// How much time `lepp` gives to fewer vertices: none, one round of clean-up, or many.
  Effort effort = Effort::normal;
  /// By the surface metric Effort::fast fits every sample by LEPP in space, the others start from
  /// the planar TIN.
  TerrainMetric metric = TerrainMetric::planar;
  double min_angle_deg = 30;  ///< of `lepp`, in the plane with true cell sizes; 0 to 34
  /// One run gives nested levels: for each error (descending, above max_error) the vertices of a
  /// level are the first ones of the next. Empty: the one level of max_error. A TIN that reaches
  /// several at once, as on flat ground, is all of them.
  std::vector<double> level_errors = {};
  /// Likewise by counts of vertices (ascending, below max_vertices).
  std::vector<std::size_t> level_vertices = {};
  /// Called with each level but the last when it is complete: its TIN, which a later level grows
  /// out of, and what was found for it.
  std::function<void(const Tin& tin, const TerrainLevel& level)> on_level = {};
  /// Called now and then with the number of vertices; false stops.
  std::function<bool(std::size_t vertices)> progress = {};
};

/// Two ways of interpolating the heights of a grid differ by less than this, in practice. A run
/// works until errors are at most that much above what was asked for, and is content with four
/// times it. Of floats it is 2^-48 of the largest; of doubles, which are compared with each other,
/// 2^-48 of their range, and what heights between samples are rounded by. Cost O(samples)
double interpolation_rounding(const HeightGrid& grid);

/// What an error is held to where `error` was asked for. \param rounding  as above
inline double kept_error(double error, double rounding) {
  return error * (1 + 1e-9) + 4 * rounding;
}

/// Of some samples the largest |H - H*|, and where (row of the file).
struct LargestError {
  double max = 0;
  std::uint32_t column = 0, row = 0;
};

/// How far a TIN is from its grid, over all samples with data, those on the rim included.
struct TerrainError {
  double max = 0;                     ///< largest |H - H*|
  std::uint32_t column = 0, row = 0;  ///< where (row of the file)
  double highest = 0, lowest = 0;     ///< largest and smallest H - H*
  double rms = 0;
  std::size_t samples = 0;  ///< with data and in the mesh
  std::size_t lost = 0;     ///< with data, not in the mesh
  std::size_t covered = 0;  ///< without data, inside a triangle
  /// Of the samples that lie on hard lines, whose heights are not the grid's to choose, and of all
  /// others: what a bound can be kept for.
  LargestError on_hard_lines, elsewhere;
  std::size_t samples_on_hard_lines = 0;
};

struct SimplifyReport {
  /// The error is kept but on hard lines, every angle but those that the input excuses, and the
  /// number of vertices.
  bool goal_reached = false;
  TerrainError error;
  std::vector<TerrainLevel> levels;  ///< the last one is the TIN itself
  std::size_t first_prefix = 0;      ///< vertices of the domain alone
  /// Greedy: the largest error, of all samples, with the first `first_prefix` vertices, then with
  /// one more each, up to the whole: of the TIN that a run with so many as max_vertices makes.
  std::vector<double> error_of_prefix;
  /// Triangles below the angle bound, and why; by the surface metric those with an angle in plan
  /// below 15 degrees (or the bound, if that is less).
  std::vector<Unfinished> unfinished;
  SurfaceReport surface;  ///< angles in space, by either metric
};

/// A grid as a TIN within a domain.
/// \param domain  outline, holes and breaklines in grid space, and heights that lines ask for
/// \return  a TIN in grid space; its mesh satisfies M1 to M6, or M1 to M5 by the surface metric
///          (validate_surface.hpp says what holds in place of M6)
/// \throw   InputError on options out of range, RefusedError
/// Source   [rivara1999] section 8, [garland1995]; docs/algorithms/terrain.md, terrain_surface.md
Tin simplify(const HeightGrid& grid, const TerrainDomain& domain, const SimplifyOptions& options,
             SimplifyReport& report);

/// The error of any TIN of a grid, computed from nothing but the two, sample by sample, in double
/// precision. The result does not depend on `threads`.
/// \param inside  given: samples that are not in it are not lost (samples_inside.hpp)
/// Cost O(samples + triangles)
TerrainError measure_error(const HeightGrid& grid, const Tin& tin,
                           const SampleSet* inside = nullptr, unsigned threads = 2);

}  // namespace lepp

#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lepp/refine/steiner_point.hpp"
#include "lepp/triangulation/mesh.hpp"
#include "lepp/triangulation/unfinished.hpp"

namespace lepp {

/// What refine() does with angles above 90 degrees opposite constrained edges.
enum class ObtuseRule {
  split_first,  ///< an encroached constrained edge is split before any quality insertion
  ignore,       ///< they are left alone (nonobtuse.hpp can remove them afterwards)
};

/// How much time goes into fewer vertices. Every effort keeps every promise.
enum class Effort {
  fast,    ///< one pass of insertions
  normal,  ///< vertices are moved before others are inserted, and needless ones removed
  best,    ///< several rounds of moving, removing and inserting again
};

struct RefineOptions {
  double min_angle_deg = 30;  ///< 0 to 45; 0 asks for nothing, above 36 is not promised
  /// Largest angle of any triangle, 90 to 180; 180 asks for nothing, below 100 is not promised.
  double max_angle_deg = 180;
  double max_edge = std::numeric_limits<double>::infinity();  ///< longest edge wanted, > 0
  double max_area = std::numeric_limits<double>::infinity();  ///< largest triangle wanted, > 0
  /// The longest edge wanted at a point, > 0 (infinite: as long as it likes); null asks for
  /// nothing. A SizeField keeps it from changing faster than a grading.
  std::function<double(Point)> size = {};
  /// The longest edge wanted in a counter-clockwise triangle, > 0, where the size at points does
  /// not say it all: sizes that hold in any triangle that meets a region, for example. The least
  /// of both counts; null asks for nothing, and a SizeField as `size` needs none.
  std::function<double(Point a, Point b, Point c)> size_in = {};
  Placement placement = Placement::offcentre;
  Effort effort = Effort::normal;
  ObtuseRule obtuse = ObtuseRule::split_first;
  /// Largest number of vertices, all included; 0 means the default budget,
  /// 50 * (input vertices + 1000 + area / (0.43 h^2)) where a size h is asked for.
  std::size_t max_vertices = 0;
  /// Called now and then with the number of vertices; false stops with reason `cancelled`.
  std::function<bool(std::size_t vertices)> progress = {};
};

struct RefineReport {
  bool goal_reached = false;  ///< no triangle is unfinished but for input_angle and input_feature
  std::size_t steiner_points = 0;
  std::vector<Unfinished> unfinished;  ///< every triangle that breaks a bound, ascending
};

/// Raises every angle to `min_angle_deg`, brings every size below its bound and, with
/// ObtuseRule::split_first, leaves no angle above 90 degrees opposite a constrained edge.
/// Sizes by region are those of the mesh's surface entities; the smallest size asked for counts.
/// \pre     `mesh` satisfies M1 to M6
/// \return  always, with a mesh that satisfies M1 to M6, and a reason per unfinished triangle
/// \throw   InputError on options out of range; RefusedError when the sizes alone predict more
///          than 1e8 triangles
/// Cost     O(log n) per Steiner point. Source [rivara1999]; docs/algorithms/refine.md
RefineReport refine(Mesh& mesh, const RefineOptions& options = {});

/// What refine() would find unfinished in `mesh`, without inserting anything. Triangles that the
/// input does not excuse carry the reason `otherwise`.
RefineReport judge(const Mesh& mesh, const RefineOptions& options, Reason otherwise);

/// A caller's measure of how good a triangle is, and what is good enough (q(t) >= epsilon).
struct QualityIndicator {
  enum class Measures {
    shape,  ///< triangles whose shape the input forces are left alone
    size,   ///< any triangle can be made good by making it smaller
  };
  std::function<double(const Mesh&, TriangleId)> q;
  double epsilon = 0;
  Measures measures = Measures::shape;
};

/// The smallest angle in degrees, wanted to be at least `bound_deg`: what refine() asks for.
QualityIndicator smallest_angle_indicator(double bound_deg);

/// The triangulation improvement problem (Definition 3 of the paper, by its Figure 3): for each
/// target, Delaunay insertions at the end of its LEPP until it is gone or q(t) >= epsilon; new
/// triangles below epsilon become targets too. Bad triangles that are no target, and do not
/// change, are left alone. `options` means what it means to refine(), but for min_angle_deg, whose
/// place `quality` takes.
/// \pre     `mesh` satisfies M1 to M6; every id in `targets` is one of its triangles
/// \return  as refine(); `unfinished` leaves out triangles that were bad, no target, and unchanged
RefineReport improve(Mesh& mesh, std::span<const TriangleId> targets,
                     const QualityIndicator& quality, const RefineOptions& options = {});

}  // namespace lepp

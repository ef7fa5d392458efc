#pragma once

#include <cstddef>
#include <vector>

#include "lepp/voronoi/voronoi_boxes.hpp"
#include "linear_system.hpp"

namespace lepp::demo {

/// A thin plate, insulated below, held at 1 on the left half of its upper side and at the left
/// end, at 0 on the right half and at the right end. Nothing is produced inside, so the
/// temperature lies between 0 and 1 everywhere.
struct ThinPlate {
  Pslg pslg;
  PoissonProblem step;    ///< the data above
  PoissonProblem linear;  ///< u = x + 2y on the same plate: the flux -2 comes in from below
};
ThinPlate thin_plate();

/// What a scheme makes of the plate.
struct SchemeOutcome {
  Eigen::VectorXd u;               ///< for the step data
  double lowest = 0, highest = 0;  ///< of u
  double linear_error = 0;         ///< largest error at a vertex where the solution is x + 2y
};

/// The three schemes on one mesh of the plate.
struct PlateOutcome {
  Mesh mesh;
  bool admissible = false;
  std::size_t obtuse_constrained = 0;  ///< angles above 90 degrees opposite constrained edges
  SchemeOutcome fe;                    ///< finite elements
  SchemeOutcome fv_unclipped;          ///< finite volumes with signed edge factors
  SchemeOutcome fv;                    ///< finite volumes on boxes clipped to the domain
};

/// Solves on the constrained Delaunay triangulation of the plate as it is drawn: obtuse angles
/// face its boundary.
PlateOutcome plate_with_obtuse_boundary(const ThinPlate& plate);

/// Solves on the mesh of the whole pipeline.
PlateOutcome plate_with_nonobtuse_boundary(const ThinPlate& plate);

}  // namespace lepp::demo

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp::demo {

/// A quantity that depends on the place.
using Field = std::function<double(Point)>;

/// Part of the boundary or of the interfaces: every edge of these curves, every one of these
/// points.
struct BoundaryPart {
  std::string name;  ///< what messages and reports call it
  std::vector<CurveId> curves;
  std::vector<PointEntityId> points;  ///< Dirichlet conditions only
};

/// u = value.
struct Dirichlet {
  BoundaryPart part;
  Field value;
};

/// D du/dn = flux, n pointing outwards. On an interior curve: a line source of that strength.
struct Neumann {
  BoundaryPart part;
  Field flux;
};

/// D du/dn = alpha (outside - u). On an interior curve: an exchange with the outside.
struct Robin {
  BoundaryPart part;
  double alpha = 0;  ///< > 0
  Field outside;
};

/// -div(D grad u) = f, with D constant in each region. A boundary edge without a condition lets
/// nothing through.
struct PoissonProblem {
  std::vector<double> diffusion;  ///< D > 0, indexed by region (SurfaceId)
  std::vector<Field> source;      ///< f, indexed by region; an empty function is 0
  std::vector<Dirichlet> dirichlet;
  std::vector<Neumann> neumann;
  std::vector<Robin> robin;
};

/// One more than the largest region id of a triangle: the length of `diffusion` and `source`.
std::size_t region_count(const Mesh& mesh);

/// The edges of a part, each once.
std::vector<HalfEdge> edges_of(const Mesh& mesh, const BoundaryPart& part);

/// A vertex with a Dirichlet condition.
struct FixedValue {
  double value = 0;
  std::size_t condition = 0;  ///< index into PoissonProblem::dirichlet
};

/// For each vertex its Dirichlet value, if it has one. Where two conditions meet the first wins.
std::vector<std::optional<FixedValue>> fixed_values(const Mesh& mesh,
                                                    const PoissonProblem& problem);

/// A solution is unique only if each connected part of the mesh meets a Dirichlet or Robin edge.
/// \throw InputError  naming a point of a part that does not
void check_unique(const Mesh& mesh, const PoissonProblem& problem);

}  // namespace lepp::demo

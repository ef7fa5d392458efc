#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lepp/refine/allowance.hpp"
#include "lepp/refine/bad_triangles.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/encroached.hpp"

namespace lepp {

/// The paper's loop: one insertion at the end of the LEPP of the worst target, placed by rule C
/// (steiner_point.hpp); with ObtuseRule::split_first encroached constrained edges go first.
class TerminalLoop {
 public:
  TerminalLoop(Mesh& mesh, const RefineOptions& options, std::size_t budget, Judge judge);

  void add_target(TriangleId t) { bad_.add(mesh_, t); }

  /// Between two turns the mesh satisfies M1 to M6. Ends: each turn adds a vertex, of which there
  /// are at most `budget`, or drops an entry for good.
  void run();

  /// Why it stopped before the work was done, if it did.
  std::optional<Reason> stopped() const { return allowance_.stopped(); }

 private:
  bool cut(HalfEdge e);
  void improve(TriangleId t);
  bool insert(const SteinerPoint& s);
  bool cut_first_possible(const std::vector<HalfEdge>& edges);
  bool is_too_close(const SteinerPoint& s) const;

  Mesh& mesh_;
  const RefineOptions& options_;
  double floor_;
  Allowance allowance_;
  BadTriangles bad_;
  std::vector<TriangleId> changed_;
};

}  // namespace lepp

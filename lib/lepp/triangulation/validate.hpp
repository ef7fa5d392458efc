#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lepp/triangulation/mesh.hpp"
#include "lepp/triangulation/unfinished.hpp"

namespace lepp {

/// What a mesh claims besides M1 to M6.
struct MeshClaims {
  bool delaunay = true;  ///< check M6
  /// M7: every angle reaches it, or the triangle is in `unfinished` with a reason that holds.
  std::optional<double> min_angle_deg = {};
  /// M9: no angle is above it (exact for 90, else up to 1e-9 degrees); triangles in `unfinished`
  /// may break it, for their input angles only by rounding.
  std::optional<double> max_angle_deg = {};
  bool nonobtuse = false;                   ///< M8; triangles in `unfinished` may break it
  std::vector<Unfinished> unfinished = {};  ///< ascending by triangle, as refine() reports them
};

struct MeshViolation {
  std::string rule;   ///< "M1" ... "M9"
  std::string where;  ///< ids and coordinates
};

struct MeshReport {
  std::vector<MeshViolation> violations;  ///< at most 20 per rule
  std::size_t count = 0;                  ///< all of them
  bool valid() const { return count == 0; }
  std::string summary() const;  ///< "valid", or the first violations
};

/// M1 ids in range, every vertex used. M2 triangles strictly counter-clockwise. M3 twin(twin(e))
/// == e with the same two vertices, no edge of three triangles. M4 boundary edges are constrained,
/// edges between regions too, both sides of an edge agree. M5 each segment is a chain of
/// constrained edges, and each constrained edge has a record. M6 each unconstrained edge is locally
/// Delaunay (exact). M7 to M9: the claims. Collects violations, throws nothing, changes nothing,
/// and shares nothing but the predicates with what it checks (and InputReasons, where a claim names
/// a reason).  Cost O(n log n).
MeshReport validate(const Mesh& mesh, const MeshClaims& claims = {});

}  // namespace lepp

#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Whether a vertex can be removed, or why not.
enum class Removability {
  from_inside,         ///< yes: it ends no constrained edge
  from_segment,        ///< yes: the two constrained edges it ends become one again
  input_vertex,        ///< a point of the input or a crossing
  end_of_segments,     ///< it ends one constrained edge, or more than two
  different_segments,  ///< its two constrained edges belong to different segments
  bent,                ///< they are not collinear, exactly
  curved,              ///< they are pieces of a curve that is not straight
};
Removability removability(const Mesh& mesh, VertexId v);
constexpr bool is_removable(Removability r) {
  return r == Removability::from_inside || r == Removability::from_segment;
}
/// A clause for messages, such as "it is a point of the input".
std::string_view to_string(Removability r);

/// What a removal changed.
struct Removal {
  /// Every triangle that has other corners now, by its id now; ascending, without repetitions.
  std::vector<TriangleId> changed;
  struct TriangleMove {
    TriangleId from, to;
  };
  /// At most two triangles stay as they are but take a lower id: those that were last.
  std::vector<TriangleMove> moved_triangles;
  /// The vertex that was last and has the id of the removed one now, if that was not the last.
  std::optional<VertexId> moved_vertex;
};

/// Removes a Steiner point and makes the mesh constrained Delaunay again:
///
///       q---p                q---p        flips cut ears such as p q r off the star of v
///      / \ / \              / `-._\       until three corners are left, or four around a
///     r---v---o     --->   r---.__o       diagonal through v; these are filled without v,
///      \ / \ /              \ `-._|       and restore_delaunay() does the rest
///       s---t                s---t
///
/// The last vertex and the last triangles move into the free places.
/// \pre    M1 to M6
/// \return nothing, and the mesh as it was, unless is_removable(removability(mesh, v))
/// Cost    O(degree) typical, O(degree^2) worst. docs/algorithms/locate.md says why it never stops.
std::optional<Removal> remove_vertex(Mesh& mesh, VertexId v);

}  // namespace lepp

#pragma once

#include <cstdint>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

// A mesh as a .msh file wants it: sorted into points, curves and surfaces with positive tags that
// are unique in their dimension.

struct MshPoint {
  int tag = 0;
  VertexId vertex;
  std::vector<GroupId> groups;
  bool is_written = false;  ///< as an element; else it is only the end of a curve
};

struct MshLine {
  VertexId a, b;  ///< in the direction of the curve
};

struct MshCurve {
  int tag = 0;
  std::vector<GroupId> groups;
  std::vector<MshLine> lines;
  std::vector<VertexId> ends;  ///< start and end if it is one open chain, else none
  bool is_implied = true;      ///< every line separates regions, so the triangles tell it too
  bool is_written = true;      ///< as elements
};

struct MshSurface {
  int tag = 0;
  std::vector<GroupId> groups;
  std::vector<TriangleId> triangles;
  std::vector<int> boundary;  ///< tags of its curves, negative where the surface lies to the right
};

struct MshEntities {
  std::vector<PhysicalGroup> groups;
  std::vector<MshPoint> points;
  std::vector<MshCurve> curves;      ///< with lines only
  std::vector<MshSurface> surfaces;  ///< with triangles only
  /// The entity of lowest dimension that each vertex lies on: index into the list of `dimension`.
  struct Owner {
    std::uint32_t dimension = 2;
    std::uint32_t index = 0;
  };
  std::vector<Owner> owner_of_vertex;
};

/// Sorts vertices, constrained edges and triangles to their entities. Cost O(n + c log c), c
/// constrained edges. \pre M1 to M4
MshEntities msh_entities(const Mesh& mesh);

/// Leaves no element without group beside elements with one, because readers of format 4.1 refuse
/// or lose such files. Like Gmsh, it leaves out points and curves without group; but curves that
/// the triangles do not imply, and surfaces, are put into a group "ungrouped" of their dimension.
/// Does nothing to a mesh without groups.
void leave_nothing_ungrouped(MshEntities& entities);

}  // namespace lepp

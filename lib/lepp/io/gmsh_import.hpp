#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lepp/geometry/pslg.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp {

struct GmshOptions {
  /// Pieces of a curve stay this close to it, as a share of the curve's bounding box.
  double chord_tolerance = 1e-3;
  /// Take the boundary points from Gmsh even if the file sets no sizes.
  bool gmsh_sizes = false;
  double seconds = 60;                               ///< wall-clock limit of the helper
  std::size_t memory_bytes = std::size_t{4} << 30U;  ///< address space of the helper
  std::optional<std::filesystem::path> helper;       ///< the program lepp-gmsh, if not where it is
                                                     ///< looked for
  /// Asked about once a second while the helper works; false ends it with a RefusedError.
  std::function<bool()> keep_going = {};
};

/// What a Gmsh file holds.
struct GmshInput {
  Pslg pslg;  ///< the geometry; of a .msh file its outline, interfaces and lines
  std::optional<TriangleSoup> triangles;  ///< only of a .msh file
  /// The pieces of the boundary are Gmsh's, as long as the file's sizes ask for.
  bool pieces_have_sizes = false;
  /// The sizes of points inside surfaces.
  std::vector<std::pair<Point, double>> inner_sizes;
  std::vector<std::string> warnings;  ///< one sentence each, ready to print
};

/// Reads a .geo script, or a .msh file of any version that Gmsh 4.8.4 reads, through the separate
/// program lepp-gmsh: the library itself neither links nor runs Gmsh.
///
/// Of a .geo file: points are the ends of curves, their pieces, and embedded points. Where the file
/// sets sizes, Transfinite curves or fields, or with `gmsh_sizes`, the pieces are Gmsh's, and
/// Mesh.MeshSizeMax and the sizes of embedded points hold inside. Otherwise
/// a straight curve is one piece, any other the fewest pieces within the chord tolerance that turn
/// by at most 30 degrees each. Curved pieces that would collide are halved until they do not, so
/// that a vertex put on the curve later stays on its side of everything else.
/// Curves are exact lines and arcs, else cubics within 1e-9 of the curve's size.
///
/// \throw InputError   with Gmsh's own message where there is one: syntax, no surface, a boundary
///                     that is not closed, a surface without area, points outside one plane,
///                     elements other than 3-node triangles; no helper program
/// \throw RefusedError time or memory limit, or sizes that ask for too many points
/// \throw OutputError  no room for the private copy
GmshInput read_gmsh(const std::filesystem::path& file, const GmshOptions& options = {});

/// The geometry alone.
Pslg read_geo(const std::filesystem::path& file, const GmshOptions& options = {});

}  // namespace lepp

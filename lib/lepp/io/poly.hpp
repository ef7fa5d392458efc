#pragma once

#include <filesystem>
#include <span>

#include "lepp/geometry/pslg.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

// The files of Triangle: .node, .poly, .ele and .edge. Numbers start at 0 or 1, whichever the
// first vertex has, and are consecutive; '#' starts a comment.
//
// A boundary marker other than 0 makes its segments one curve with that tag. A regional attribute
// makes a surface: its tag is the attribute if that is a whole number, else the next free one.
// Positive tags are physical groups too, so that they reach formats that know groups.
// Attributes and markers of vertices are read and dropped.

/// Reads a PSLG from X.poly, or only points from X.node.
/// A .poly file with 0 vertices takes them from the .node file beside it. A region line with four
/// numbers sets the attribute and no area limit; so does a limit that is not positive.
/// \throw InputError  naming file, line and, where there is one, vertex, segment, hole or region
Pslg read_poly(const std::filesystem::path& path);

/// Reads triangles from X.ele, vertices from X.node, and the edges to keep from X.poly (all its
/// segments) or else from X.edge (those with a marker), if there is one.
/// The first attribute of a triangle is its region.
/// \throw InputError  as above, and naming the triangle; six-node triangles are refused
TriangleSoup read_ele(const std::filesystem::path& path);

/// Writes points, segments with the tags of their curves as markers, holes and regions.
/// If the curves say what they bound (Pslg), the holes and region points are found by
/// triangulating. \throw OutputError; InputError as constrained_delaunay()
void write_poly(const Pslg& pslg, const std::filesystem::path& path);

/// Writes X.node, X.ele and X.poly as one atomic set; `path` is X.ele. Triangles carry the
/// attribute of their region. X.poly has no vertices of its own and holds all constrained edges,
/// each with a marker that is not 0 (the tag of its curve, else 1), a point in each hole and one in
/// each connected region. Numbers start where those of the input did.
/// \param heights  an attribute of the vertices, one per vertex; empty: no attribute. With them,
///        triangles of a single surface carry none.
/// \throw OutputError
void write_ele(const Mesh& mesh, const std::filesystem::path& path,
               std::span<const double> heights = {});

/// The files that it writes, in that order.
std::vector<std::filesystem::path> ele_files(const std::filesystem::path& path);

}  // namespace lepp

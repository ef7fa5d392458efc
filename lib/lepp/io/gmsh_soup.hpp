#pragma once

#include <string>

#include "lepp/io/gmsh_import.hpp"
#include "lepp/io/gmsh_mesh_file.hpp"
#include "lepp/io/gmsh_record.hpp"

namespace lepp {

/// The triangles of a .msh file from what the helper says about it, and the PSLG of its boundary,
/// interfaces and lines.
///
/// Nodes and triangles keep their numbers. Nodes that no triangle has, and lines that are no edge
/// of a triangle, are dropped with a warning; repeated lines and triangles count once. Every
/// boundary and interface edge gets a curve: that of a line of the file, else one with tag 0 for
/// each combination of surfaces beside it. \throw InputError  no triangles; nodes outside one
/// plane, unless all triangles face up (a terrain, which is read in plan, with a warning); a curve
/// or surface unknown
GmshInput soup_from_gmsh(const GmshRecord& record, const ElementGroups& old_groups,
                         const std::string& source);

}  // namespace lepp

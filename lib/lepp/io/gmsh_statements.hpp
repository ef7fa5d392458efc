#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lepp/io/gmsh_script.hpp"

namespace lepp {

/// An Include or Merge statement with the file name as written.
struct IncludedFile {
  std::string name;
  std::size_t line = 1;
};

/// What one .geo script asks for, beside geometry.
struct GeoStatements {
  std::vector<IncludedFile> included;
};

/// Looks at every statement of `text`: notes sizes, curve loops and included files, blanks the
/// statements that write files or make meshes, and warns of what has no effect.
/// \param name    what messages call this script
/// \throw InputError  statements that run commands, write by other means or end the process;
///                    an included name that is not a plain string
GeoStatements inspect_geo(std::string& text, const std::string& name, GmshScript& script);

}  // namespace lepp

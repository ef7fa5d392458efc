#pragma once

#include <string>

#include "lepp/io/gmsh_import.hpp"
#include "lepp/io/gmsh_record.hpp"
#include "lepp/io/gmsh_script.hpp"

namespace lepp {

/// The PSLG of a .geo file from what the helper says about it.
/// \throw InputError as read_gmsh()
GmshInput pslg_from_gmsh(const GmshRecord& record, const GmshScript& script,
                         const std::string& source, const GmshOptions& options);

}  // namespace lepp

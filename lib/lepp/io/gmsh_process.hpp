#pragma once

#include <string>

#include "lepp/io/gmsh_import.hpp"
#include "lepp/io/gmsh_record.hpp"
#include "lepp/io/helper_process.hpp"

namespace lepp {

/// What the helper shall do with the file in the private folder.
struct GmshTask {
  std::string file;          ///< its name inside the folder
  bool own_points = false;   ///< return Gmsh's own points on the curves
  std::string display_name;  ///< what messages call the input
};

/// Runs lepp-gmsh in the private folder and waits for its record, no longer than options.seconds;
/// then the helper and all it may have started are killed. The program is options.helper, or as
/// find_helper() finds it with the environment variable LEPP_GMSH.
/// \throw RefusedError  time or memory limit; InputError  Gmsh ended without a result, or a failure
///                      that the record reports; no such program
GmshRecord run_gmsh_helper(const PrivateFolder& folder, const GmshTask& task,
                           const GmshOptions& options);

}  // namespace lepp

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "lepp/io/gmsh_import.hpp"
#include "lepp/io/gmsh_record.hpp"

namespace lepp {

/// An empty folder of our own among the temporary files, removed with all that is in it.
class PrivateFolder {
 public:
  /// \throw OutputError if it cannot be made
  PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The helper program: options.helper; else the environment variable LEPP_GMSH; else lepp-gmsh
/// beside the running program, or in ../libexec/lepp.
/// \throw InputError  that says how to install it
std::filesystem::path find_gmsh_helper(const GmshOptions& options);

/// What the helper shall do with the file in the private folder.
struct GmshTask {
  std::string file;          ///< its name inside the folder
  bool own_points = false;   ///< return Gmsh's own points on the curves
  std::string display_name;  ///< what messages call the input
};

/// Runs the helper in the private folder and waits for its record, no longer than options.seconds;
/// then the helper and all it may have started are killed.
/// \throw RefusedError  time or memory limit; InputError  Gmsh ended without a result, or a failure
///                      that the record reports
GmshRecord run_gmsh_helper(const PrivateFolder& folder, const GmshTask& task,
                           const GmshOptions& options);

}  // namespace lepp

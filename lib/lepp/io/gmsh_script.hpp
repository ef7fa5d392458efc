#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lepp {

/// A curve loop written with plain numbers, for messages that can name it.
struct CurveLoopText {
  int tag = 0;
  std::vector<int> curves;  ///< without their signs
};

/// What was seen while a .geo script was copied.
struct GmshScript {
  bool sets_sizes = false;  ///< point sizes, Transfinite curves, fields, layers, size options
  bool sets_field = false;  ///< a background field
  std::vector<CurveLoopText> loops;
  std::vector<std::string> warnings;
};

/// Name of the script inside the private folder.
inline constexpr const char* private_script_name = "lepp-input.geo";

/// Copies a .geo script and what it includes or merges into an empty private folder.
///
/// The copies have LF line ends, a final newline and no byte-order mark. Statements that write
/// files or make meshes (Mesh, Save, Print, ...) become blanks, with a warning: line numbers stay.
/// \throw InputError  statements that run commands or end the process; an include outside the
///                    script's folder, inside itself, or not a plain file name; a binary file
/// \throw RefusedError  more than 64 MiB of scripts or 1,000 included files
GmshScript copy_geo_script(const std::filesystem::path& script,
                           const std::filesystem::path& private_folder);

}  // namespace lepp

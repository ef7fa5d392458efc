#pragma once

#include <cstdint>
#include <filesystem>
#include <unordered_map>

namespace lepp {

/// Name of the mesh inside the private folder.
inline constexpr const char* private_mesh_name = "lepp-input.msh";

/// The physical tag of each element, by its number; 0 for none. Only formats 1 and 2 write groups
/// element by element: Gmsh gives them all to the whole entity, which is wrong in files where one
/// elementary tag stands for several groups. Empty for the newer formats.
using ElementGroups = std::unordered_map<std::int64_t, int>;

/// True if the file starts with '$', as every .msh file does and no .geo script can.
bool looks_like_msh(const std::filesystem::path& file);

/// Looks through a .msh file of any version and copies it into the private folder.
///
/// What Gmsh would take on trust is checked here: the version, every count against the bytes that
/// are left, node numbers of the older formats. It must hold 3-node triangles, and beside them
/// nothing but 2-node lines and points.
/// \throw InputError    naming the line, or the kind and number of other elements
/// \throw RefusedError  larger than 4 GiB
ElementGroups copy_mesh_file(const std::filesystem::path& file,
                             const std::filesystem::path& private_folder);

}  // namespace lepp

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lepp/geometry/point.hpp"
#include "lepp/io/msh.hpp"
#include "lepp/terrain/world_tin.hpp"

namespace lepp {

// Files that hold a TIN. World coordinates as they are (but STL and single-precision Selafin, see
// there), x and y first, heights up; triangles counter-clockwise seen from above, in the order of
// the mesh; vertices in the order of the mesh. All throw OutputError.

/// Wavefront OBJ, text.
void write_obj(const WorldTin& tin, const std::filesystem::path& path);

/// PLY, binary little-endian, coordinates as doubles.
void write_ply(const WorldTin& tin, const std::filesystem::path& path);

enum class OffsetDigits {
  decimal,  ///< as many digits behind the point as a part of the extent needs, so few to print
  whole,    ///< whole units: what Selafin has room for
};

/// What is subtracted from x and y in files of 32-bit coordinates: the south-west corner rounded
/// down, or 0 where the coordinates are no larger than twice the extent. In decimal digits it is
/// rounded by less than the extent, so that 24 bits are left for places within the TIN.
Point offset_of_float_files(const WorldTin& tin, OffsetDigits digits = OffsetDigits::decimal);

/// The largest distance along x or y by which such a file moves a vertex.
double rounding_of_float_file(const WorldTin& tin, OffsetDigits digits);

/// STL, binary. Its floats keep 7 digits, so offset_of_float_files() is subtracted from x and y;
/// the header of the file says what to add.
/// \throw InputError  where triangles lose their area in floats all the same
void write_stl(const WorldTin& tin, const std::filesystem::path& path);

/// ADCIRC grid (fort.14, .14, .grd) and SCHISM (.gr3), which are the same: depths, positive down;
/// numbers from 1; no open boundary. Each outer loop is a land boundary of type 0, its first node
/// again at the end; each hole is an island, type 1, clockwise, closed implicitly. Where parts of the
/// mesh touch, each has a loop of its own (simple_boundary_loops()).
void write_adcirc(const WorldTin& tin, const std::filesystem::path& path);

/// SMS 2DM: MESH2D, E3T with the region's tag as material, ND.
void write_2dm(const WorldTin& tin, const std::filesystem::path& path);

enum class SelafinPrecision {
  doubles,  ///< SERAFIND
  floats,   ///< SERAFIN: offset_of_float_files(), whole, is subtracted and stored as X_ORIG
};

/// TELEMAC Selafin: one variable BOTTOM in metres, one time step. IPOBO numbers the boundary
/// vertices loop by loop, the mesh on the left.
/// \throw RefusedError  beyond 2^31 bytes in a record; floats: beyond 2^31 the origin is out of range
/// \throw InputError    floats: triangles lose their area
void write_selafin(const WorldTin& tin, const std::filesystem::path& path,
                   SelafinPrecision precision = SelafinPrecision::doubles);

/// UGRID 1.0 in netCDF (classic format with 64-bit offsets): mesh2d with nodes, edges, faces,
/// heights as mesh2d_node_z, start_index 1, and the coordinate reference system as crs_wkt, with its
/// EPSG code if it has one. Lengths have the unit that it says (none is written if it says none);
/// heights that of its vertical part, or else the one of lengths, in degrees the metre.
/// \throw RefusedError  beyond 2^32 bytes in a variable
void write_ugrid(const WorldTin& tin, const std::filesystem::path& path);

struct TinFormat {
  MshFormat msh = MshFormat::msh41;
  SelafinPrecision selafin = SelafinPrecision::doubles;
};

/// The kinds of files that write_tin() knows, by what their names end with.
bool is_tin_file(const std::filesystem::path& path);
std::string tin_file_kinds();  ///< for messages

/// The files that write_tin() makes. A coordinate reference system goes into a .prj file beside,
/// but where the format holds it: UGRID.
std::vector<std::filesystem::path> tin_files_of(const std::filesystem::path& path, bool has_crs);

/// True if a file is a .prj with this coordinate reference system, blanks at its end apart: a TIN
/// beside its grid may share it, and write_tin() leaves it as it is.
bool is_prj_of(const std::filesystem::path& path, const std::string& crs);

/// The digits of the offset, if write_tin() writes coordinates as floats.
std::optional<OffsetDigits> offset_of_format(const std::filesystem::path& path,
                                             const TinFormat& format = {});

/// Writes the format that the name says: the ones above, .msh, .vtu (heights as z and as point
/// data `height`) and .ele (with .node and .poly; heights as attribute). \pre is_tin_file(path)
void write_tin(const WorldTin& tin, const std::filesystem::path& path,
               const TinFormat& format = {});

}  // namespace lepp

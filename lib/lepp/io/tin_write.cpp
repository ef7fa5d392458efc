#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "lepp/io/atomic_files.hpp"
#include "lepp/io/file_kind.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/io/tin_files.hpp"
#include "lepp/io/vtu.hpp"

namespace lepp {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 12> kinds = {".obj", ".ply", ".stl", ".14",  ".grd", ".gr3",
                                                    ".2dm", ".slf", ".nc",  ".msh", ".vtu", ".ele"};

void write_vtu(const WorldTin& tin, const fs::path& path) {
  VtuData data;
  data.heights = tin.heights;
  data.at_vertices.push_back({"height", tin.heights});
  write_vtu(tin.mesh, path, data);
}

void write_mesh(const WorldTin& tin, const fs::path& path, const TinFormat& format) {
  const std::string kind = file_kind(path);
  if (kind == ".obj") write_obj(tin, path);
  else if (kind == ".ply") write_ply(tin, path);
  else if (kind == ".stl") write_stl(tin, path);
  else if (kind == ".2dm") write_2dm(tin, path);
  else if (kind == ".slf") write_selafin(tin, path, format.selafin);
  else if (kind == ".nc") write_ugrid(tin, path);
  else if (kind == ".msh") write_msh(tin.mesh, path, format.msh, tin.heights);
  else if (kind == ".vtu") write_vtu(tin, path);
  else if (kind == ".ele") write_ele(tin.mesh, path, tin.heights);
  else write_adcirc(tin, path);
}

}  // namespace

bool is_tin_file(const fs::path& path) {
  return std::ranges::find(kinds, std::string_view(file_kind(path))) != kinds.end();
}

std::string tin_file_kinds() {
  std::string text;
  for (const std::string_view kind : kinds) {
    if (!text.empty()) text += kind == kinds.back() ? " or " : ", ";
    text += kind;
  }
  return text;
}

std::vector<fs::path> tin_files_of(const fs::path& path, bool has_crs) {
  const std::string kind = file_kind(path);
  std::vector<fs::path> files = kind == ".ele" ? ele_files(path) : std::vector{path};
  if (has_crs && kind != ".nc") files.push_back(fs::path(path).replace_extension(".prj"));
  return files;
}

bool is_prj_of(const fs::path& path, const std::string& crs) {
  std::error_code error;
  if (path.extension() != ".prj" || !fs::is_regular_file(path, error)) return false;
  const auto size = fs::file_size(path, error);
  if (error || size < crs.size() || size > crs.size() + 64) return false;
  std::ifstream in(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  in.read(text.data(), static_cast<std::streamsize>(size));
  return in && text.starts_with(crs) && text.find_first_not_of(" \t\r\n", crs.size()) == text.npos;
}

std::optional<OffsetDigits> offset_of_format(const fs::path& path, const TinFormat& format) {
  const std::string kind = file_kind(path);
  if (kind == ".stl") return OffsetDigits::decimal;
  const bool floats = format.selafin == SelafinPrecision::floats;
  if (kind == ".slf" && floats) return OffsetDigits::whole;
  return std::nullopt;
}

void write_tin(const WorldTin& tin, const fs::path& path, const TinFormat& format) {
  AtomicFiles beside;  // complete before the mesh is there, and named only behind it
  const fs::path prj = fs::path(path).replace_extension(".prj");
  if (!tin.crs.empty() && file_kind(path) != ".nc" && !is_prj_of(prj, tin.crs)) {
    beside.add(prj) << tin.crs << '\n';
    beside.prepare();
  }
  write_mesh(tin, path, format);
  beside.commit();
}

}  // namespace lepp

#include <algorithm>
#include <array>
#include <string_view>

#include "lepp/io/atomic_files.hpp"
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

void write_prj(const WorldTin& tin, const fs::path& path) {
  AtomicFiles files;
  files.add(fs::path(path).replace_extension(".prj")) << tin.crs << '\n';
  files.commit();
}

}  // namespace

bool is_tin_file(const fs::path& path) {
  return std::ranges::find(kinds, std::string_view(path.extension().string())) != kinds.end();
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
  const std::string kind = path.extension().string();
  const auto beside = [&](const char* extension) {
    return fs::path(path).replace_extension(extension);
  };
  std::vector<fs::path> files{path};
  if (kind == ".ele") files = {beside(".node"), path, beside(".poly")};
  if (has_crs && kind != ".nc") files.push_back(beside(".prj"));
  return files;
}

std::optional<OffsetDigits> offset_of_format(const fs::path& path, const TinFormat& format) {
  if (path.extension() == ".stl") return OffsetDigits::decimal;
  const bool floats = format.selafin == SelafinPrecision::floats;
  if (path.extension() == ".slf" && floats) return OffsetDigits::whole;
  return std::nullopt;
}

void write_tin(const WorldTin& tin, const fs::path& path, const TinFormat& format) {
  const std::string kind = path.extension().string();
  if (!tin.crs.empty() && kind != ".nc") write_prj(tin, path);
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

}  // namespace lepp

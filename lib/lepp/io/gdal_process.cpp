#include "lepp/io/gdal_process.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <span>
#include <utility>
#include <vector>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/helper_process.hpp"

namespace lepp {
namespace {

namespace fs = std::filesystem;

HelperTask task_of(const fs::path& path, const fs::path& folder, std::vector<std::string> arguments,
                   const GdalOptions& options) {
  const HelperProgram program{"lepp-gdal", "LEPP_GDAL", "GDAL", "libgdal-dev"};
  std::error_code error;
  if (!fs::is_regular_file(path, error))  // GDAL itself would take names that are no files
    throw InputError(path.string(),
                     fs::exists(path, error) ? "is not a file" : "there is no such file",
                     "correct the file's name");
  arguments.insert(arguments.begin() + 1, fs::absolute(path).string());
  const double seconds = std::clamp(options.seconds, 0.01, 1e6);
  arguments.push_back(std::to_string(static_cast<long>(std::ceil(seconds)) + 1));
  arguments.push_back(std::to_string(options.memory_bytes));
  return {program,
          find_helper(program, options.helper),
          folder,
          std::move(arguments),
          seconds,
          "give a smaller file or window (the limit is GdalOptions::seconds)",
          path.string(),
          options.keep_going,
          HelperTask::RunsIn::callers_folder};  // a VRT may name its parts from there
}

[[noreturn]] void throw_failure(const GdalFailure& failure, const fs::path& path) {
  // GDAL knows the file by the way to it, the user by the name given.
  std::string problem = failure.problem;
  const std::string full = fs::absolute(path).string(), name = path.string();
  for (std::size_t at = problem.find(full); at != problem.npos && full != name;
       at = problem.find(full, at + name.size()))
    problem.replace(at, full.size(), name);
  const std::string where = failure.where.empty() ? name : name + ", " + failure.where;
  if (failure.kind == ErrorKind::refused) throw RefusedError(where, problem, failure.remedy);
  throw InputError(where, problem, failure.remedy);
}

/// One record from the pipe. Its length is not believed: memory grows as bytes arrive.
template <class Record>
Record receive(Helper& helper, const RecordKind& kind, std::size_t most) {
  std::vector<std::byte> bytes(record_head);
  if (!helper.read_all(bytes)) helper.fail_without_result();
  const auto length = announced_length(kind, std::span<const std::byte, record_head>(bytes));
  if (!length || *length > most) helper.fail_without_result();
  constexpr std::size_t step = std::size_t{1} << 20;
  for (std::size_t left = static_cast<std::size_t>(*length) + record_tail; left != 0;) {
    const std::size_t n = std::min(left, step);
    bytes.resize(bytes.size() + n);
    if (!helper.read_all(std::span(bytes).last(n))) helper.fail_without_result();
    left -= n;
  }
  Record record;
  if (!decode(bytes, record)) helper.fail_without_result();
  return record;
}

struct ReceivedHeader {
  HeightGrid grid;
  bool doubles;  // heights will come as such
};

ReceivedHeader receive_header(Helper& helper, const fs::path& path) {
  auto raster = receive<GdalRaster>(helper, gdal_raster_kind, std::size_t{1} << 26);
  if (raster.failure) throw_failure(*raster.failure, path);
  HeightGrid grid;
  grid.source = path.string();
  set_size(grid, raster.columns, raster.rows);
  grid.georeferenced = raster.georeferenced;
  grid.degrees = raster.degrees;
  grid.origin = raster.origin;
  grid.step_x = raster.step_x;
  grid.step_y = raster.step_y;
  grid.crs = std::move(raster.crs);
  grid.files = std::move(raster.files);
  for (const std::string& warning : raster.warnings)
    grid.warnings.push_back(grid.source + ": " + warning);
  return {std::move(grid), raster.doubles};
}

template <class Height>
void receive_heights(Helper& helper, const fs::path& path, HeightGrid& grid) {
  check_memory(grid);
  grid.heights.reserve(grid.size());
  std::vector<Height> part;
  while (true) {
    std::uint32_t rows = 0;
    if (!helper.read_all(std::as_writable_bytes(std::span(&rows, 1)))) helper.fail_without_result();
    if (rows == 0) break;
    const std::size_t count = std::size_t{rows} * grid.columns, done = grid.heights.size();
    if (count > grid.size() - done) helper.fail_without_result();
    constexpr std::size_t step = std::size_t{1} << 16;  // so that caches hold a part
    for (std::size_t left = count; left != 0; left -= part.size()) {
      part.resize(std::min(left, step));
      if (!helper.read_all(std::as_writable_bytes(std::span(part)))) helper.fail_without_result();
      check_memory(grid, std::span<const Height>(part));
      grid.heights.append(std::span<const Height>(part));
    }
  }
  const auto end = receive<GdalRasterEnd>(helper, gdal_end_kind, std::size_t{1} << 20);
  if (end.failure) throw_failure(*end.failure, path);
  if (grid.heights.size() != grid.size()) helper.fail_without_result();
}

// Cut short, it would be another coordinate system, or none.
void write_wkt(const fs::path& path, const std::string& wkt) {
  std::ofstream file(path, std::ios::binary);
  file << wkt;
  file.close();
  if (file) return;
  throw OutputError(path.string(), "this temporary file cannot be written",
                    "free some space there, or set TMPDIR to a folder on another disk");
}

std::string text_of(std::optional<double> nodata) { return nodata ? to_text(*nodata) : "-"; }

std::string text_of(const std::optional<GridWindow>& window) {
  if (!window) return "all";
  std::string text = std::to_string(window->column);
  for (const std::uint32_t number : {window->row, window->columns, window->rows}) {
    text += ',';
    text += std::to_string(number);
  }
  return text;
}

}  // namespace

HeightGrid read_gdal_header(const fs::path& path, std::optional<double> nodata,
                            const GdalOptions& options) {
  const PrivateFolder folder;
  Helper helper(task_of(path, folder.path(), {"raster", "header", text_of(nodata)}, options));
  return receive_header(helper, path).grid;
}

HeightGrid read_gdal_heights(const fs::path& path, const std::optional<GridWindow>& window,
                             std::optional<double> nodata,
                             const std::function<void(HeightGrid&)>& prepare,
                             const GdalOptions& options) {
  const PrivateFolder folder;
  Helper helper(
      task_of(path, folder.path(), {"raster", text_of(window), text_of(nodata)}, options));
  auto [whole, doubles] = receive_header(helper, path);
  prepare(whole);
  HeightGrid grid = window ? grid_of_window(whole, *window) : std::move(whole);
  if (doubles) receive_heights<double>(helper, path, grid);
  else receive_heights<float>(helper, path, grid);
  return grid;
}

GdalLines read_gdal_lines(const fs::path& path, const std::string& grid_crs,
                          const GdalOptions& options) {
  const PrivateFolder folder;
  const fs::path grid_wkt = folder.path() / "grid.wkt";
  write_wkt(grid_wkt, grid_crs);
  Helper helper(task_of(path, folder.path(), {"lines", fs::absolute(grid_wkt).string()}, options));
  GdalLines lines = receive<GdalLines>(helper, gdal_lines_kind, options.memory_bytes);
  if (lines.failure) throw_failure(*lines.failure, path);
  return lines;
}

}  // namespace lepp

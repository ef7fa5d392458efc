// lepp-gdal raster FILE header|COLUMN,ROW,COLUMNS,ROWS|all NODATA|- CPU-SECONDS MEMORY-BYTES
// lepp-gdal lines FILE FILE-OF-GRID-WKT CPU-SECONDS MEMORY-BYTES
// Reads one file with GDAL and writes what gdal_record.hpp says to descriptor 3.

#include <gdal_priv.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <new>
#include <string>
#include <string_view>

#include "confinement.hpp"
#include "gdal_failure.hpp"
#include "pipe.hpp"
#include "read_lines.hpp"
#include "read_raster.hpp"

namespace {

using namespace lepp;
using namespace lepp::gdal_helper;

template <class Number>
bool parse(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

bool parse_window(std::string_view text, RasterTask& task) {
  if (text == "header") task.header_only = true;
  if (text == "header" || text == "all") return true;
  std::array<std::uint32_t, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t end = i + 1 < numbers.size() ? text.find(',') : text.size();
    if (end == text.npos || !parse(text.substr(0, end), numbers[i])) return false;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  task.window = GridWindow{numbers[0], numbers[1], numbers[2], numbers[3]};
  return true;
}

bool parse_nodata(std::string_view text, RasterTask& task) {
  return text == "-" || parse(text, task.nodata.emplace());
}

void start_gdal() {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  GDALAllRegister();
  GDALSetCacheMax64(GIntBig{64} << 20);
}

GdalLines read_guarded(const std::string& file, const std::string& wkt_file,
                       std::uint64_t memory_bytes) {
  std::ifstream wkt(wkt_file, std::ios::binary);
  const std::string grid_wkt{std::istreambuf_iterator<char>(wkt), {}};
  GdalLines failed;
  try {
    return read_lines(file, grid_wkt);
  } catch (const GdalFailure& failure) {
    failed.failure = failure;
  } catch (const std::bad_alloc&) {
    failed.failure = out_of_memory(memory_bytes);
  }
  return failed;
}

}  // namespace

int main(int count, char** words) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody is left to read the record
  const std::string_view what = count > 2 ? words[1] : "";
  std::uint64_t cpu_seconds = 0, memory_bytes = 0;
  RasterTask task;
  const bool raster = what == "raster" && count == 7 && parse_window(words[3], task) &&
                      parse_nodata(words[4], task);
  const bool lines = what == "lines" && count == 6;
  if (!raster && !lines) return 1;
  if (!parse(words[count - 2], cpu_seconds) || !parse(words[count - 1], memory_bytes)) return 1;
  task.file = words[2];
  task.memory_bytes = memory_bytes;
  confine(cpu_seconds, memory_bytes);
  start_gdal();
  if (raster) send_raster(task);
  else send(encode(read_guarded(task.file, words[3], memory_bytes)));
  ::_exit(0);  // GDAL need not tidy up
}

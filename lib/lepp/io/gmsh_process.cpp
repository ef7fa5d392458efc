#include "lepp/io/gmsh_process.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace lepp {

GmshRecord run_gmsh_helper(const PrivateFolder& folder, const GmshTask& task,
                           const GmshOptions& options) {
  const HelperProgram program{"lepp-gmsh", "LEPP_GMSH", "Gmsh", "libgmsh-dev"};
  const double seconds = std::clamp(options.seconds, 0.01, 1e6);
  Helper helper({program,
                 find_helper(program, options.helper),
                 folder.path(),
                 {task.file, task.own_points ? "own-points" : "ends",
                  std::to_string(static_cast<long>(std::ceil(seconds)) + 1),
                  std::to_string(options.memory_bytes)},
                 seconds,
                 "simplify its loops, sizes and fields (the limit is GmshOptions::seconds)",
                 task.display_name,
                 options.keep_going});
  std::vector<std::byte> bytes, buffer(65536);
  while (const std::size_t n = helper.read(buffer)) {
    bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(n));
    if (bytes.size() > options.memory_bytes) break;  // cannot be a record of this input
  }
  auto record = decode_gmsh_record(bytes);
  if (!record) helper.fail_without_result();
  helper.finish();
  return std::move(*record);
}

}  // namespace lepp

#include "outputs.hpp"

#include <cstdio>

#include "lepp/geometry/error.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/io/vtu.hpp"

namespace lepp::cli {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& target) {
  if (target.extension() != ".ele") return {target};
  fs::path node = target, poly = target;
  return {node.replace_extension(".node"), target, poly.replace_extension(".poly")};
}

void check_target(const fs::path& target, const fs::path& input, bool force) {
  std::error_code error;
  if (fs::equivalent(target, input, error)) {
    throw OutputError(target.string(), "is also the input", "choose another name with -o");
  }
  if (!force && fs::is_regular_file(target, error)) {
    throw OutputError(target.string(), "exists already", "choose another name, or add --force");
  }
}

void check_mesh_target(const OutputOptions& options, const fs::path& input) {
  const std::string kind = options.target.extension().string();
  if (kind != ".msh" && kind != ".vtu" && kind != ".ele") {
    throw InputError(options.target.string(), "'" + kind + "' is no mesh format",
                     "name the output .msh, .vtu or .ele");
  }
  for (const fs::path& file : files_of(options.target)) check_target(file, input, options.force);
}

void write_mesh(const Mesh& mesh, const OutputOptions& options) {
  const std::string kind = options.target.extension().string();
  if (kind == ".vtu") return write_vtu(mesh, options.target);
  if (kind == ".ele") return write_ele(mesh, options.target);
  write_msh(mesh, options.target, options.format == "msh22" ? MshFormat::msh22 : MshFormat::msh41);
}

void write_text(const std::string& target, const std::string& text) {
  if (target == "-") {
    std::fputs(text.c_str(), stdout);
    return;
  }
  AtomicFiles files;
  files.add(target) << text;
  files.commit();
}

void print_report(const RunReport& report, const std::string& json, bool quiet) {
  const bool json_on_stdout = json == "-";
  if (!quiet) {
    const std::string text = to_text(report);
    std::fputs(text.c_str(), json_on_stdout ? stderr : stdout);
  }
  if (!json.empty()) write_text(json, to_json(report));
}

}  // namespace lepp::cli

#include "lepp/io/gmsh_script.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <system_error>

#include "lepp/geometry/error.hpp"
#include "lepp/io/gmsh_statements.hpp"
#include "lepp/io/text_file.hpp"

namespace lepp {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_bytes = std::uint64_t{64} << 20;
constexpr std::size_t most_files = 1000;

/// A script or merged file on its way into the private folder.
struct Job {
  fs::path file;     // canonical
  fs::path target;   // relative to the private folder
  std::string name;  // for messages
  std::optional<std::size_t> parent;
};

/// LF line ends and a final newline: without one Gmsh drops the end of the file.
std::string normalised(const std::string& text) {
  std::string result;
  result.reserve(text.size() + 1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    result.push_back(text[i] == '\r' ? '\n' : text[i]);
  }
  result.push_back('\n');
  return result;
}

/// Formats of geometry that Gmsh tells by their extension and that hold no statements.
bool is_shape_file(const fs::path& file) {
  static constexpr std::array<std::string_view, 6> extensions = {".step", ".stp", ".brep",
                                                                 ".iges", ".igs", ".stl"};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

class Copier {
 public:
  Copier(const fs::path& script, fs::path private_folder)
      : private_folder_(std::move(private_folder)), display_folder_(script.parent_path()) {
    std::error_code error;
    const fs::path file = fs::canonical(script, error);
    root_ = file.parent_path();
    // read_text_file() says what is wrong with a file that is not there.
    jobs_.push_back({error ? script : file, private_script_name, script.string(), {}});
  }

  GmshScript run() {
    for (std::size_t i = 0; i < jobs_.size(); ++i) copy(i);  // jobs_ grows meanwhile
    return std::move(result_);
  }

 private:
  void copy(std::size_t index) {
    const Job job = jobs_[index];
    if (index > 0 && is_shape_file(job.file)) {
      fs::create_directories((private_folder_ / job.target).parent_path());
      fs::copy_file(job.file, private_folder_ / job.target, fs::copy_options::overwrite_existing);
      return;
    }
    TextFile file = read_text_file(job.file, most_bytes - std::min(most_bytes - 1, bytes_));
    bytes_ += file.text.size();
    std::string text = normalised(file.text);
    const GeoStatements statements = inspect_geo(text, job.name, result_);
    write(job, text);
    for (const IncludedFile& included : statements.included) add(index, included);
  }

  void write(const Job& job, const std::string& text) {
    const fs::path target = private_folder_ / job.target;
    fs::create_directories(target.parent_path());
    std::ofstream out(target, std::ios::binary);
    out << text;
    out.close();
    if (!out)
      throw OutputError(target.string(), "cannot write the private copy of the input",
                        "make room in the folder for temporary files (TMPDIR)");
  }

  /// Queues an included file, found from the folder of the file that names it, as Gmsh does.
  void add(std::size_t parent, const IncludedFile& included) {
    const std::string where = jobs_[parent].name + ", line " + std::to_string(included.line);
    const fs::path wanted = jobs_[parent].file.parent_path() / included.name;
    const fs::path target = (jobs_[parent].target.parent_path() / included.name).lexically_normal();
    std::error_code error;
    const fs::path file = fs::weakly_canonical(wanted, error);
    const fs::path relative = file.lexically_relative(root_);
    if (error || fs::path(included.name).is_absolute() || relative.empty() ||
        *relative.begin() == ".." || *target.begin() == "..") {
      throw InputError(where, "\"" + included.name + "\" lies outside the folder of the input",
                       "move it beside the input and include it by its name");
    }
    for (std::optional<std::size_t> up = parent; up; up = jobs_[*up].parent) {
      if (jobs_[*up].file != file) continue;
      throw InputError(where, "recursive include: \"" + included.name + "\" includes itself",
                       "remove one of the Include statements");
    }
    if (!fs::is_regular_file(file)) return;  // Gmsh says so, if it ever gets to that statement
    if (jobs_.size() > most_files)
      throw RefusedError(where, "more than " + std::to_string(most_files) + " included files",
                         "put the geometry into fewer files");
    jobs_.push_back({file, target, (display_folder_ / relative).string(), parent});
  }

  fs::path private_folder_, display_folder_, root_;
  std::vector<Job> jobs_;
  std::uint64_t bytes_ = 0;
  GmshScript result_;
};

}  // namespace

GmshScript copy_geo_script(const std::filesystem::path& script,
                           const std::filesystem::path& private_folder) {
  return Copier(script, private_folder).run();
}

}  // namespace lepp

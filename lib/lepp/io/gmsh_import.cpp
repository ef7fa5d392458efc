#include "lepp/io/gmsh_import.hpp"

#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/io/gmsh_mesh_file.hpp"
#include "lepp/io/gmsh_process.hpp"
#include "lepp/io/gmsh_pslg.hpp"
#include "lepp/io/gmsh_record.hpp"
#include "lepp/io/gmsh_script.hpp"
#include "lepp/io/gmsh_soup.hpp"

namespace lepp {
namespace {

namespace fs = std::filesystem;

void check_options(const GmshOptions& options) {
  if (!(options.chord_tolerance > 0 && options.chord_tolerance <= 1))
    throw InputError("chord tolerance", "must be above 0 and at most 1", "use for example 1e-3");
}

void check_file(const fs::path& file) {
  std::error_code error;
  if (fs::is_regular_file(file, error)) return;
  throw InputError(file.string(),
                   fs::exists(file, error) ? "is not a file" : "there is no such file",
                   "give the name of a .geo or .msh file");
}

bool has_script_name(const fs::path& file) {
  return file.extension() == ".geo" || file.extension() == ".geo_unrolled";
}

/// Gmsh knows the copy, the user the original: messages get the user's name.
std::string with_user_name(std::string text, const std::string& copy, const std::string& original) {
  for (std::size_t at = text.find(copy); at != text.npos; at = text.find(copy, at)) {
    text.replace(at, copy.size(), original);
    at += original.size();
  }
  return text;
}

/// "'plate.geo', line 3: syntax error (x)" says where in front; everything else is about the file.
[[noreturn]] void throw_failure(const GmshFailure& failure, const std::string& copy,
                                const std::string& source) {
  std::string where = failure.where.empty() ? source : source + ", " + failure.where;
  std::string problem = with_user_name(failure.problem, copy, source);
  const std::size_t line = problem.find("', line "), colon = problem.find(": ");
  if (problem.starts_with("'") && line != problem.npos && colon != problem.npos && line < colon) {
    where = problem.substr(1, line - 1) + problem.substr(line + 1, colon - line - 1);
    problem = problem.substr(colon + 2);
  }
  if (failure.kind == ErrorKind::refused) throw RefusedError(where, problem, failure.remedy);
  throw InputError(where, problem, failure.remedy);
}

GmshRecord run(const PrivateFolder& folder, const GmshTask& task, const GmshOptions& options) {
  GmshRecord record = run_gmsh_helper(folder, task, options);
  if (record.failure) throw_failure(*record.failure, task.file, task.display_name);
  return record;
}

void put_in_front(std::vector<std::string> first, std::vector<std::string>& sentences) {
  first.insert(first.end(), std::make_move_iterator(sentences.begin()),
               std::make_move_iterator(sentences.end()));
  sentences = std::move(first);
}

GmshInput read_mesh(const fs::path& file, const PrivateFolder& folder, const GmshOptions& options) {
  const ElementGroups groups = copy_mesh_file(file, folder.path());
  const GmshRecord record = run(folder, {private_mesh_name, false, file.string()}, options);
  if (!record.mesh)
    throw InputError(file.string(), "Gmsh returned no mesh", "write the mesh again");
  GmshInput input = soup_from_gmsh(record, groups, file.string());
  put_in_front(record.warnings, input.warnings);
  return input;
}

GmshInput read_script(const fs::path& file, const PrivateFolder& folder,
                      const GmshOptions& options) {
  GmshScript script = copy_geo_script(file, folder.path());
  const bool own_points = script.sets_sizes || options.gmsh_sizes;
  const GmshRecord record = run(folder, {private_script_name, own_points, file.string()}, options);
  GmshInput input = pslg_from_gmsh(record, script, file.string(), options);
  input.pieces_have_sizes = own_points;
  for (const auto& [position, size] : record.inner_sizes) {
    input.inner_sizes.emplace_back(position, size);
  }
  if (script.sets_field) {
    input.warnings.push_back(
        "the background field counts along curves only, and inside surfaces sizes grow from there; "
        "where it asks for smaller ones, give them with --size-file or --region-edge");
  }
  put_in_front(record.warnings, input.warnings);
  put_in_front(std::move(script.warnings), input.warnings);
  return input;
}

}  // namespace

GmshInput read_gmsh(const fs::path& file, const GmshOptions& options) {
  check_options(options);
  check_file(file);
  const PrivateFolder folder;
  if (looks_like_msh(file) || !has_script_name(file)) return read_mesh(file, folder, options);
  return read_script(file, folder, options);
}

Pslg read_geo(const fs::path& file, const GmshOptions& options) {
  return read_gmsh(file, options).pslg;
}

}  // namespace lepp

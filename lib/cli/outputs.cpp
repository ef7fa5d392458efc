#include "outputs.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "lepp/geometry/error.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/file_kind.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/io/vtu.hpp"

namespace lepp::cli {

namespace fs = std::filesystem;

void add_output_options(CLI::App& command, OutputOptions& output, std::string& json,
                        bool& allow_unfinished, bool& quiet) {
  command.add_flag("--allow-unfinished", allow_unfinished,
                   "write a valid mesh even if the goal was not reached (status 3)");
  command.add_option("--format", output.format, "of .msh output")
      ->check(CLI::IsMember({"msh41", "msh22"}))
      ->capture_default_str();
  command.add_option("--json", json, "write the report as JSON to a file, or - for stdout");
  command.add_flag("--force", output.force, "overwrite the output");
  command.add_flag("-q,--quiet", quiet, "no report on the terminal");
}

Files files_of(const fs::path& target) {
  return file_kind(target) == ".ele" ? ele_files(target) : Files{target};
}

namespace {

// The files that reading `input` may read: those of Triangle come in sets of one name.
Files files_read(const fs::path& input) {
  Files files{input};
  const std::string kind = file_kind(input);
  if (kind != ".ele" && kind != ".poly" && kind != ".node") return files;
  for (const char* other : {".ele", ".node", ".poly", ".edge"}) {
    fs::path file = input;
    files.push_back(file.replace_extension(other));
  }
  return files;
}

void refuse_inputs(const fs::path& target, const Files& inputs) {
  std::error_code error;  // a file that does not exist is no input
  for (const fs::path& input : inputs) {
    for (const fs::path& file : files_read(input)) {
      if (!fs::equivalent(target, file, error)) continue;
      throw OutputError(target.string(), "is also the input", "choose another name");
    }
  }
}

std::string message_of(int error) { return std::generic_category().message(error); }

// Found before any work rather than when the work is done.
void check_place(const fs::path& target) {
  std::error_code error;
  if (fs::is_symlink(target, error) || fs::is_other(target, error))
    return;  // seen when it is opened
  if (fs::exists(target, error) && ::access(target.c_str(), W_OK) != 0) {
    throw OutputError(target.string(), "cannot replace: " + message_of(errno),
                      "choose a place you may write to");
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw OutputError(target.string(), "there is no folder " + folder.string(),
                      "make the folder first, or correct the path");
  }
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return;
  throw OutputError(target.string(), "cannot make a file there: " + message_of(errno),
                    "choose a place you may write to");
}

void print(std::FILE* stream, const std::string& text) {
  const bool written = std::fputs(text.c_str(), stream) >= 0 && std::fflush(stream) == 0;
  if (!written && stream == stdout) {
    throw OutputError("standard output", "could not be written", "look where it is sent to");
  }
}

}  // namespace

void check_target(const fs::path& target, const Files& inputs, bool force) {
  refuse_inputs(target, inputs);
  std::error_code error;
  if (fs::is_directory(target, error))
    throw OutputError(target.string(), "is a folder", "give the name of a file");
  if (!force && fs::is_regular_file(target, error)) {
    throw OutputError(target.string(), "exists already", "choose another name, or add --force");
  }
  check_place(target);
}

void check_report_target(const std::string& json, const Files& inputs, const Files& outputs) {
  if (json.empty() || json == "-") return;
  refuse_inputs(json, inputs);
  std::error_code error;
  const auto place_of = [&](const fs::path& file) {
    return fs::weakly_canonical(fs::absolute(file), error);
  };
  const fs::path place = place_of(json);
  for (const fs::path& output : outputs) {
    if (place == place_of(output)) {
      throw OutputError(json, "is named for two outputs", "give --json another name");
    }
  }
  if (fs::is_directory(json, error))
    throw OutputError(json, "is a folder", "give the name of a file");
  check_place(json);
}

void check_mesh_target(const OutputOptions& options, const Files& inputs) {
  const std::string kind = file_kind(options.target);
  if (kind != ".msh" && kind != ".vtu" && kind != ".ele") {
    throw CLI::ValidationError(
        "--output", options.target.string() + " is of no mesh format; name it .msh, .vtu or .ele");
  }
  for (const fs::path& file : files_of(options.target)) check_target(file, inputs, options.force);
}

void write_mesh(const Mesh& mesh, const OutputOptions& options) {
  const std::string kind = file_kind(options.target);
  if (kind == ".vtu") return write_vtu(mesh, options.target);
  if (kind == ".ele") return write_ele(mesh, options.target);
  write_msh(mesh, options.target, options.format == "msh22" ? MshFormat::msh22 : MshFormat::msh41);
}

void write_text(const std::string& target, const std::string& text) {
  if (target == "-") {
    print(stdout, text);
    return;
  }
  AtomicFiles files;
  files.add(target) << text;
  files.commit();
}

void print_report(const std::string& text, const std::string& as_json, const std::string& json,
                  bool quiet) {
  if (!quiet) print(json == "-" ? stderr : stdout, text);
  if (!json.empty()) write_text(json, as_json);
}

void print_report(const RunReport& report, const std::string& json, bool quiet) {
  print_report(quiet ? std::string() : to_text(report),
               json.empty() ? std::string() : to_json(report), json, quiet);
}

}  // namespace lepp::cli

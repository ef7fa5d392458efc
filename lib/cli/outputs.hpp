#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "lepp/io/msh.hpp"
#include "lepp/io/report.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp::cli {

/// Where results go and what may be overwritten.
struct OutputOptions {
  std::filesystem::path target;
  std::string format = "msh41";  ///< of .msh files
  bool force = false;
};

/// What commands that write a checked mesh have in common: --allow-unfinished, --format, --json,
/// --force and --quiet.
void add_output_options(CLI::App& command, OutputOptions& output, std::string& json,
                        bool& allow_unfinished, bool& quiet);

using Files = std::vector<std::filesystem::path>;

/// The files that writing a mesh to `target` makes: X.ele stands for X.node, X.ele and X.poly.
Files files_of(const std::filesystem::path& target);

/// Asked before any work: \throw CLI::ValidationError for a kind of file that is no mesh format,
/// OutputError for a target that exists (without `force`), or is a folder, a file of the input or
/// where nothing can be written (always).
/// \param inputs  all files that are read; empty names stand for none
void check_mesh_target(const OutputOptions& options, const Files& inputs);
void check_target(const std::filesystem::path& target, const Files& inputs, bool force);
/// The report may replace an older one, but no file of the input and no other output.
void check_report_target(const std::string& json, const Files& inputs, const Files& outputs = {});

/// Writes .msh, .vtu or .ele, as the name says.
void write_mesh(const Mesh& mesh, const OutputOptions& options);

/// Writes a small text to a file, or to standard output if `target` is "-".
void write_text(const std::string& target, const std::string& text);

/// Prints the report: as JSON to `json` ("-" is standard output) if it is not empty, and as text
/// unless `quiet`, to standard output or, if JSON is there, to standard error.
void print_report(const RunReport& report, const std::string& json, bool quiet);
void print_report(const std::string& text, const std::string& as_json, const std::string& json,
                  bool quiet);

}  // namespace lepp::cli

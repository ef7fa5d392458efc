#pragma once

#include <filesystem>
#include <string>

#include "group_options.hpp"

namespace lepp::demo {

/// What `lepp-poisson` was asked for.
struct CommandLine {
  std::string mesh;    ///< .msh or .ele
  std::string method;  ///< fe or fv
  GroupOptions groups;
  std::string output;  ///< .vtu, or empty; for the adaptive loop a folder
  std::string json;    ///< file, "-" for the standard output, or empty
  bool allow_inadmissible = false, force = false;
  std::string folder = ".";  ///< where the two demonstrations write
  // The adaptive loop; `output` is then a folder.
  std::string adapt;  ///< the problem, adaptive_problem_names(), or empty
  std::string by = "bisect", estimator = "residual", solver = "multigrid",
              error_quadrature = "graded";
  double theta = 0.5;
  std::size_t max_unknowns = 20000;
};

/// Exit status of the program (the same as that of `lepp`).
enum ExitStatus : int {
  done = 0,
  usage = 1,
  bad_input = 2,
  goal_missed = 3,
  refused = 4,
  not_written = 5,
  our_bug = 6,
};

/// Reads a mesh, solves the problem of the options on it, prints a report, writes u.
/// \throw Error
ExitStatus run_solve(const CommandLine& line);

/// Prints the table of errors and orders; writes the diagram and the solutions.
/// \return goal_missed if an order is below what these methods must have
ExitStatus run_convergence_study(const CommandLine& line);

/// Prints what each scheme makes of the thin plate on two meshes; writes solutions and pictures.
/// \return goal_missed if the outcome is not the expected one
ExitStatus run_maximum_principle(const CommandLine& line);

/// Runs the adaptive loop and prints a line for each step; writes a diagram and a series of files.
/// \throw Error
ExitStatus run_adapt(const CommandLine& line);

/// Writes a report for machines to a file or, for "-", to the standard output.
/// \throw OutputError
void write_json(const std::string& where, const std::string& text);

/// Whether two names, of files that need not exist, stand for one place.
bool is_same_place(const std::filesystem::path& a, const std::filesystem::path& b);

/// Makes the folder if it is not there.
/// \throw OutputError
std::filesystem::path make_folder(const std::string& name);

}  // namespace lepp::demo

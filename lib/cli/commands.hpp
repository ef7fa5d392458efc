#pragma once

#include <CLI/CLI.hpp>

namespace lepp::cli {

/// Exit statuses of the program.
enum Status : int {
  done = 0,        ///< done and checked
  usage = 1,       ///< a wrong command line
  bad_input = 2,   ///< the input is wrong
  unfinished = 3,  ///< valid and checked, but the goal or a claim is not reached
  refused = 4,     ///< refused before meshing, a time or memory limit, cancelled
  output = 5,      ///< a file could not be written
  bug = 6,         ///< a check of our own result failed
};

/// Each adds a subcommand to `app`; when it is given, its status is put into `status`.
void add_mesh_command(CLI::App& app, int& status);
void add_refine_command(CLI::App& app, int& status);
void add_check_command(CLI::App& app, int& status);
void add_convert_command(CLI::App& app, int& status);
void add_info_command(CLI::App& app, int& status);
void add_picture_command(CLI::App& app, int& status);
void add_terrain_command(CLI::App& app, int& status);

}  // namespace lepp::cli

#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lepp/io/gmsh_import.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp::cli {

/// A file of any kind that the program reads, told by its name: .geo, .msh, .poly, .node, .ele.
struct Input {
  Pslg pslg;                              ///< of a mesh file: its outline, interfaces and lines
  std::optional<TriangleSoup> triangles;  ///< of mesh files only
  bool pieces_have_sizes = false;         ///< as GmshInput::pieces_have_sizes
  std::vector<std::pair<Point, double>> inner_sizes;  ///< as GmshInput::inner_sizes
  std::vector<std::string> warnings;
};

/// \throw InputError  for a kind of file that the program does not know, and as the readers do
Input read_input(const std::filesystem::path& path, const GmshOptions& options = {});

/// The mesh in a mesh file. \throw InputError  if the file holds geometry, not triangles
Triangulation read_mesh(const std::filesystem::path& path, std::vector<std::string>& warnings);

/// Adds the options that say how Gmsh files are read.
void add_gmsh_options(CLI::App& command, GmshOptions& options);

}  // namespace lepp::cli

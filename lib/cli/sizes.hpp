#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "inputs.hpp"
#include "lepp/refine/refine.hpp"

namespace lepp::cli {

/// What the command line says about sizes that differ from place to place.
struct SizeOptions {
  std::filesystem::path file;     ///< points with sizes; empty: none
  std::optional<double> grading;  ///< of the sizes of points; 0.5 if not given
  std::vector<std::string> region_edges, region_areas;  ///< "REGION=VALUE"
};

void add_size_options(CLI::App& command, SizeOptions& sizes, RefineOptions& refine);

/// The field of the size file and, where the input's boundary was cut as its sizes ask for, of the
/// boundary's pieces and its points inside surfaces; null if there is neither.
std::function<double(Point)> size_field(const SizeOptions& sizes, const Input& input);

/// \throw CLI::ValidationError  for a region named twice in one option
void refuse_repeated_regions(const SizeOptions& sizes);

/// Writes sizes by region into the surfaces they name, by tag or by the name of a physical group.
/// \throw InputError  for a region that does not exist
void set_region_sizes(const SizeOptions& sizes, Entities& entities);

}  // namespace lepp::cli

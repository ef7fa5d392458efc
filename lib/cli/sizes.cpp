#include "sizes.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>

#include "lepp/geometry/error.hpp"
#include "lepp/io/size_file.hpp"
#include "validators.hpp"

namespace lepp::cli {

namespace {

bool is_called(const Entities& entities, const SurfaceEntity& surface, const std::string& name) {
  if (std::to_string(surface.tag) == name) return true;
  return std::ranges::any_of(surface.groups, [&](GroupId g) { return entities[g].name == name; });
}

void set_bound(const std::string& option, const std::string& text, double SurfaceEntity::*bound,
               Entities& entities) {
  const std::size_t sign = text.rfind('=');
  double value = 0;  // a number: the option was checked
  std::from_chars(text.data() + sign + 1, text.data() + text.size(), value);
  const std::string name = text.substr(0, sign);
  bool found = false;
  for (SurfaceEntity& surface : entities.surfaces) {
    if (!is_called(entities, surface, name)) continue;
    surface.*bound = std::min(surface.*bound, value);
    found = true;
  }
  if (!found) {
    throw InputError(option + " " + text, "names no region",
                     "give the number of a surface or the name of a physical group; lepp info "
                     "lists them");
  }
}

void refuse_repeated(const std::string& option, const std::vector<std::string>& texts) {
  std::set<std::string> names;
  for (const std::string& text : texts) {
    const std::string name = text.substr(0, text.rfind('='));
    if (names.insert(name).second) continue;
    throw CLI::ValidationError(option, "region " + name + " is given twice");
  }
}

}  // namespace

void add_size_options(CLI::App& command, SizeOptions& sizes, RefineOptions& refine) {
  command.add_option("--max-edge", refine.max_edge, "longest edge wanted")
      ->check(number_above_zero());
  command.add_option("--max-area", refine.max_area, "largest triangle wanted")
      ->check(number_above_zero());
  command
      .add_option("--region-edge", sizes.region_edges,
                  "REGION=LENGTH: longest edge in a region (surface number or group name)")
      ->check(named_size());
  command.add_option("--region-area", sizes.region_areas, "REGION=AREA: largest triangle in it")
      ->check(named_size());
  command.add_option("--size-file", sizes.file,
                     "points with sizes, lines 'x y h': edges near (x, y) at most h long");
  command
      .add_option("--grading", sizes.grading,
                  "how fast sizes of points grow with the distance from them (default 0.5)")
      ->check(number_from(0, std::numeric_limits<double>::infinity()));
}

std::function<double(Point)> size_field(const SizeOptions& sizes, const Input& input) {
  std::vector<SizeSource> sources;
  if (input.pieces_have_sizes) sources = sizes_of_segments(input.pslg);
  for (const auto& [at, size] : input.inner_sizes) sources.push_back({at, size, true});
  if (!sizes.file.empty()) {
    const auto more = read_size_file(sizes.file);
    sources.insert(sources.end(), more.begin(), more.end());
  }
  if (sources.empty()) return {};
  return SizeField(std::move(sources), sizes.grading.value_or(0.5));
}

void refuse_repeated_regions(const SizeOptions& sizes) {
  refuse_repeated("--region-edge", sizes.region_edges);
  refuse_repeated("--region-area", sizes.region_areas);
}

void set_region_sizes(const SizeOptions& sizes, Entities& entities) {
  for (const std::string& text : sizes.region_edges) {
    set_bound("--region-edge", text, &SurfaceEntity::max_edge, entities);
  }
  for (const std::string& text : sizes.region_areas) {
    set_bound("--region-area", text, &SurfaceEntity::max_area, entities);
  }
}

}  // namespace lepp::cli

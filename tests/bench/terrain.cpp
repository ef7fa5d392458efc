// lepp_terrain_bench DEM [--cell DX DY] [ERROR...]
// Vertices and processor time of each way to simplify a height grid, per largest error (without
// any: 10, 5, 2 and 1 % of the range of heights), as a Markdown table.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "lepp/geometry/error.hpp"
#include "lepp/io/height_grid_read.hpp"
#include "lepp/terrain/simplify.hpp"

namespace {

using namespace lepp;

struct Way {
  const char* name;
  SimplifyBy by;
  double min_angle_deg;
  Effort effort;
};
constexpr Way ways[] = {
    {"greedy", SimplifyBy::greedy, 0, Effort::fast},
    {"30, fast", SimplifyBy::lepp, 30, Effort::fast},
    {"30", SimplifyBy::lepp, 30, Effort::normal},
    {"30, best", SimplifyBy::lepp, 30, Effort::best},
    {"20.7", SimplifyBy::lepp, 20.7, Effort::normal},
};

double range(const HeightGrid& grid) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double h = grid.heights[i];
    if (std::isnan(h)) continue;
    low = std::min(low, h);
    high = std::max(high, h);
  }
  return high - low;
}

void print_cell(const HeightGrid& grid, const TerrainDomain& domain, double error, const Way& way) {
  SimplifyOptions options;
  options.max_error = error;
  options.by = way.by;
  options.min_angle_deg = way.min_angle_deg;
  options.effort = way.effort;
  SimplifyReport report;
  const std::clock_t start = std::clock();
  const Tin tin = simplify(grid, domain, options, report);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf(" %zu%s (%.2f s) |", tin.mesh.vertex_count(),
              report.goal_reached ? "" : " goal missed", seconds);
  std::fflush(stdout);
}

void print_table(const HeightGrid& grid, const std::vector<double>& errors) {
  const TerrainDomain domain = terrain_domain(grid);
  std::printf("| %s, E |", grid.source.c_str());
  for (const Way& way : ways) std::printf(" %s |", way.name);
  std::printf("\n|---|");
  for (std::size_t i = 0; i < std::size(ways); ++i) std::printf("---|");
  for (const double error : errors) {
    std::printf("\n| %g |", error);
    for (const Way& way : ways) print_cell(grid, domain, error, way);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: lepp_terrain_bench DEM [--cell DX DY] [ERROR...]\n", stderr);
    return 1;
  }
  HeightGridOptions options;
  std::vector<double> errors;
  for (int i = 2; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--cell" && i + 2 < argc) {
      options.cell = CellSize{std::atof(argv[i + 1]), std::atof(argv[i + 2])};
      i += 2;
    } else {
      errors.push_back(std::atof(argv[i]));
    }
  }
  try {
    const HeightGrid grid = read_height_grid(argv[1], options);
    if (errors.empty()) {
      for (const double percent : {10, 5, 2, 1}) errors.push_back(percent / 100 * range(grid));
    }
    print_table(grid, errors);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}

// lepp_economy [FILE.poly...] [--plot FILE.svg]
// How many vertices refinement needs, and how long each Steiner point takes: a table by effort at
// 30 degrees and one by angle bound, for the files or for four families of 10000 points.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "bench/families.hpp"
#include "lepp/io/plot.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace {

using namespace lepp;

constexpr std::size_t points = 10000;
constexpr std::uint64_t seed = 7;
constexpr double bounds_deg[] = {20, 25, 30, 33, 36, 38};

struct Input {
  std::string name;
  Mesh mesh;
};

std::vector<Input> families() {
  std::vector<Input> inputs;
  for (const test::Family& family : test::families().first(4)) {
    inputs.push_back({family.name, constrained_delaunay(family.make(points, seed)).mesh});
  }
  return inputs;
}

struct Run {
  std::size_t vertices;
  double microseconds;  // of processor time per Steiner point, the shortest of three runs
  bool goal_reached;
};

Run refined(const Mesh& mesh, const RefineOptions& options) {
  Run run{0, 1e9, false};
  for (int i = 0; i < 3; ++i) {
    Mesh copy = mesh;
    const std::clock_t start = std::clock();
    const RefineReport report = refine(copy, options);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const double steiner = std::max(1.0, static_cast<double>(report.steiner_points));
    run = {copy.vertex_count(), std::min(run.microseconds, 1e6 * seconds / steiner),
           report.goal_reached};
  }
  return run;
}

void print(const Run& run) {
  std::printf(" %8zu %s(%5.2f us) |", run.vertices, run.goal_reached ? "" : "goal missed ",
              run.microseconds);
}

void compare_efforts(const std::vector<Input>& inputs) {
  std::printf("| input | vertices | fast | normal | best | normal, no obtuse angle |\n");
  for (const Input& input : inputs) {
    std::printf("| %s | %zu |", input.name.c_str(), input.mesh.vertex_count());
    for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
      print(refined(input.mesh, {.effort = effort}));
    }
    print(refined(input.mesh, {.max_angle_deg = 90}));
    std::printf("\n");
    std::fflush(stdout);
  }
}

PlotSeries compare_bounds(const Input& input) {
  PlotSeries series{input.name, {}, {}};
  std::printf("| %s |", input.name.c_str());
  for (const double bound : bounds_deg) {
    const Run run = refined(input.mesh, {.min_angle_deg = bound});
    print(run);
    if (!run.goal_reached) continue;
    series.x.push_back(bound);
    series.y.push_back(static_cast<double>(run.vertices));
  }
  std::printf("\n");
  std::fflush(stdout);
  return series;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Input> inputs;
  std::string plot;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--plot" && i + 1 < argc) plot = argv[++i];
    else inputs.push_back({argv[i], constrained_delaunay(read_poly(argv[i])).mesh});
  }
  if (inputs.empty()) inputs = families();
  compare_efforts(inputs);
  LogLogPlot diagram{
      "Vertices against the smallest angle", "smallest angle, degrees", "vertices", {}, {}};
  std::printf("| smallest angle | 20 | 25 | 30 | 33 | 36 | 38 |\n");
  for (const Input& input : inputs) diagram.series.push_back(compare_bounds(input));
  if (!plot.empty()) write_plot(diagram, plot);
}

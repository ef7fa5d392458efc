// lepp_measure_error_bench: the error of a TIN over all samples of a grid of n x n, by size and by
// whether its heights are floats or doubles. Items are samples.

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/terrain_domain.hpp"

namespace {

using namespace lepp;

// Hills, and a grain that floats hold where `offset` is 0.
HeightGrid hills(std::uint32_t n, double offset) {
  std::vector<double> across(n);
  for (std::uint32_t i = 0; i < n; ++i)
    across[i] = 300 * std::sin(9.0 * i / n) + 40 * std::sin(61.0 * i / n);
  HeightGrid grid;
  grid.columns = grid.rows = n;
  grid.heights.reserve(grid.size());
  std::vector<double> line(n);
  for (std::uint32_t row = 0; row < n; ++row) {
    for (std::uint32_t c = 0; c < n; ++c) {
      const double grain = (c * 2654435761U ^ row * 40503U) % 8;
      line[c] = std::round(across[c] + across[n - 1 - row]) + grain + offset;
    }
    grid.heights.append(line);
  }
  return grid;
}

void measure(benchmark::State& state, double offset) {
  const HeightGrid grid = hills(static_cast<std::uint32_t>(state.range(0)), offset);
  SimplifyReport report;
  const Tin tin =
      simplify(grid, terrain_domain(grid), {.max_error = 10, .by = SimplifyBy::greedy}, report);
  for (auto _ : state) benchmark::DoNotOptimize(measure_error(grid, tin));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(grid.size()));
  state.counters["vertices"] = static_cast<double>(tin.mesh.vertex_count());
}

BENCHMARK_CAPTURE(measure, floats, 0)
    ->Arg(1000)
    ->Arg(4000)
    ->Arg(10'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(measure, doubles, 1e6 + 1.0 / 3)
    ->Arg(1000)
    ->Arg(4000)
    ->Arg(10'000)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

// lepp_bench              Google Benchmark: CDT of each family, points per second, peak memory
// lepp_bench --peers [N]  a row per family of N points (default 1000000), beside CGAL

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "bench/counted_memory.hpp"
#include "bench/families.hpp"
#ifdef LEPP_BENCH_CGAL
#include "bench/cgal_peer.hpp"
#endif
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace {

using namespace lepp;

constexpr std::uint64_t seed = 7;
constexpr int repetitions = 5;

// CGAL has one thread, so it is compared with one.
std::size_t triangles(const Pslg& pslg) {
  return constrained_delaunay(pslg, {.threads = 1}).mesh.triangle_count();
}

std::size_t triangles_by_two(const Pslg& pslg) {
  return constrained_delaunay(pslg, {.threads = 2}).mesh.triangle_count();
}

double megabytes(std::size_t bytes) { return static_cast<double>(bytes) / 1e6; }

void time_family(benchmark::State& state, const test::Family& family,
                 std::size_t (*kernel)(const Pslg&)) {
  const Pslg pslg = family.make(static_cast<std::size_t>(state.range(0)), seed);
  const std::size_t before = test::bytes_held();
  test::restart_peak();
  for (auto _ : state) benchmark::DoNotOptimize(kernel(pslg));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pslg.points.size()));
  state.counters["peak_MB"] = megabytes(test::peak_bytes() - before);
}

void register_all() {
  const auto add = [](const test::Family& family, const char* who, auto kernel) {
    const std::string name = std::string(family.name) + "/" + who;
    benchmark::RegisterBenchmark(name.c_str(), time_family, family, kernel)
        ->Unit(benchmark::kMillisecond)
        ->RangeMultiplier(10)
        ->Range(10'000, 1'000'000);
  };
  for (const test::Family& family : test::families()) {
    add(family, "lepp", &triangles);
    add(family, "lepp_two_threads", &triangles_by_two);
#ifdef LEPP_BENCH_CGAL
    add(family, "cgal", &test::cgal_constrained_delaunay);
    add(family, "cgal_points_only", &test::cgal_delaunay);
#endif
  }
}

struct Contender {
  const char* name;
  std::size_t (*kernel)(const Pslg&);
  std::vector<double> seconds = {};
  std::size_t peak = 0;
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void run(Contender& contender, const Pslg& pslg) {
  const std::size_t before = test::bytes_held();
  test::restart_peak();
  const auto start = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(contender.kernel(pslg));
  contender.seconds.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  contender.peak = std::max(contender.peak, test::peak_bytes() - before);
}

// Interleaved, so that what else the machine does hits all alike: each ratio is of two runs that
// followed each other, and the median of those ratios is printed.
void print_row(const test::Family& family, std::size_t points) {
  const Pslg pslg = family.make(points, seed);
  std::vector<Contender> contenders{{"lepp", &triangles}, {"two threads", &triangles_by_two}};
#ifdef LEPP_BENCH_CGAL
  contenders.push_back({"cgal", &test::cgal_constrained_delaunay});
  contenders.push_back({"cgal, points only", &test::cgal_delaunay});
#endif
  for (int i = 0; i < repetitions; ++i) {
    for (Contender& contender : contenders) run(contender, pslg);
  }
  const auto& own = contenders.front().seconds;
  std::printf("| %s | %zu | %.3f | %.3g | %.0f |", family.name, pslg.points.size(), median(own),
              static_cast<double>(pslg.points.size()) / median(own),
              megabytes(contenders.front().peak));
  for (std::size_t c = 1; c < contenders.size(); ++c) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < own.size(); ++i)
      ratios.push_back(own[i] / contenders[c].seconds[i]);
    std::printf(" %.3f | %.2f | %.0f |", median(contenders[c].seconds), median(ratios),
                megabytes(contenders[c].peak));
  }
  std::printf("\n");
  std::fflush(stdout);
}

int print_peers(std::size_t points) {
  std::printf("| family | points | lepp s | points/s | MB | two threads s | ratio | MB |");
#ifdef LEPP_BENCH_CGAL
  std::printf(" CGAL CDT s | ratio | MB | CGAL points only s | ratio | MB |");
#endif
  std::printf("\n|---|---|---|---|---|---|---|---|");
#ifdef LEPP_BENCH_CGAL
  std::printf("---|---|---|---|---|---|");
#endif
  std::printf("\n");
  for (const test::Family& family : test::families()) print_row(family, points);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "--peers") {
    const unsigned long long points = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1'000'000;
    if (points < 64 || points > 100'000'000) {
      std::fprintf(stderr, "lepp_bench: --peers wants a number of points from 64 to 100000000\n");
      return 1;
    }
    return print_peers(points);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  register_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

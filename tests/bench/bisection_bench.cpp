// lepp_bisection_bench    Google Benchmark: bisection of whole meshes, and of small parts of large
//                         ones
//
// uniform/MESH/THREADS    all triangles marked again and again, from a few to 4 million. `children`
//                         are the halves made in a second, `growth` the triangles more than before.
// local/MESH/THREADS      1000 triangles that lie together, marked in 4 million, for a thousand
//                         places: milliseconds of a call.
// `cpu` counts the time that the thread had a processor, of two the one that had more (the one that
// calls sleeps when it has to wait long), which does not grow where others use the machine.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <random>
#include <string>
#include <unordered_set>
#include <vector>

#include "bench/families.hpp"
#include "lepp/bisection/forest.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/shapes.hpp"

namespace {

using namespace lepp;

constexpr std::size_t many = 4'000'000, marked_at_once = 1000, places = 1000;
constexpr std::uint64_t seed = 7;

struct Start {
  const char* name;
  Mesh (*make)();
};

Mesh two_triangles() { return constrained_delaunay(test::unit_square()).mesh; }

Mesh random_points(std::size_t count) {
  return constrained_delaunay(test::families()[0].make(count, seed)).mesh;
}

constexpr Start starts[] = {
    {"two_triangles", two_triangles},
    {"random_2e4", [] { return random_points(20'000); }},
    {"random_5e5", [] { return random_points(500'000); }},
};

// The marks of uniform refinement, in the order of the ids.
std::vector<TriangleId> all_triangles(const Mesh& mesh) {
  std::vector<TriangleId> all;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) all.emplace_back(t);
  return all;
}

// From `first` on, across edges, breadth first.
std::vector<TriangleId> triangles_around(const Mesh& mesh, TriangleId first) {
  std::vector<TriangleId> found{first};
  std::unordered_set<TriangleId> known{first};
  for (std::size_t i = 0; found.size() < marked_at_once; ++i) {
    for (const std::uint32_t k : {0U, 1U, 2U}) {
      const auto across = mesh.twin({found[i], k});
      if (across && known.insert(across->triangle).second) found.push_back(across->triangle);
    }
  }
  found.resize(marked_at_once);
  return found;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double seconds_of(clockid_t clock) {
  std::timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// What the busier of two threads had of a processor.
class BusierThread {
 public:
  double seconds() const {
    const double calling = seconds_of(CLOCK_THREAD_CPUTIME_ID) - calling_;
    const double both = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - both_;
    return std::max(calling, both - calling);
  }

 private:
  double calling_ = seconds_of(CLOCK_THREAD_CPUTIME_ID);
  double both_ = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
};

void uniform(benchmark::State& state, const Start& start, unsigned threads) {
  const Mesh mesh = start.make();
  double halved = 0, seconds = 0, cpu = 0;
  for (auto _ : state) {
    Forest forest(mesh);
    double of_iteration = 0;
    while (forest.mesh().triangle_count() < many) {
      const auto marked = all_triangles(forest.mesh());
      const BusierThread busier;
      const auto begin = std::chrono::steady_clock::now();
      const Refinement done = forest.bisect(marked, {.threads = threads});
      of_iteration += seconds_since(begin);
      cpu += busier.seconds();
      halved += static_cast<double>(done.triangles.size());
    }
    state.SetIterationTime(of_iteration);
    seconds += of_iteration;
    state.counters["triangles"] = static_cast<double>(forest.mesh().triangle_count());
  }
  state.counters["children"] = 2 * halved / seconds;
  state.counters["growth"] = halved / seconds;
  state.counters["growth_cpu"] = halved / cpu;
}

void report(benchmark::State& state, const std::string& what, std::vector<double> seconds) {
  std::ranges::sort(seconds);
  state.counters[what + "_median_ms"] = 1e3 * seconds[seconds.size() / 2];
  state.counters[what + "_p99_ms"] = 1e3 * seconds[seconds.size() * 99 / 100];
  state.counters[what + "_worst_ms"] = 1e3 * seconds.back();
}

void local(benchmark::State& state, const Start& start, unsigned threads) {
  Forest forest(start.make());
  while (forest.mesh().triangle_count() < many) forest.bisect(all_triangles(forest.mesh()));
  std::mt19937_64 random(seed);
  std::vector<double> seconds, cpu;
  for (auto _ : state) {
    const TriangleId place(random() % forest.mesh().triangle_count());
    const auto marked = triangles_around(forest.mesh(), place);
    const BusierThread busier;
    const auto begin = std::chrono::steady_clock::now();
    const Refinement done = forest.bisect(marked, {.threads = threads});
    seconds.push_back(seconds_since(begin));
    cpu.push_back(busier.seconds());
    state.SetIterationTime(seconds.back());
    benchmark::DoNotOptimize(done.triangles.data());
  }
  state.counters["triangles"] = static_cast<double>(forest.mesh().triangle_count());
  report(state, "wall", std::move(seconds));
  report(state, "cpu", std::move(cpu));
}

void register_all() {
  for (const Start& start : starts) {
    for (const unsigned threads : {1U, 2U}) {
      const std::string name = std::string("/") + start.name + "/" + std::to_string(threads);
      benchmark::RegisterBenchmark(("uniform" + name).c_str(), uniform, start, threads)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond)
          ->Iterations(1);
      benchmark::RegisterBenchmark(("local" + name).c_str(), local, start, threads)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond)
          ->Iterations(places);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}

// lepp_transfer_bench [LONGEST_EDGE...]
// How long values take from one mesh of the unit square to another that was made for edges 2 %
// shorter: a row for each longest edge, the least of three runs.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "lepp/bisection/remesh_transfer.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace {

using namespace lepp;

constexpr int repetitions = 3;

Mesh square(double longest_edge, double offset) {
  const std::vector<double> points{0, 0, 1, 0, 1, 1, 0, 1, offset, 0.3, 0.7, offset};
  const std::vector<std::uint32_t> sides{0, 1, 1, 2, 2, 3, 3, 0};
  Mesh mesh = constrained_delaunay(pslg_from_arrays(points, sides)).mesh;
  refine(mesh, {.max_edge = longest_edge, .max_vertices = 20'000'000});
  return mesh;
}

template <class Work>
double least_seconds(Work work) {
  double least = 1e300;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count());
  }
  return least;
}

void print_row(double longest_edge) {
  const Mesh before = square(longest_edge, 0.41), after = square(0.98 * longest_edge, 0.37);
  VertexTransfer vertices;
  const double P1 = least_seconds([&] { vertices = vertex_transfer(before, after); });
  std::vector<double> values;
  const double projected = least_seconds([&] {
    values.assign(before.vertex_count(), 1.0);
    values.front() = 2;
    project_vertices(before, after, vertices, values);
  });
  TriangleTransfer transfer;
  const double P0 = least_seconds([&] { transfer = triangle_transfer(before, after); });
  std::vector<double> densities;
  const double once = least_seconds([&] {
    densities.assign(before.triangle_count(), 1.0);
    transfer_triangles(transfer, densities);
  });
  const auto triangles = static_cast<double>(after.triangle_count());
  std::printf("%9zu %9zu %9.3f %9.2f %9.3f %9.2f %9.2f %9.3f %9.3f\n", before.triangle_count(),
              after.triangle_count(), P1, 1e6 * P1 / static_cast<double>(after.vertex_count()), P0,
              1e6 * P0 / triangles, static_cast<double>(transfer.shares.size()) / triangles, once,
              projected);
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<double> edges = {0.0075, 0.0024, 0.0016};
  if (count > 1) edges.clear();
  for (int i = 1; i < count; ++i) edges.push_back(std::atof(arguments[i]));
  std::printf("%9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "before", "after", "P1 [s]", "us/vert.",
              "P0 [s]", "us/tri.", "pairs", "apply [s]", "L2 [s]");
  for (const double edge : edges) print_row(edge);
}

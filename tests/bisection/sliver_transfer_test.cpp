// Transfer of densities between meshes with triangles as high as the last bits of coordinates.

#include <doctest/doctest.h>

#include <cmath>

#include "bisection/random_forest.hpp"
#include "lepp/bisection/remesh_transfer.hpp"
#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/geometry/triangle_measures.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("slivers of an ulp: integrals are kept, and constants where areas are not all rounding") {
  // Vertex 3 lies an ulp off the diagonal.
  Pslg pslg = polygon({0, 0, 1, 0, 1, 1, 0, 1});
  pslg.points.push_back({0.5, std::nextafter(0.5, 0.0)});
  pslg.segments.push_back({VertexId(0U), VertexId(2U), {}, 0, 1});
  const Mesh start = constrained_delaunay(pslg).mesh;
  Forest forest(start);
  for (int i = 0; i < 4; ++i) forest.bisect(all_triangles(forest.mesh()));
  std::vector<double> ones(start.triangle_count(), 1.0);
  transfer_triangles(triangle_transfer(start, forest.mesh()), ones);
  CompensatedSum integral;
  std::size_t slivers = 0;
  for (const TriangleId t : all_triangles(forest.mesh())) {
    const auto [a, b, c] = forest.mesh().corners(t);
    const double area = signed_area(a, b, c);
    integral.add(area * ones[t.index()]);
    if (area < 1e-9) ++slivers;
    else CHECK(std::abs(ones[t.index()] - 1) < 1e-6);
    CHECK(std::abs(ones[t.index()] - 1) < 0.5);
  }
  CHECK(slivers > 0);
  CHECK(std::abs(integral.value() - 1) < 1e-12);
}

#include "lepp/bisection/remesh_transfer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bisection/remeshed.hpp"
#include "lepp/bisection/transfer_matrix.hpp"
#include "lepp/triangulation/locate.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("P1 to another mesh: linear functions stay, others within their bounds") {
  Random random(1);
  for (int i = 0; i < 10; ++i) {
    const Mesh before = random_mesh(divided_square(), 0.2, random);
    const Mesh after = random_mesh(divided_square(), random.real(0.1, 0.4), random);
    const VertexTransfer transfer = vertex_transfer(before, after);
    std::vector<double> values = at_vertices(before, linear);
    transfer_vertices(transfer, values);
    CHECK(largest_difference(values, at_vertices(after, linear)) < 1e-13);

    const std::vector<double> any = noise(before.vertex_count(), random);
    std::vector<double> moved = any;
    transfer_vertices(transfer, moved);
    const auto [low, high] = std::ranges::minmax(any);
    const auto [new_low, new_high] = std::ranges::minmax(moved);
    CHECK(new_low >= low - 1e-15);
    CHECK(new_high <= high + 1e-15);
    for (std::size_t v = 0; v < before.vertex_count(); ++v) {
      if (v < after.vertex_count() && before.points()[v] == after.points()[v]) {
        CHECK(moved[v] == any[v]);  // input vertices are in both
      }
    }
  }
}

TEST_CASE(
    "P1 where a circle has got shorter chords: new vertices take the nearest boundary place") {
  Random random(2);
  for (const double h : {0.5, 0.2, 0.05}) {
    CAPTURE(h);
    const Mesh before = random_mesh(disc_in_ring(), 0.5, random);
    const Mesh after = random_mesh(disc_in_ring(), h, random);
    const VertexTransfer transfer = vertex_transfer(before, after);
    if (h < 0.2) CHECK(transfer.outside > 20);
    std::vector<double> values = at_vertices(before, [](Point p) { return p.x; });
    std::vector<double> y = at_vertices(before, [](Point p) { return p.y; });
    transfer_vertices(transfer, values);
    transfer_vertices(transfer, y);
    for (std::size_t v = 0; v < values.size(); ++v) {  // where each new vertex has its value from
      const Point p = after.points()[v], from{values[v], y[v]};
      double nearest = std::numeric_limits<double>::infinity();
      if (locate(before, p)) nearest = 0;
      for (std::size_t t = 0; t < before.triangle_count() && nearest > 0; ++t) {
        for (std::uint32_t i = 0; i < 3; ++i) {
          const HalfEdge e{TriangleId(t), i};
          if (!before.is_boundary(e)) continue;
          const Point a = before.point(before.origin(e)),
                      d = before.point(before.destination(e)) - a;
          const double s = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
          nearest = std::min(nearest, std::sqrt(squared_distance(a + s * d, p)));
        }
      }
      CHECK(std::sqrt(squared_distance(p, from)) == doctest::Approx(nearest).epsilon(1e-12));
    }
  }
}

TEST_CASE("P1 by projection: the integral and linear functions stay, moments too") {
  Random random(13);
  for (int i = 0; i < 10; ++i) {
    const Mesh before = random_mesh(divided_square(), random.real(0.1, 0.4), random);
    const Mesh after = random_mesh(divided_square(), random.real(0.1, 0.4), random);
    const VertexTransfer transfer = vertex_transfer(before, after);
    std::vector<double> values = at_vertices(before, linear);
    project_vertices(before, after, transfer, values);
    CHECK(largest_difference(values, at_vertices(after, linear)) < 1e-12);

    const std::vector<double> any = noise(before.vertex_count(), random);
    std::vector<double> projected = any, interpolated = any;
    project_vertices(before, after, transfer, projected);
    transfer_vertices(transfer, interpolated);
    CHECK(std::abs(integral_of(before, any) - integral_of(after, projected)) < 1e-13);
    CHECK(std::abs(integral_of(before, any) - integral_of(after, interpolated)) > 1e-6);
    // What is projected is nearer than what is interpolated.
    CHECK(squared_integral_of(after, projected) < squared_integral_of(before, any));
  }
}

TEST_CASE("P1 by projection where circles have moved: constants stay") {
  Random random(14);
  const Mesh before = random_mesh(disc_in_ring(), 0.5, random);
  const Mesh after = random_mesh(disc_in_ring(), 0.1, random);
  std::vector<double> ones(before.vertex_count(), 1.0);
  project_vertices(before, after, vertex_transfer(before, after), ones);
  CHECK(largest_difference(ones, std::vector<double>(ones.size(), 1.0)) < 1e-14);
}

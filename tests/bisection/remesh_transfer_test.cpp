#include "lepp/bisection/remesh_transfer.hpp"

#include <doctest/doctest.h>

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "bisection/remeshed.hpp"
#include "lepp/bisection/transfer_matrix.hpp"
#include "lepp/geometry/predicates.hpp"

using namespace lepp;
using namespace lepp::test;
using Keep = TriangleTransferOptions::Keep;

TEST_CASE("orders: interpolation and projection of P1 data 2, projection of P0 data 1") {
  Random random(7);
  std::vector<double> P1, projected, P0;
  for (const double h : {0.2, 0.1, 0.05}) {
    const Mesh before = random_mesh(divided_square(), h, random);
    const Mesh after = random_mesh(divided_square(), 0.8 * h, random);
    std::vector<double> values = at_vertices(before, smooth);
    transfer_vertices(vertex_transfer(before, after), values);
    P1.push_back(largest_difference(values, at_vertices(after, smooth)));
    values = at_vertices(before, smooth);
    project_vertices(before, after, vertex_transfer(before, after), values);
    for (std::size_t v = 0; v < values.size(); ++v) values[v] -= smooth(after.points()[v]);
    projected.push_back(std::sqrt(squared_integral_of(after, values)));
    std::vector<double> densities = at_middles(before, smooth);
    transfer_triangles(triangle_transfer(before, after), densities);
    const std::vector<double> wanted = at_middles(after, smooth);
    double squared = 0;
    for (std::size_t t = 0; t < wanted.size(); ++t) {
      squared += area_of(after, TriangleId(t)) * std::pow(densities[t] - wanted[t], 2);
    }
    P0.push_back(std::sqrt(squared));
  }
  CHECK(std::log2(P1[0] / P1[2]) / 2 == doctest::Approx(2).epsilon(0.15));
  CHECK(std::log2(projected[0] / projected[2]) / 2 == doctest::Approx(2).epsilon(0.15));
  CHECK(std::log2(P0[0] / P0[2]) / 2 == doctest::Approx(1).epsilon(0.2));
  CHECK(P1[2] < 5e-3);
  CHECK(P0[2] < 3e-2);
}

TEST_CASE("the same mesh: nothing changes") {
  Random random(8);
  const Mesh mesh = random_mesh(disc_in_ring(), 0.2, random);
  const std::vector<double> values = noise(mesh.vertex_count(), random);
  std::vector<double> moved = values;
  transfer_vertices(vertex_transfer(mesh, mesh), moved);
  CHECK(moved == values);
  const std::vector<double> densities = noise(mesh.triangle_count(), random);
  moved = densities;
  const TriangleTransfer transfer = triangle_transfer(mesh, mesh);
  CHECK(transfer.shares.size() == mesh.triangle_count());
  transfer_triangles(transfer, moved);
  CHECK(largest_difference(moved, densities) < 1e-15);
}

TEST_CASE("matrices of a remesh do what its shares do") {
  Random random(9);
  const Mesh before = random_mesh(disc_in_ring(), 0.3, random);
  const Mesh after = random_mesh(disc_in_ring(), 0.2, random);
  const auto times = [](const Eigen::SparseMatrix<double>& P, const std::vector<double>& x) {
    REQUIRE(static_cast<std::size_t>(P.cols()) == x.size());
    const Eigen::VectorXd y =
        P * Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
    return std::vector<double>(y.begin(), y.end());
  };
  const VertexTransfer vertices = vertex_transfer(before, after);
  std::vector<double> values = noise(before.vertex_count(), random);
  const auto by_matrix = times(interpolation(vertices), values);
  transfer_vertices(vertices, values);
  CHECK(largest_difference(values, by_matrix) < 1e-15);
  const TriangleTransfer triangles = triangle_transfer(before, after);
  values = noise(before.triangle_count(), random);
  const auto projected = times(triangle_projection(triangles), values);
  transfer_triangles(triangles, values);
  CHECK(largest_difference(values, projected) < 1e-14);
}

TEST_CASE("far from the origin, and with sizes over six powers of ten, integrals stay") {
  Random random(11);
  const auto mesh_with = [](Point off, double h) {
    Pslg pslg = polygon({0, 0, 1, 0, 1, 1, 0, 1});
    for (Point& p : pslg.points) p = p + off;
    Mesh mesh = constrained_delaunay(pslg).mesh;
    const std::vector<SizeSource> sources{{off + Point{0.3, 0.4}, h}};
    REQUIRE(refine(mesh, {.size = SizeField(sources, 0.7)}).goal_reached);
    return mesh;
  };
  for (const Point off : {Point{0, 0}, Point{4096, -8192}}) {
    const Mesh fine = mesh_with(off, off.x == 0 ? 1e-6 : 1e-3), coarse = mesh_with(off, 0.1);
    for (const auto& [before, after] : {std::pair(&fine, &coarse), std::pair(&coarse, &fine)}) {
      const std::vector<double> any = noise(before->triangle_count(), random);
      std::vector<double> moved = any;
      transfer_triangles(triangle_transfer(*before, *after), moved);
      const auto was = integrals_by_region(*before, any), is = integrals_by_region(*after, moved);
      CHECK(std::abs(was[0] - is[0]) < 1e-12);
    }
  }
}

namespace {

bool is_in(Point a, Point b, Point c, Point p) {
  return orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0;
}

// A triangle abc, counter-clockwise, and a point of it; all areas are computed as 0 or less.
struct Sliver {
  Point a, b, c, inside;
};

bool is_lost_to_rounding(const Sliver& s) {
  const auto& [a, b, c, p] = s;
  return orient2d(a, b, c) > 0 && is_in(a, b, c, p) && p != a && p != b && p != c &&
         signed_area(a, b, c) <= 0 && signed_area(a, b, p) <= 0 && signed_area(b, c, p) <= 0 &&
         signed_area(c, a, p) <= 0;
}

Sliver random_sliver(Random& random) {
  const auto near = [&](Point p) {
    return Point{move_by_ulps(p.x, random.between(-3, 3)),
                 move_by_ulps(p.y, random.between(-3, 3))};
  };
  while (true) {  // one in some hundreds is
    Sliver s;
    s.a = {random.real(0.01, 0.1), random.real(0.01, 0.1)};
    s.b = {random.real(0.6, 0.9), random.real(0.1, 0.3)};
    s.c = near(s.a + random.real(0.4, 0.6) * (s.b - s.a));
    s.inside = near(s.a + random.real(0.2, 0.8) * (s.c - s.a));
    if (is_lost_to_rounding(s)) return s;
  }
}

// The triangle abc with the rest of a quadrilateral above it, and other points in that.
Mesh with_points(Point a, Point b, const std::vector<Point>& points) {
  Pslg pslg = polygon({a.x, a.y, b.x, b.y, 1, 1, 0, 1});
  pslg.points.insert(pslg.points.end(), points.begin(), points.end());
  return constrained_delaunay(pslg).mesh;
}

bool all_finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

}  // namespace

TEST_CASE("triangles whose area is lost to rounding: all values stay finite and within bounds") {
  Random random(31);
  for (int i = 0; i < 5; ++i) {
    CAPTURE(i);
    const Sliver s = random_sliver(random);
    const Mesh thin = with_points(s.a, s.b, {s.c, {0.4, 0.6}});
    const Mesh other = with_points(s.a, s.b, {s.inside, {0.5, 0.7}});
    for (const auto& [before, after] : {std::pair(&thin, &other), std::pair(&other, &thin)}) {
      const VertexTransfer transfer = vertex_transfer(*before, *after);
      std::vector<double> values = noise(before->vertex_count(), random), projected = values;
      transfer_vertices(transfer, values);
      CHECK(all_finite(values));
      CHECK(std::ranges::all_of(values, [](double v) { return std::abs(v) <= 1; }));
      project_vertices(*before, *after, transfer, projected);
      CHECK(all_finite(projected));
      std::vector<double> densities = noise(before->triangle_count(), random);
      transfer_triangles(triangle_transfer(*before, *after), densities);
      CHECK(all_finite(densities));
    }
  }
}

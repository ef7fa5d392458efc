#include "lepp/bisection/remesh_transfer.hpp"

#include <doctest/doctest.h>

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "lepp/bisection/common_parts.hpp"
#include "lepp/bisection/forest.hpp"
#include "lepp/bisection/transfer.hpp"
#include "lepp/bisection/transfer_matrix.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/refine/size_field.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

using namespace lepp;
using test::Random;
using Keep = TriangleTransferOptions::Keep;

namespace {

void add_surface(Pslg& pslg, Point inside) {
  pslg.entities.surfaces.push_back({});
  pslg.seeds.push_back({inside, SurfaceId(pslg.entities.surfaces.size() - 1)});
}

/// 1 +-----------+      a square with a hole, and a bent interface between regions 0 and 1
///   |  1  __----|
///   |__---  /\  |
///   | 0    /__\ |
/// 0 +-----------+
Pslg divided_square() {
  Pslg pslg = test::polygon({0, 0, 1, 0, 1, 1, 0, 1});
  test::add_chain(pslg, {{0, 0.3}, {0.5, 0.55}, {1, 0.7}}, false);
  test::add_chain(pslg, {{0.6, 0.15}, {0.9, 0.15}, {0.75, 0.35}}, true);
  pslg.holes = {{0.75, 0.2}};
  add_surface(pslg, {0.1, 0.1});
  add_surface(pslg, {0.5, 0.9});
  return pslg;
}

void add_circle(Pslg& pslg, double radius, std::size_t chords) {
  const auto first = static_cast<std::uint32_t>(pslg.points.size());
  const CurveId curve(pslg.entities.curves.size());
  pslg.entities.curves.push_back({});
  pslg.entities.curves.back().geometry =
      EllipseArc{{0, 0}, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi};
  for (std::size_t i = 0; i < chords; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(chords);
    const double angle = 2 * std::numbers::pi * t;
    pslg.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    const auto a = static_cast<std::uint32_t>(i);
    const auto b = static_cast<std::uint32_t>((i + 1) % chords);
    Segment segment{VertexId(first + a), VertexId(first + b), curve};
    segment.t_a = t;
    segment.t_b = t + 1.0 / static_cast<double>(chords);
    pslg.segments.push_back(segment);
  }
}

/// A disc in a ring: region 0 within radius 0.6, region 1 to radius 1; both circles are curves.
Pslg disc_in_ring(std::size_t chords = 8) {
  Pslg pslg;
  add_circle(pslg, 1, chords);
  add_circle(pslg, 0.6, chords);
  add_surface(pslg, {0, 0});
  add_surface(pslg, {0.8, 0});
  return pslg;
}

/// Refined to random sizes around `h`, so that no two meshes have much in common.
Mesh random_mesh(const Pslg& pslg, double h, Random& random) {
  std::vector<SizeSource> sources;
  for (int i = 0; i < 12; ++i) {
    sources.push_back({{random.real(-1, 1), random.real(-1, 1)}, random.real(0.3, 1) * h});
  }
  Mesh mesh = constrained_delaunay(pslg).mesh;
  REQUIRE(refine(mesh, {.max_edge = h, .size = SizeField(sources, 0.5)}).goal_reached);
  return mesh;
}

double area_of(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return signed_area(a, b, c);
}

std::vector<double> integrals_by_region(const Mesh& mesh, const std::vector<double>& densities) {
  std::vector<double> sums(2, 0.0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    sums[mesh.region(TriangleId(t)).index()] += densities[t] * area_of(mesh, TriangleId(t));
  }
  return sums;
}

/// Of the function that is linear on triangles.
double integral_of(const Mesh& mesh, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const VertexId v : mesh.vertices(TriangleId(t))) {
      sum += values[v.index()] * area_of(mesh, TriangleId(t)) / 3;
    }
  }
  return sum;
}

double squared_integral_of(const Mesh& mesh, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = mesh.vertices(TriangleId(t));
    const double u = values[a.index()], v = values[b.index()], w = values[c.index()];
    sum += area_of(mesh, TriangleId(t)) / 6 * (u * u + v * v + w * w + u * v + v * w + w * u);
  }
  return sum;
}

template <class Function>
std::vector<double> at_vertices(const Mesh& mesh, Function f) {
  std::vector<double> values;
  for (const Point p : mesh.points()) values.push_back(f(p));
  return values;
}

template <class Function>
std::vector<double> at_middles(const Mesh& mesh, Function f) {
  std::vector<double> values;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    values.push_back(f((1.0 / 3) * (a + b + c)));
  }
  return values;
}

std::vector<double> noise(std::size_t n, Random& random) {
  std::vector<double> values(n);
  for (double& value : values) value = random.real(-1, 1);
  return values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double linear(Point p) { return 0.75 + 2 * p.x - 3 * p.y; }
double smooth(Point p) { return std::sin(3 * p.x) * std::exp(p.y); }

std::vector<TriangleId> some_of(const Mesh& mesh, Random& random, std::uint32_t one_in) {
  std::vector<TriangleId> chosen;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (random.one_in(one_in)) chosen.emplace_back(i);
  }
  return chosen;
}

}  // namespace

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

TEST_CASE("P0 to another mesh: integrals stay in each region, constants and bounds too") {
  Random random(3);
  for (int i = 0; i < 10; ++i) {
    const Mesh before = random_mesh(divided_square(), random.real(0.1, 0.4), random);
    const Mesh after = random_mesh(divided_square(), random.real(0.1, 0.4), random);
    for (const bool by_region : {true, false}) {
      const auto transfer = triangle_transfer(before, after, {.by_region = by_region});
      const std::vector<double> any = noise(before.triangle_count(), random);
      std::vector<double> moved = any;
      transfer_triangles(transfer, moved);
      const auto was = integrals_by_region(before, any), is = integrals_by_region(after, moved);
      CHECK(std::abs(was[0] - is[0]) < 1e-13);
      CHECK(std::abs(was[1] - is[1]) < 1e-13);
      const auto [low, high] = std::ranges::minmax(any);
      const auto [new_low, new_high] = std::ranges::minmax(moved);
      CHECK(new_low >= low - 1e-13);
      CHECK(new_high <= high + 1e-13);

      std::vector<double> ones(before.triangle_count(), 1.0);
      transfer_triangles(transfer, ones);
      CHECK(largest_difference(ones, std::vector<double>(ones.size(), 1.0)) < 1e-13);
    }
  }
}

TEST_CASE("P0: what is in one region only does not leak into the other one") {
  Random random(4);
  for (const Pslg& pslg : {divided_square(), disc_in_ring()}) {
    const Mesh before = random_mesh(pslg, 0.3, random), after = random_mesh(pslg, 0.1, random);
    std::vector<double> values;
    for (std::size_t t = 0; t < before.triangle_count(); ++t) {
      values.push_back(before.region(TriangleId(t)) == SurfaceId(0U) ? 1 : 0);
    }
    transfer_triangles(triangle_transfer(before, after), values);
    for (std::size_t t = 0; t < after.triangle_count(); ++t) {
      if (after.region(TriangleId(t)) == SurfaceId(1U)) CHECK(values[t] == 0);
      else CHECK(values[t] > 0.5);
    }
  }
}

TEST_CASE("P0 where circles have moved: integrals stay in each region, or values do, as asked") {
  Random random(5);
  for (const double h : {0.6, 0.2, 0.04}) {
    for (const double h_before : {0.6, 0.1}) {
      CAPTURE(h);
      CAPTURE(h_before);
      const Mesh before = random_mesh(disc_in_ring(), h_before, random);
      const Mesh after = random_mesh(disc_in_ring(), h, random);
      const std::vector<double> any = noise(before.triangle_count(), random);
      std::vector<double> moved = any;
      transfer_triangles(triangle_transfer(before, after), moved);
      const auto was = integrals_by_region(before, any), is = integrals_by_region(after, moved);
      CHECK(std::abs(was[0] - is[0]) < 1e-13);
      CHECK(std::abs(was[1] - is[1]) < 1e-13);

      const auto by_values = triangle_transfer(before, after, {.keep = Keep::values});
      moved = any;
      transfer_triangles(by_values, moved);
      const auto [low, high] = std::ranges::minmax(any);
      const auto [new_low, new_high] = std::ranges::minmax(moved);
      CHECK(new_low >= low - 1e-14);
      CHECK(new_high <= high + 1e-14);
      std::vector<double> ones(before.triangle_count(), 1.0);
      transfer_triangles(by_values, ones);
      CHECK(largest_difference(ones, std::vector<double>(ones.size(), 1.0)) < 1e-14);
    }
  }
}

TEST_CASE("P0 from a bisected mesh and back is what the logs of bisect() and coarsen() say") {
  Random random(6);
  Forest forest(random_mesh(divided_square(), 0.3, random));
  const Mesh before = forest.mesh();
  const Refinement done = forest.bisect(some_of(before, random, 3));
  const std::vector<double> any = noise(before.triangle_count(), random);
  std::vector<double> by_log = any, by_mesh = any;
  transfer_triangles(done, by_log);
  transfer_triangles(triangle_transfer(before, forest.mesh()), by_mesh);
  CHECK(largest_difference(by_log, by_mesh) < 1e-13);
  transfer_triangles(triangle_transfer(forest.mesh(), before), by_mesh);  // means of equal halves
  CHECK(largest_difference(any, by_mesh) < 1e-13);
}

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

TEST_CASE("meshes of different regions are refused, unless all are taken for one") {
  Random random(10);
  Pslg one_region = divided_square();
  one_region.seeds = {{{0.1, 0.1}, SurfaceId(0U)}, {{0.5, 0.9}, SurfaceId(0U)}};
  const Mesh before = random_mesh(one_region, 0.3, random);
  const Mesh after = random_mesh(divided_square(), 0.3, random);
  CHECK_THROWS_AS(triangle_transfer(before, after), InputError);
  CHECK_THROWS_AS(triangle_transfer(after, before), InputError);
  std::vector<double> ones(before.triangle_count(), 1.0);
  transfer_triangles(triangle_transfer(before, after, {.by_region = false}), ones);
  CHECK(largest_difference(ones, std::vector<double>(ones.size(), 1.0)) < 1e-13);
}

TEST_CASE("far from the origin, and with sizes over six powers of ten, integrals stay") {
  Random random(11);
  const auto mesh_with = [](Point off, double h) {
    Pslg pslg = test::polygon({0, 0, 1, 0, 1, 1, 0, 1});
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

TEST_CASE("the pairs that overlap are as many as the meshes have triangles, up to a factor") {
  Random random(12);
  for (const double h : {0.2, 0.05}) {
    const Mesh before = random_mesh(divided_square(), h, random);
    const Mesh after = random_mesh(divided_square(), h, random);
    const std::size_t pairs = triangle_transfer(before, after).shares.size();
    CHECK(pairs < 4 * (before.triangle_count() + after.triangle_count()));
  }
}

TEST_CASE("the common part of two triangles: half of a square, a hexagon, a corner, nothing") {
  const std::array<Point, 3> t{{{0, 0}, {1, 0}, {0, 1}}};
  CHECK(CommonPart(t, t).area() == 0.5);
  CHECK(CommonPart(t, {{{1, 1}, {0, 1}, {1, 0}}}).area() == 0);
  CHECK(CommonPart(t, {{{0, 0}, {1, 1}, {0, 1}}}).area() == 0.25);
  CHECK(CommonPart(t, {{{5, 5}, {6, 5}, {5, 6}}}).area() == 0);
  const std::array<Point, 3> star{{{0.6, 0.6}, {-0.2, 0.6}, {0.6, -0.2}}};
  const CommonPart hexagon(t, star);
  CHECK(hexagon.size() == 6);
  CHECK(hexagon.area() == doctest::Approx(0.26));
  for (std::uint32_t edge = 0; edge < 3; ++edge) CHECK(hexagon.goes_on_across(edge));
  CHECK_FALSE(CommonPart(t, {{{-1, -1}, {9, -1}, {-1, 9}}}).goes_on_across(0));
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
    return Point{test::move_by_ulps(p.x, random.between(-3, 3)),
                 test::move_by_ulps(p.y, random.between(-3, 3))};
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
  Pslg pslg = test::polygon({a.x, a.y, b.x, b.y, 1, 1, 0, 1});
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

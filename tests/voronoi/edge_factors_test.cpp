#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/voronoi/voronoi_boxes.hpp"
#include "support/hand_made.hpp"

using namespace lepp;
using namespace lepp::test;
using doctest::Approx;

namespace {

std::vector<EdgeFactor> factors_of(const Mesh& mesh, std::uint32_t k, std::uint32_t l) {
  std::vector<EdgeFactor> found;
  std::ranges::copy_if(edge_factors(mesh), std::back_inserter(found), [&](const EdgeFactor& f) {
    return f.k == VertexId(k) && f.l == VertexId(l);
  });
  return found;
}

}  // namespace

TEST_CASE("an inner edge has half the sum of the two cotangents opposite it") {
  const Point a{-2, 0}, b{0, -1}, c{2, 0}, d{0, 5};
  const auto factors = factors_of(two_triangles(a, b, c, d), 0, 2);
  REQUIRE(factors.size() == 1);
  CHECK(factors[0].factor == Approx(0.5 * (cotangent(a, b, c) + cotangent(c, d, a))));
  CHECK(factors[0].factor == Approx(0.6 / 4));  // face over distance
  CHECK(factors[0].sign == 1);
  CHECK(factors[0].angle_deg ==
        Approx(2 * 180 / std::numbers::pi * (std::atan(2.0) + std::atan(0.4))));
}

TEST_CASE("a boundary edge has half the one cotangent opposite it") {
  const auto factors = factors_of(square(), 0, 1);
  REQUIRE(factors.size() == 1);
  CHECK(factors[0].factor == 0.5);
  CHECK(factors[0].angle_deg == Approx(45));
}

TEST_CASE("an interface edge has a factor in each region, of that region's side alone") {
  const auto factors = factors_of(two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 5}, 1), 0, 2);
  REQUIRE(factors.size() == 2);
  CHECK(factors[0].region == SurfaceId(0U));
  CHECK(factors[0].sign == -1);
  CHECK(factors[0].factor == Approx(0.5 * -0.75));  // cot(2 atan 2) = -3/4
  CHECK(factors[1].region == SurfaceId(1U));
  CHECK(factors[1].factor == Approx(0.5 * 21.0 / 20));
}

TEST_CASE("a constrained edge inside a region counts each side on its own") {
  Mesh mesh = two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 5});
  add_segments(mesh, {{0, 2, {}}});
  const auto factors = factors_of(mesh, 0, 2);
  REQUIRE(factors.size() == 2);
  CHECK(std::ranges::count(factors, -1, &EdgeFactor::sign) == 1);
  CHECK(std::ranges::count(factors, SurfaceId(0U), &EdgeFactor::region) == 2);
}

TEST_CASE("four cocircular vertices give exactly 0, and one ulp gives the sign") {
  const double right = 1, further = std::nextafter(1, 2), nearer = std::nextafter(1, 0);
  const auto sign_with = [](double x) {
    return factors_of(two_triangles({0, 0}, {x, 0}, {1, 1}, {0, 1}), 0, 2).at(0);
  };
  CHECK(sign_with(right).sign == 0);
  CHECK(sign_with(right).factor == 0);
  CHECK(sign_with(further).sign == 1);
  CHECK(sign_with(further).factor >= 0);
  CHECK(sign_with(nearer).sign == -1);
  CHECK(sign_with(nearer).factor <= 0);
}

TEST_CASE("a right angle opposite the boundary is exactly 0, on whole coordinates far away") {
  const Point far{500000, 4000000};
  const Mesh mesh = from_triangles({far, far + Point{3, 4}, far + Point{-4, 3}}, {{0, 1, 2}});
  CHECK(factors_of(mesh, 1, 2).at(0).sign == 0);
}

TEST_CASE("the factors of a vertex inside sum to what a linear function needs") {
  const Mesh mesh = grid({.columns = 6, .rows = 6, .jitter = 0.15});
  std::vector<Point> flux(mesh.vertex_count());
  for (const EdgeFactor& f : edge_factors(mesh)) {
    const Point through = f.factor * (mesh.point(f.k) - mesh.point(f.l));
    flux[f.k.index()] = flux[f.k.index()] + through;
    flux[f.l.index()] = flux[f.l.index()] - through;
  }
  for (std::uint32_t j = 1; j < 6; ++j) {
    for (std::uint32_t i = 1; i < 6; ++i) CHECK(dot(flux[j * 7 + i], flux[j * 7 + i]) < 1e-28);
  }
}

TEST_CASE("the negative factors are those of all factors, in their order") {
  Mesh mesh = grid({.columns = 12, .rows = 12, .jitter = 0.45, .regions = 3});
  add_segments(mesh, {{0, 1, {}}});
  const std::vector<EdgeFactor> all = edge_factors(mesh), found = negative_edge_factors(mesh);
  std::vector<EdgeFactor> negative;
  std::ranges::copy_if(all, std::back_inserter(negative),
                       [](const EdgeFactor& f) { return f.sign < 0; });
  REQUIRE(negative.size() > 10);
  REQUIRE(found.size() == negative.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i].k == negative[i].k);
    CHECK(found[i].l == negative[i].l);
    CHECK(found[i].region == negative[i].region);
    CHECK(found[i].factor == negative[i].factor);
    CHECK(found[i].sign == -1);
    CHECK(found[i].angle_deg == negative[i].angle_deg);
  }
}

#include "lepp/triangulation/split_constrained.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/validate.hpp"

using namespace lepp;

namespace {

// A polygon around the origin with a spoke to each corner: `n` wedges of a full circle. Spokes have
// different lengths.
Pslg wheel(std::uint32_t n) {
  Pslg pslg;
  pslg.points.push_back({0, 0});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, radius = 1 + 0.5 * (i % 7) / 7.0;
    pslg.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  for (std::uint32_t i = 1; i <= n; ++i) {
    pslg.segments.push_back({VertexId(0U), VertexId(i), std::nullopt, 0, 1});
    pslg.segments.push_back({VertexId(i), VertexId(i % n + 1), std::nullopt, 0, 1});
  }
  return pslg;
}

// Cuts the fan at the origin by way of spoke `i`, and returns how many spokes it cut.
std::size_t cut_spoke(Mesh& mesh, std::uint32_t i) {
  return split_constrained_edge(mesh, *mesh.find_edge(VertexId(0U), VertexId(i)), 0)
      .vertices.size();
}

}  // namespace

TEST_CASE("all spokes of a full circle are cut at one radius, whichever comes first") {
  for (const std::uint32_t first : {1U, 4U, 9U}) {
    CAPTURE(first);
    Mesh mesh = constrained_delaunay(wheel(9)).mesh;
    CHECK(cut_spoke(mesh, first) == 9);
    CHECK(validate(mesh, {.delaunay = false}).summary() == "valid");
    const double radius = std::sqrt(squared_distance({0, 0}, mesh.point(VertexId(10U))));
    for (std::size_t v = 10; v < mesh.vertex_count(); ++v) {
      CHECK(std::sqrt(squared_distance({0, 0}, mesh.point(VertexId(v)))) ==
            doctest::Approx(radius));
    }
  }
}

TEST_CASE("an open fan is cut on both sides of the spoke that comes first") {
  Pslg pslg = wheel(12);  // keep three quarters of the circle
  pslg.segments.erase(pslg.segments.begin() + 19, pslg.segments.end());
  for (const std::uint32_t first : {1U, 5U, 10U}) {
    CAPTURE(first);
    Mesh mesh = constrained_delaunay(pslg).mesh;
    CHECK(cut_spoke(mesh, first) == 10);
    CHECK(validate(mesh, {.delaunay = false}).summary() == "valid");
  }
}

TEST_CASE("cutting a fan of thousands of spokes takes time in proportion") {
  Mesh mesh = constrained_delaunay(wheel(4000)).mesh;
  CHECK(cut_spoke(mesh, 1) == 4000);
}

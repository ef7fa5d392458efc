#include "lepp/triangulation/quality.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/hand_made.hpp"

using namespace lepp;
using namespace lepp::test;
using doctest::Approx;

namespace {

bool is(const Quality::Count& count, std::size_t exact, std::size_t tolerant) {
  return count.exact == exact && count.tolerant == tolerant;
}

// A square of two regions, its diagonal an interface, with curves and groups:
// curve 0 is the bottom and the right side, curve 1 the bottom and the interface.
Mesh square_with_groups() {
  Mesh mesh = two_triangles({0, 0}, {1, 0}, {1, 1}, {0, 1}, 1);
  Entities entities = mesh.entities();
  for (const int dimension : {0, 1, 1, 2, 2}) entities.groups.push_back({dimension, 1, {}});
  const auto groups = [](std::initializer_list<std::uint32_t> ids) {
    std::vector<GroupId> result;
    for (const std::uint32_t id : ids) result.emplace_back(id);
    return result;
  };
  entities.points = {{1, VertexId(0U), groups({0})}, {2, VertexId(3U), groups({0})}};
  entities.curves = {{1, groups({1}), {}, {}}, {2, groups({1, 2}), {}, {}}};
  entities.surfaces[0].groups = groups({3});
  entities.surfaces[1].groups = groups({3, 4});
  mesh.set_entities(std::move(entities));
  add_segments(mesh, {{0, 1, 0}, {0, 1, 1}, {1, 2, 0}, {0, 2, 1}});
  return mesh;
}

}  // namespace

TEST_CASE("measure gives the angles of a square cut in two") {
  const Quality q = measure(square());
  CHECK(q.vertices == 4);
  CHECK(q.triangles == 2);
  CHECK(q.min_angle_deg == Approx(45).epsilon(1e-15));
  CHECK(q.mean_min_angle_deg == Approx(45).epsilon(1e-15));
  CHECK(q.mean_max_angle_deg == 90);
  CHECK(q.max_angle_deg == 90);
  CHECK(is(q.obtuse_triangles, 0, 0));
  CHECK(is(q.obtuse_constrained, 0, 0));
  CHECK(is(q.obtuse_boundary, 0, 0));
  CHECK(is(q.non_delaunay_edges, 0, 0));
  CHECK(is(q.non_delaunay_constrained, 0, 0));
}

TEST_CASE("means are over triangles") {
  // Equilateral beside a right isosceles triangle on its bottom side.
  const Mesh mesh = two_triangles({0, 0}, {0.5, -0.5}, {1, 0}, {0.5, std::sqrt(0.75)});
  CHECK(measure(mesh).mean_min_angle_deg == Approx((45.0 + 60.0) / 2).epsilon(1e-14));
  CHECK(measure(mesh).mean_max_angle_deg == Approx((90.0 + 60.0) / 2).epsilon(1e-14));
}

TEST_CASE("an angle above 90 degrees counts by what lies opposite it") {
  const Quality inner = measure(two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 5}));
  CHECK(is(inner.obtuse_triangles, 1, 1));
  CHECK(is(inner.obtuse_constrained, 0, 0));
  const Quality interface = measure(two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 5}, 1));
  CHECK(is(interface.obtuse_constrained, 1, 1));
  CHECK(is(interface.obtuse_boundary, 0, 0));
  const Quality both_sides = measure(two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 1}, 1));
  CHECK(is(both_sides.obtuse_constrained, 2, 2));
  CHECK(is(both_sides.non_delaunay_edges, 0, 0));
  CHECK(is(both_sides.non_delaunay_constrained, 1, 1));
  const Quality boundary = measure(from_triangles({{0, 0}, {4, 0}, {2, 1}}, {{0, 1, 2}}));
  CHECK(is(boundary.obtuse_constrained, 1, 1));
  CHECK(is(boundary.obtuse_boundary, 1, 1));
}

TEST_CASE("an edge that is not Delaunay counts once") {
  const Quality q = measure(two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 1}));
  CHECK(is(q.non_delaunay_edges, 1, 1));
  CHECK(is(q.obtuse_triangles, 2, 2));
}

TEST_CASE("an ulp counts exactly but is forgiven") {
  const double nearer = std::nextafter(1, 0);
  const Quality edge = measure(two_triangles({0, 0}, {nearer, 0}, {1, 1}, {0, 1}));
  CHECK(is(edge.non_delaunay_edges, 1, 0));
  const Quality angle = measure(from_triangles({{0, 0}, {1, 0}, {-1e-16, 1}}, {{0, 1, 2}}));
  CHECK(is(angle.obtuse_triangles, 1, 0));
  CHECK(is(angle.obtuse_boundary, 1, 0));
}

TEST_CASE("two millionths of a degree are not forgiven") {
  const Quality angle = measure(from_triangles({{0, 0}, {1, 0}, {-3e-8, 1}}, {{0, 1, 2}}));
  CHECK(is(angle.obtuse_boundary, 1, 1));
}

TEST_CASE("a curve is as long as its edges, also where it shares them") {
  const EntityMeasures measures = measure_entities(square_with_groups());
  REQUIRE(measures.curve_lengths.size() == 2);
  CHECK(measures.curve_lengths[0] == 2);
  CHECK(measures.curve_lengths[1] == 1 + std::sqrt(2.0));
  CHECK(measures.surface_areas == std::vector<double>{0.5, 0.5});
}

TEST_CASE("a group counts points, adds each edge once, and adds areas") {
  const std::vector<double> measures = measure_groups(square_with_groups());
  REQUIRE(measures.size() == 5);
  CHECK(measures[0] == 2);
  CHECK(measures[1] == 2 + std::sqrt(2.0));  // the bottom belongs to both curves
  CHECK(measures[2] == 1 + std::sqrt(2.0));
  CHECK(measures[3] == 1);
  CHECK(measures[4] == 0.5);
}

TEST_CASE("total_area loses nothing over many small triangles") {
  const Mesh mesh = grid({.columns = 200, .rows = 200, .spacing = 0.125});
  CHECK(total_area(mesh) == 625);
  const Mesh far = grid({.columns = 100, .rows = 100, .corner = {5e5, 4e6}, .spacing = 1e-3});
  CHECK(total_area(far) == Approx(0.01).epsilon(1e-6));  // the corners themselves are rounded
}

#include "lepp/triangulation/split.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

TEST_CASE("random insertions keep M1 to M6 and the area, and report what they changed") {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0, 2);
  Mesh mesh = constrained_delaunay(test::l_shape()).mesh;
  for (int i = 0; i < 300; ++i) {
    const Point p{uniform(random), uniform(random)};
    const auto place = locate(mesh, p);
    if (!place || place->on_edge) continue;
    const auto before = mesh.triangles();
    const std::vector<Triangle> old(before.begin(), before.end());
    const Insertion done = insert_in_triangle(mesh, place->triangle, p, {});
    REQUIRE(validate(mesh).summary() == "valid");
    for (std::size_t t = 0; t < old.size(); ++t) {
      const bool same = old[t].vertices == mesh.vertices(TriangleId(t));
      const bool listed = std::ranges::binary_search(done.changed, TriangleId(t));
      REQUIRE(same != listed);
    }
  }
  CHECK(total_area(mesh) == doctest::Approx(3).epsilon(1e-14));
}

TEST_CASE("splitting a constrained edge hands tags and parameters to both halves") {
  const double coordinates[] = {0, 0, 4, 0, 0, 3};
  const std::uint32_t segments[] = {0, 1, 1, 2, 2, 0};
  const int tags[] = {5, 6, 7};
  Mesh mesh = constrained_delaunay(pslg_from_arrays(coordinates, segments, tags)).mesh;
  const HalfEdge e = *mesh.find_edge(VertexId(0U), VertexId(1U));
  const ConstrainedSplit done = split_halfway(mesh, e, 0);
  REQUIRE(done.vertices.size() == 1);
  const VertexId m = done.vertices[0];
  CHECK(mesh.point(m) == Point{2, 0});
  CHECK(mesh.origin_of(m).kind == VertexOrigin::Kind::on_segment);
  CHECK(measure_entities(mesh).curve_lengths == std::vector<double>{4, 5, 3});
  for (const VertexId end : {VertexId(0U), VertexId(1U)}) {
    const auto record = mesh.find_record(m, end);
    REQUIRE(record.has_value());
    CHECK(record->t_high == 0.5);
    CHECK(record->t_low == (end == VertexId(0U) ? 0.0 : 1.0));
  }
  CHECK_FALSE(mesh.find_record(VertexId(0U), VertexId(1U)));
  CHECK(validate(mesh).summary() == "valid");
}

TEST_CASE("a split on an arc puts the vertex on the arc") {
  // A half disc of radius 1: the diameter and four chords.
  Pslg pslg;
  pslg.entities.curves = {{1, {}, EllipseArc{{0, 0}, {1, 0}, {0, 1}, 0, std::numbers::pi}, {}}};
  for (int i = 0; i <= 4; ++i) {
    pslg.points.push_back({std::cos(i * std::numbers::pi / 4), std::sin(i * std::numbers::pi / 4)});
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    pslg.segments.push_back({VertexId(i), VertexId(i + 1), CurveId(0U), 0.25 * i, 0.25 * (i + 1)});
  }
  pslg.segments.push_back({VertexId(4U), VertexId(0U), {}, 0, 1});
  Mesh mesh = constrained_delaunay(pslg).mesh;
  double error = 1;
  for (int round = 0; round < 3; ++round) {
    std::vector<std::pair<VertexId, VertexId>> edges;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        if (mesh.is_constrained(e) && mesh.curve_of(e)) {
          edges.emplace_back(mesh.origin(e), mesh.destination(e));
        }
      }
    }
    for (const auto& [a, b] : edges) {
      const ConstrainedSplit done = split_halfway(mesh, *mesh.find_edge(a, b), 1e-9);
      REQUIRE(done.vertices.size() == 1);
      const Point p = mesh.point(done.vertices[0]);
      CHECK(std::hypot(p.x, p.y) == doctest::Approx(1).epsilon(1e-15));
    }
    const double now = std::abs(total_area(mesh) - std::numbers::pi / 2);
    CHECK(now < 0.3 * error);  // falls as h^2
    error = now;
    CHECK(validate(mesh).summary() == "valid");
  }
}

TEST_CASE("an edge shorter than twice the floor is not cut") {
  Mesh mesh = constrained_delaunay(test::unit_square()).mesh;
  const HalfEdge e = *mesh.find_edge(VertexId(0U), VertexId(1U));
  CHECK(split_halfway(mesh, e, 0.6).vertices.empty());
  CHECK(mesh.vertex_count() == 4);
  CHECK(split_at_distance(mesh, e, VertexId(0U), 0.25, 0.1).vertices.size() == 1);
  CHECK(mesh.point(VertexId(4U)) == Point{0.25, 0});
}

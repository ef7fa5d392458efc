#include "lepp/triangulation/join_segments.hpp"

#include <doctest/doctest.h>

#include "lepp/geometry/predicates.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/unfinished.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

// What a file keeps of a mesh: points, triangles, and constrained edges with their curves.
Mesh as_from_file(const Mesh& mesh) {
  TriangleSoup soup;
  soup.points.assign(mesh.points().begin(), mesh.points().end());
  soup.entities = mesh.entities();
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    soup.triangles.push_back(mesh.vertices(t));
    soup.regions.push_back(mesh.region(t));
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{t, k};
      const auto across = mesh.twin(e);
      if (!mesh.is_constrained(e) || (across && *across < e)) continue;
      soup.segments.push_back({mesh.origin(e), mesh.destination(e), mesh.curve_of(e), 0, 1});
    }
  }
  return mesh_from_triangles(soup).mesh;
}

// Two spikes side by side that point upwards, of 20 and 25 degrees, and a slit at 50 degrees.
Pslg spikes() {
  Pslg pslg = test::polygon({0.1, 0.3, 35.2, 0.7, 20.3, 42.1, 17.7, 9.9, 10.1, 40.3});
  test::add_chain(pslg, {{6.1, 4.2}, {29.3, 5.1}}, false);
  pslg.points.push_back({14.3, 11.7});
  pslg.segments.push_back({VertexId(5U), VertexId(7U), {}, 0, 1});
  return pslg;
}

std::size_t excused(const Mesh& mesh) {
  const InputReasons reasons(mesh);
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (is_below(mesh, TriangleId(i), 30) && reasons.of(TriangleId(i))) ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("the segments that refinement cut are joined again, off the line by roundings or not") {
  Mesh mesh = constrained_delaunay(spikes()).mesh;
  refine(mesh);
  Mesh read = as_from_file(mesh);
  REQUIRE(read.segments().size() > 3 * mesh.segments().size());
  join_segments_in_line(read);
  CHECK(read.segments().size() == mesh.segments().size());
  CHECK(validate(read).summary() == "valid");
  CHECK(excused(read) == excused(mesh));
}

TEST_CASE("segments of other curves, corners and ends of slits stay ends of segments") {
  Pslg pslg = test::polygon({0, 0, 1, 0, 2, 0, 3, 0, 3, 2, 0, 2});
  pslg.entities.curves = {{7, {}, StraightCurve{}, {}}};
  pslg.segments[0].curve = CurveId(0U);
  test::add_chain(pslg, {{1, 1}, {1.5, 1}, {2, 1}}, false);
  Mesh mesh = as_from_file(constrained_delaunay(pslg).mesh);
  join_segments_in_line(mesh);
  CHECK(validate(mesh).summary() == "valid");
  CHECK(mesh.segments().size() == 6);  // five sides, the lowest of two curves; the slit is one
  std::size_t of_curve = 0;
  for (const Segment& s : mesh.segments()) {
    if (!s.curve) continue;
    ++of_curve;
    CHECK(mesh.point(std::min(s.a, s.b)) == Point{0, 0});
    CHECK(mesh.point(std::max(s.a, s.b)) == Point{1, 0});
  }
  CHECK(of_curve == 1);
}

TEST_CASE("a vertex clearly off the line is a corner") {
  Mesh mesh = constrained_delaunay(test::polygon({0, 0, 1, -1e-12, 2, 0, 1, 1})).mesh;
  join_segments_in_line(mesh);
  CHECK(mesh.segments().size() == 4);
}

TEST_CASE("an edge of several curves keeps them all") {
  Pslg pslg = test::polygon({0, 0, 1, 0, 2, 0, 1, 1});
  pslg.entities.curves = {{1, {}, StraightCurve{}, {}}, {2, {}, StraightCurve{}, {}}};
  for (const std::uint32_t i : {0U, 1U}) {
    pslg.segments[i].curve = CurveId(0U);
    pslg.segments.push_back({VertexId(i), VertexId(i + 1), CurveId(1U), 0, 1});
  }
  Mesh mesh = constrained_delaunay(pslg).mesh;
  join_segments_in_line(mesh);
  CHECK(validate(mesh).summary() == "valid");
  CHECK(mesh.segments().size() == 4);
  const HalfEdge e = *mesh.find_edge(VertexId(0U), VertexId(1U));
  CHECK(mesh.segments_of(e).size() == 2);
}

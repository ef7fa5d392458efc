#include <doctest/doctest.h>

#include "io/sample_meshes.hpp"
#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/triangulation/quality.hpp"

using namespace lepp;
using test::ScratchFolder;

namespace {

std::size_t constrained_count(const Mesh& mesh) {
  std::size_t twice = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{TriangleId(i), k};
      if (mesh.is_constrained(e)) twice += mesh.is_boundary(e) ? 2 : 1;
    }
  }
  return twice / 2;
}

}  // namespace

TEST_CASE("a PSLG reads back as it was written") {
  const ScratchFolder folder;
  Pslg pslg = test::two_squares();
  pslg.points[6] = {1.0 / 3 + 1, 0.1};  // numbers that need all their digits
  pslg.holes = {{0.7, 0.7}};
  for (const std::int64_t base : {0, 1}) {
    CAPTURE(base);
    pslg.base = base;
    write_poly(pslg, folder / "a.poly");
    const Pslg back = read_poly(folder / "a.poly");
    CHECK(back.points == pslg.points);
    CHECK(back.base == base);
    CHECK(back.holes == pslg.holes);
    REQUIRE(back.segments.size() == pslg.segments.size());
    for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
      CHECK(back.segments[i].a == pslg.segments[i].a);
      CHECK(back.segments[i].b == pslg.segments[i].b);
      CHECK(back.entities[*back.segments[i].curve].tag ==
            pslg.entities[*pslg.segments[i].curve].tag);
    }
    REQUIRE(back.seeds.size() == 2);
    CHECK(back.seeds[1].at == pslg.seeds[1].at);
    CHECK(back.entities[back.seeds[0].surface].max_area == 0.25);
    CHECK(back.entities[back.seeds[1].surface].attribute == 2.5);
  }
}

TEST_CASE("holes and regions are found where only the curves say what they bound") {
  const ScratchFolder folder;
  Pslg pslg = test::square_with_hole();
  pslg.holes.clear();
  pslg.entities.surfaces = {{4, {}, 4, 0.5}};
  pslg.entities.curves = {{1, {}, StraightCurve{}, {SurfaceId(0U)}}};
  for (Segment& s : pslg.segments) s.curve = CurveId(0U);
  write_poly(pslg, folder / "a.poly");
  const Pslg back = read_poly(folder / "a.poly");
  REQUIRE(back.holes.size() == 1);
  CHECK(back.holes[0].x > 1);
  CHECK(back.holes[0].x < 2);
  const Mesh mesh = constrained_delaunay(back).mesh;
  CHECK(total_area(mesh) == doctest::Approx(8).epsilon(1e-12));
  CHECK(mesh.entities()[mesh.region(TriangleId(0U))].tag == 4);
}

TEST_CASE("a mesh reads back from .node, .ele and .poly with regions and constrained edges") {
  const ScratchFolder folder;
  const Mesh mesh = test::two_squares_mesh();
  write_ele(mesh, folder / "a.ele");
  CHECK(folder.names() == std::set<std::string>{"a.ele", "a.node", "a.poly"});
  const TriangleSoup soup = read_ele(folder / "a.ele");
  const Mesh back = mesh_from_triangles(soup).mesh;
  REQUIRE(back.vertex_count() == mesh.vertex_count());
  REQUIRE(back.triangle_count() == mesh.triangle_count());
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    CHECK(back.point(VertexId(i)) == mesh.point(VertexId(i)));
  }
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    CHECK(back.vertices(t) == mesh.vertices(t));
    CHECK(back.entities()[back.region(t)].attribute == mesh.entities()[mesh.region(t)].attribute);
    for (std::uint32_t k = 0; k < 3; ++k) {
      CHECK(back.is_constrained({t, k}) == mesh.is_constrained({t, k}));
      if (!mesh.is_constrained({t, k})) continue;
      CHECK(back.entities()[*back.curve_of({t, k})].tag ==
            mesh.entities()[*mesh.curve_of({t, k})].tag);
    }
  }
}

TEST_CASE("every constrained edge has a marker that is not 0, and every hole a point") {
  const ScratchFolder folder;
  const Mesh mesh = constrained_delaunay(test::square_with_hole()).mesh;
  write_ele(mesh, folder / "a.ele");
  const Pslg outline = read_poly(folder / "a.poly");
  CHECK(outline.segments.size() == constrained_count(mesh));
  for (const Segment& s : outline.segments) {
    REQUIRE(s.curve.has_value());
    CHECK(outline.entities[*s.curve].tag == 1);
  }
  const Mesh again = constrained_delaunay(outline).mesh;
  CHECK(total_area(again) == doctest::Approx(8).epsilon(1e-12));
}

TEST_CASE("the three files appear together or not at all") {
  const ScratchFolder folder;
  folder.put("a.node", "old");
  std::filesystem::create_directory(folder / "a.poly");
  CHECK_FALSE(test::error_of<OutputError>([&] {
                write_ele(test::two_squares_mesh(), folder / "a.ele");
              }).empty());
  CHECK(folder.text("a.node") == "old");
  CHECK(folder.names() == std::set<std::string>{"a.node", "a.poly"});
}

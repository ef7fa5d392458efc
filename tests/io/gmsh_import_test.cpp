#include "lepp/io/gmsh_import.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/real_inputs.hpp"

using namespace lepp;
using lepp::test::contains;
using lepp::test::error_of;
using lepp::test::ScratchFolder;
using std::numbers::pi;

namespace {

const std::filesystem::path meshes = LEPP_MESHES;

GmshInput valid(const std::string& name) { return read_gmsh(meshes / "valid" / (name + ".geo")); }

/// What is measured on the triangulation of an input: areas by surface tag, lengths by group name.
struct Measures {
  double area = 0;
  std::map<int, double> areas;
  std::map<std::string, double> lengths;
};

Measures measure(const Mesh& mesh) {
  Measures m;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    m.areas[mesh.entities()[mesh.region(TriangleId(t))].tag] += 0.5 * cross(b - a, c - a);
  }
  for (const auto& [tag, area] : m.areas) m.area += area;
  for (const Segment& s : mesh.segments())
    for (const GroupId group : mesh.entities()[*s.curve].groups)
      m.lengths[mesh.entities()[group].name] +=
          std::sqrt(squared_distance(mesh.point(s.a), mesh.point(s.b)));
  return m;
}

Measures measure(const std::string& name) {
  const Triangulation result = constrained_delaunay(valid(name).pslg);
  CHECK(validate(result.mesh).summary() == "valid");
  return measure(result.mesh);
}

/// Equal to rounding: straight geometry.
doctest::Approx exactly(double value) { return doctest::Approx(value).epsilon(1e-12); }
/// Within what chords of a thousandth of the curve's size leave out.
doctest::Approx nearly(double value) { return doctest::Approx(value).epsilon(4e-3); }

std::string invalid(const std::string& name, GmshOptions options = {}) {
  return error_of<Error>([&] { read_gmsh(meshes / "invalid" / (name + ".geo"), options); });
}

CurveEntity curve_with_tag(const Pslg& pslg, int tag) {
  for (const CurveEntity& curve : pslg.entities.curves)
    if (curve.tag == tag) return curve;
  FAIL("no curve " << tag);
  return pslg.entities.curves.front();
}

}  // namespace

TEST_CASE("areas and lengths of straight geometry are exact") {
  CHECK(measure("l_shape").area == exactly(3));
  CHECK(measure("l_shape").lengths["boundary"] == exactly(8));
  CHECK(measure("l_shape").lengths["notch"] == exactly(2));
  CHECK(measure("boundary_slit").lengths["slit"] == exactly(std::sqrt(1 + 0.0625)));
  CHECK(measure("crack").area == exactly(16));
  CHECK(measure("crack").lengths["crack"] == exactly(std::sqrt(1.25) + 1.75));
  CHECK(measure("embedded").lengths["rod"] == exactly(std::sqrt(0.52)));
  CHECK(measure("example1_strip").area == exactly(30.867));
  CHECK(measure("example1_strip").lengths["boundary"] == exactly(63.734));
  CHECK(measure("interface_fan").area == exactly(36));
  CHECK(measure("interface_fan").lengths["spokes"] ==
        exactly(12 + std::sqrt(10) + 3 * std::sqrt(2)));
  CHECK(measure("nested_holes").areas == std::map<int, double>{{1, 20}, {2, 3}});
  CHECK(measure("thin_channel").area == exactly(2.04));
  CHECK(measure("tiny_angle").area == exactly(50 * std::tan(pi / 60)));
  CHECK(measure("graded_sizes").area == exactly(1));
  CHECK(measure("size_field").area == exactly(3));
}

TEST_CASE("areas and lengths of curved geometry are within the chord tolerance") {
  CHECK(measure("annulus").area == nearly(pi * 0.84));
  CHECK(measure("annulus").lengths["outer"] == nearly(2 * pi));
  CHECK(measure("annulus").lengths["inner"] == nearly(0.8 * pi));
  CHECK(measure("two_materials").area == nearly(8 - 0.16 * pi));
  CHECK(measure("two_materials").areas[2] == exactly(4));  // what bulges out also bulges in
  CHECK(measure("two_materials").lengths["interface"] == nearly(2 * pi / 3));
  CHECK(measure("two_circles").areas[2] == nearly(0.36 * pi));
  CHECK(measure("two_circles").areas[3] == nearly(0.64 * pi));
  CHECK(measure("overlap_opencascade").area == nearly(4 + 0.75 * pi));
  CHECK(measure("rotated_copies").area == nearly(pi));
  CHECK(measure("rotated_copies").areas.size() == 6);
  CHECK(measure("lens").lengths["chord"] == exactly(2));
  CHECK(measure("narrow_gap").area == nearly(24 - 2 * pi));
  CHECK(measure("airfoil").area == nearly(9 * pi - 0.08168));
  CHECK(measure("airfoil").lengths["far field"] == nearly(6 * pi));
  CHECK(measure("airfoil").lengths["wing"] == nearly(2.0395));
  CHECK(measure("blob").area == nearly(7.2761));
  CHECK(measure("blob").lengths["rim"] == nearly(10.2539));
  CHECK(measure("blob").lengths["eye"] == nearly(2.9065));
}

TEST_CASE("a smaller chord tolerance gives more points and a closer area") {
  GmshOptions fine;
  fine.chord_tolerance = 1e-5;
  const GmshInput input = read_gmsh(meshes / "valid" / "annulus.geo", fine);
  CHECK(input.pslg.points.size() > 4 * valid("annulus").pslg.points.size());
  CHECK(measure(constrained_delaunay(input.pslg).mesh).area ==
        doctest::Approx(pi * 0.84).epsilon(4e-5));
}

TEST_CASE("arcs come back exactly, splines as the polynomials they are") {
  const Pslg annulus = valid("annulus").pslg;
  const auto arc = std::get<EllipseArc>(curve_with_tag(annulus, 1).geometry);
  CHECK(std::abs(arc.center.x) < 1e-14);
  CHECK(std::abs(arc.center.y) < 1e-14);
  CHECK(std::abs(arc.sweep) == doctest::Approx(pi / 2).epsilon(1e-14));
  const auto half = std::get<EllipseArc>(curve_with_tag(annulus, 5).geometry);
  CHECK(std::abs(half.sweep) == doctest::Approx(pi).epsilon(1e-14));
  const auto eye = std::get<EllipseArc>(curve_with_tag(valid("blob").pslg, 2).geometry);
  CHECK(std::sqrt(dot(eye.u, eye.u)) == doctest::Approx(0.6).epsilon(1e-12));
  CHECK(std::get<CubicPieces>(curve_with_tag(valid("blob").pslg, 1).geometry).pieces.size() == 10);
  CHECK(std::get<CubicPieces>(curve_with_tag(valid("airfoil").pslg, 1).geometry).pieces.size() ==
        12);
}

TEST_CASE("segments carry parameters that lead to their ends") {
  for (const char* name : {"annulus", "airfoil", "blob", "overlap_opencascade", "transfinite"}) {
    CAPTURE(name);
    const Pslg pslg = valid(name).pslg;
    for (const Segment& s : pslg.segments) {
      const Curve& curve = pslg.entities[*s.curve].geometry;
      CHECK(s.t_a < s.t_b);
      if (is_straight(curve)) continue;
      const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
      CHECK(std::sqrt(squared_distance(point_at(curve, s.t_a), a)) < 1e-12);
      CHECK(std::sqrt(squared_distance(point_at(curve, s.t_b), b)) < 1e-12);
    }
  }
}

TEST_CASE("curves know the surfaces they bound, embedded ones bound none") {
  const Pslg pslg = valid("two_materials").pslg;
  CHECK(curve_with_tag(pslg, 7).bounds.size() == 2);
  CHECK(curve_with_tag(pslg, 11).bounds.size() == 1);
  CHECK(curve_with_tag(valid("embedded").pslg, 5).bounds.empty());
}

TEST_CASE("groups keep names, tags and members; an entity may be in several") {
  const Pslg pslg = valid("l_shape").pslg;
  REQUIRE(pslg.entities.groups.size() == 4);
  CHECK(pslg.entities.groups[0].name == "corner");
  CHECK(pslg.entities.groups[1].name == "boundary");
  CHECK(curve_with_tag(pslg, 3).groups.size() == 2);
  CHECK(curve_with_tag(pslg, 1).groups.size() == 1);
  REQUIRE(pslg.entities.points.size() == 1);
  CHECK(pslg.points[pslg.entities.points[0].vertex.index()] == Point{1, 1});
  CHECK(pslg.point_number(pslg.entities.points[0].vertex) == 4);
}

TEST_CASE("embedded points are kept") {
  const Pslg pslg = valid("embedded").pslg;
  REQUIRE(pslg.entities.points.size() == 1);
  CHECK(pslg.points[pslg.entities.points[0].vertex.index()] == Point{1.6, 0.35});
}

TEST_CASE("boundary points are Gmsh's where the file sets sizes, the ends alone elsewhere") {
  const Pslg transfinite = valid("transfinite").pslg;
  CHECK(transfinite.segments.size() == 8 + 5 + 11 + 5);
  CHECK(valid("graded_sizes").pslg.segments.size() > 30);
  CHECK(valid("size_field").pslg.segments.size() > 30);
  CHECK(valid("l_shape").pslg.segments.size() == 6);
  GmshOptions gmsh_sizes;
  gmsh_sizes.gmsh_sizes = true;
  CHECK(read_geo(meshes / "valid" / "l_shape.geo", gmsh_sizes).segments.size() > 6);
}

TEST_CASE("pieces of curves that share both ends, or nearly touch, are cut until they part") {
  CHECK(valid("lens").pslg.segments.size() > 3);
  // Circles of 30-degree chords would overlap the gap; where it is narrow they are finer.
  const Pslg gap = valid("narrow_gap").pslg;
  CHECK(validate(gap).empty());
  for (const CurveEntity& curve : gap.entities.curves)
    if (curve.tag > 10) CHECK(!is_straight(curve.geometry));
}

TEST_CASE("what is wrong with an invalid file is named") {
  CHECK(contains(invalid("open_loop"), "curve loop 3"));
  CHECK(contains(invalid("open_loop"), "points 1 (0, 0), 4 (0, 1)"));
  CHECK(contains(invalid("zero_area"), "surface 1: has zero area"));
  CHECK(contains(invalid("no_surface"), "no surface"));
  CHECK(contains(invalid("non_planar"), "z = 0.5"));
  CHECK(contains(invalid("unknown_syntax"), "line 3: syntax error"));
  CHECK(contains(invalid("missing_point"), "point 7"));
  CHECK(contains(invalid("includes_itself"), "line 2: recursive include"));
  CHECK(contains(invalid("includes_outside"), "outside the folder"));
  CHECK(contains(invalid("runs_command"), "line 3: the statement SystemCall"));
  CHECK(contains(invalid("ends_process"), "line 3: the statement Exit"));
  CHECK(contains(invalid("size_too_small"), "1e-09"));
  CHECK(contains(invalid("size_too_small"), "4e+09 boundary points"));
}

TEST_CASE("crossing and overlapping surfaces are found by the triangulation") {
  for (const char* name : {"crossing_loop", "overlapping_surfaces", "nested_without_hole"}) {
    CAPTURE(name);
    const Pslg pslg = read_geo(meshes / "invalid" / (std::string(name) + ".geo"));
    CHECK_THROWS_AS(constrained_delaunay(pslg), InputError);
  }
}

TEST_CASE("a file that never ends is stopped, and is refused rather than wrong") {
  GmshOptions options;
  options.seconds = 1;
  const std::string message =
      error_of<RefusedError>([&] { read_gmsh(meshes / "invalid" / "endless_loop.geo", options); });
  CHECK(contains(message, "in 1 seconds"));
}

TEST_CASE("a list that fills the memory is refused") {
  const ScratchFolder scratch;
  const auto file = scratch.put("list.geo", "x[] = {1:300000000};\nPoint(1) = {0, 0, 0};\n");
  GmshOptions options;
  options.memory_bytes = std::size_t{1} << 30;
  CHECK(contains(error_of<Error>([&] { read_gmsh(file, options); }), "memory"));
}

TEST_CASE("nothing is left behind, in the input's folder or among the temporary files") {
  const ScratchFolder scratch, temporary;
  const std::string old = std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : "";
  ::setenv("TMPDIR", (temporary / "").c_str(), 1);
  const std::string square =
      "Point(1)={0,0,0};Point(2)={1,0,0};Point(3)={0,1,0};Line(1)={1,2};Line(2)={2,3};"
      "Line(3)={3,1};Curve Loop(1)={1:3};Plane Surface(1)={1};";
  const auto good = scratch.put("good.geo", square + "Save \"x.msh\";Printf(\"a\") > \"y.txt\";");
  const auto bad = scratch.put("bad.geo", square + "Nonsense;");
  const GmshInput input = read_gmsh(good);
  CHECK(input.pslg.segments.size() == 3);
  CHECK(input.warnings.size() == 2);
  CHECK(contains(error_of<InputError>([&] { read_gmsh(bad); }), "bad.geo, line 1"));
  CHECK(scratch.names() == std::set<std::string>{"bad.geo", "good.geo"});
  CHECK(temporary.names().empty());
  old.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", old.c_str(), 1);
}

TEST_CASE("line ends, byte-order marks and a missing last newline make no difference") {
  const ScratchFolder scratch;
  const auto file = scratch.put("odd.geo",
                                "\xEF\xBB\xBFPoint(1)={0,0,0};\r\nPoint(2)={1,0,0};\r\n"
                                "Point(3)={0,1,0};Line(1)={1,2};Line(2)={2,3};Line(3)={3,1};\r\n"
                                "Curve Loop(1)={1:3};Plane Surface(1)={1};");
  CHECK(read_geo(file).segments.size() == 3);
}

TEST_CASE("included and merged files are found below the folder of the input") {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "parts");
  scratch.put("parts/points.geo", "Point(1)={0,0,0};\nPoint(2)={1,0,0};\nMerge \"third.geo\";\n");
  scratch.put("parts/third.geo", "Point(3)={0,1,0};\n");
  const auto file = scratch.put("main.geo",
                                "Include \"parts/points.geo\";\nLine(1)={1,2};Line(2)={2,3};"
                                "Line(3)={3,1};Curve Loop(1)={1:3};Plane Surface(1)={1};\n");
  CHECK(read_geo(file).segments.size() == 3);
}

TEST_CASE("a missing helper is an error that says how to get it") {
  GmshOptions options;
  options.helper = "/nowhere/lepp-gmsh";
  const std::string message =
      error_of<InputError>([&] { read_gmsh(meshes / "valid" / "l_shape.geo", options); });
  CHECK(contains(message, "/nowhere/lepp-gmsh"));
  CHECK(contains(message, "libgmsh-dev"));
}

TEST_CASE("real .geo files: each is triangulated, or refused with its own reason") {
  const std::map<std::string, double> areas = {{"mfem/compass", 2 * std::sqrt(2)},
                                               {"mfem/periodic-square", 1},
                                               {"petsc/gmsh-tri", 0.5},
                                               {"petsc/gmsh-qua", 1},
                                               {"petsc/gmsh-B2tri", 2},
                                               {"petsc/gmsh-B2qua", 2},
                                               {"dealii/unit-square", 1},
                                               {"dealii/square-quad", 1},
                                               {"gridapgmsh/periodic", 1},
                                               {"thetis/discrete_turbines/mesh", 204800},
                                               {"devsim/disk_2d", 6.25e-8}};
  for (const auto& row : areas) {
    const auto& name = row.first;
    const auto& area = row.second;
    CAPTURE(name);
    const auto file = test::real_input("gmsh/" + name + ".geo");
    if (file) CHECK(measure(constrained_delaunay(read_geo(*file)).mesh).area == exactly(area));
  }
  const std::map<std::string, std::string> reasons = {
      {"gridapgmsh/plane", "plane z = constant"},
      {"petsc/gmsh-seg", "no surface"},
      {"thetis/mesh_cylinder_coarse", "Unknown field type \"Attractor\""},
      {"thetis/mesh_rhineRofi_test", "Unknown field type \"Attractor\""}};
  for (const auto& row : reasons) {
    const auto& name = row.first;
    const auto& reason = row.second;
    CAPTURE(name);
    const auto file = test::real_input("gmsh/" + name + ".geo");
    if (file) CHECK(contains(error_of<InputError>([&] { read_geo(*file); }), reason));
  }
}

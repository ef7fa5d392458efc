#include "lepp/io/geo.hpp"

#include <doctest/doctest.h>

#include "io/sample_meshes.hpp"
#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using test::contains;
using test::ScratchFolder;

TEST_CASE("geometry has points, lines, surfaces, what is embedded, and groups") {
  const ScratchFolder folder;
  Pslg pslg = test::two_squares();
  pslg.points[6].y = 1.0 / 3;
  write_geo(pslg, folder / "a.geo");
  const std::string text = folder.text("a.geo");
  CHECK(contains(text, "Point(1) = {0, 0, 0};\n"));
  CHECK(contains(text, "Point(7) = {1.5, 0.3333333333333333, 0};\n"));
  CHECK(contains(text, "Line(8) = "));
  CHECK(contains(text, "Plane Surface(2) = {2};\n"));
  CHECK(contains(text, "} In Surface{1};\n"));  // the crack
  CHECK(contains(text, "Point{7} In Surface{2};\n"));
  CHECK(contains(text, "Physical Surface(\"left\", 1) = {1};\n"));
  CHECK(contains(text, "Physical Surface(\"plate\", 3) = {1, 2};\n"));
  CHECK(contains(text, "Physical Curve(4) = {"));
  CHECK(contains(text, "Physical Point(\"well\", 9) = {7};\n"));
  CHECK_FALSE(contains(text, "ungrouped"));
}

TEST_CASE("surfaces without group form one, if there are groups") {
  const ScratchFolder folder;
  Pslg pslg = test::two_squares();
  pslg.entities.surfaces[1].groups.clear();
  write_geo(pslg, folder / "a.geo");
  CHECK(contains(folder.text("a.geo"), "Physical Surface(\"ungrouped\", 4) = {2};\n"));
  write_geo(test::square_with_hole(), folder / "b.geo");
  CHECK(contains(folder.text("b.geo"), "Plane Surface(1) = {1, 2};\n"));
  CHECK_FALSE(contains(folder.text("b.geo"), "Physical"));
}

TEST_CASE("the outline of a mesh leaves out its interior vertices") {
  const ScratchFolder folder;
  Pslg pslg = test::square_with_hole();
  pslg.points.push_back({0.5, 0.5});
  write_geo(pslg, folder / "pslg.geo");
  write_geo(constrained_delaunay(pslg).mesh, folder / "mesh.geo");
  CHECK(contains(folder.text("pslg.geo"), "Point{9} In Surface{1};\n"));
  CHECK_FALSE(contains(folder.text("mesh.geo"), "Point(9)"));
}

TEST_CASE("a group name with a double quote is refused and nothing is left") {
  const ScratchFolder folder;
  Pslg pslg = test::two_squares();
  pslg.entities.groups[0].name = "a\"; SystemCall \"b";
  CHECK(contains(test::error_of<InputError>([&] { write_geo(pslg, folder / "a.geo"); }),
                 "physical group 1: its name has a double quote"));
  CHECK(folder.names().empty());
}

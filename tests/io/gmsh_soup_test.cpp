#include "lepp/io/gmsh_soup.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "io/scratch_folder.hpp"
#include "lepp/io/gmsh_import.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/real_inputs.hpp"

using namespace lepp;
using lepp::test::contains;
using lepp::test::error_of;
using lepp::test::ScratchFolder;

namespace {

/// Two triangles of two surfaces, one on each side of the diagonal; node 9 belongs to none. The
/// left side is in two groups, so that its line is there twice.
const std::string two_surfaces =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n2\n1 5 \"left\"\n2 7 \"lower\"\n$EndPhysicalNames\n"
    "$Nodes\n5\n10 0 0 0\n20 1 0 0\n30 1 1 0\n40 0 1 0\n9 7 7 0\n$EndNodes\n"
    "$Elements\n6\n"
    "1 15 2 3 1 10\n"
    "2 1 2 5 4 40 10\n"
    "3 1 2 6 4 40 10\n"
    "4 1 2 8 9 10 9\n"
    "101 2 2 7 1 10 20 30\n"
    "102 2 2 8 2 10 30 40\n"
    "$EndElements\n";

double area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    sum += 0.5 * cross(b - a, c - a);
  }
  return sum;
}

/// The columns of a comma-separated table.
std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) result.push_back(field);
  return result;
}

}  // namespace

TEST_CASE("triangles, numbers, surfaces and groups of a .msh file come through") {
  const ScratchFolder scratch;
  const GmshInput input = read_gmsh(scratch.put("two.msh", two_surfaces));
  REQUIRE(input.triangles);
  const TriangleSoup& soup = *input.triangles;
  CHECK(soup.point_numbers == std::vector<std::int64_t>{10, 20, 30, 40});
  CHECK(soup.triangle_numbers == std::vector<std::int64_t>{101, 102});
  CHECK(soup.entities[soup.regions[0]].tag == 1);
  CHECK(soup.entities[soup.regions[1]].tag == 2);
  CHECK(soup.entities[soup.entities[soup.regions[0]].groups.at(0)].name == "lower");
  REQUIRE(soup.entities.points.size() == 1);
  CHECK(soup.points[soup.entities.points[0].vertex.index()] == Point{0, 0});
}

TEST_CASE("a line that is there once per group counts once and has both groups") {
  const ScratchFolder scratch;
  const GmshInput input = read_gmsh(scratch.put("two.msh", two_surfaces));
  const TriangleSoup& soup = *input.triangles;
  REQUIRE(soup.segments.size() == 1);
  const CurveEntity& left = soup.entities[*soup.segments[0].curve];
  CHECK(left.tag == 4);
  REQUIRE(left.groups.size() == 2);
  CHECK(soup.entities[left.groups[0]].tag == 5);
  CHECK(soup.entities[left.groups[1]].tag == 6);
}

TEST_CASE("nodes and lines without triangle are dropped with a warning") {
  const ScratchFolder scratch;
  const GmshInput input = read_gmsh(scratch.put("two.msh", two_surfaces));
  std::string all;
  for (const std::string& sentence : input.warnings) all += sentence + "\n";
  CHECK(contains(all, "the first is node 9"));
  CHECK(contains(all, "1 lines are no edge of a triangle"));
}

TEST_CASE("the outline of a mesh is its boundary, interfaces and lines") {
  const ScratchFolder scratch;
  const GmshInput input = read_gmsh(scratch.put("two.msh", two_surfaces));
  CHECK(input.pslg.segments.size() == 5);
  const Mesh again = constrained_delaunay(input.pslg).mesh;
  CHECK(again.triangle_count() == 2);
  CHECK(area(again) == doctest::Approx(1));
  CHECK(again.region(TriangleId(0U)) != again.region(TriangleId(1U)));
}

TEST_CASE("a .geo script named .msh is not run") {
  const ScratchFolder scratch;
  const auto file = scratch.put("fake.msh", "SystemCall \"touch ran\";\nPoint(1) = {0, 0, 0};\n");
  CHECK(contains(error_of<InputError>([&] { read_gmsh(file); }), "does not begin like a .msh"));
  CHECK(scratch.names().size() == 1);
}

TEST_CASE("real .msh files: as many triangles as they have, or refused by what they hold") {
  const auto table = test::real_input("msh_properties.csv");
  if (!table) return;
  std::ifstream lines(*table);
  std::string line;
  std::getline(lines, line);  // the names of the columns
  while (std::getline(lines, line)) {
    const std::vector<std::string> row = fields(line);
    const auto file = test::real_input(row[0]);
    CAPTURE(row[0]);
    const bool triangles_only = row.size() > 6 && row[5] == "yes" && row[6] == "tri3:" + row[7];
    if (triangles_only) {
      const GmshInput input = read_gmsh(*file);
      CHECK(input.triangles->triangles.size() == std::stoul(row[7]));
      const Mesh mesh = mesh_from_triangles(*input.triangles).mesh;
      CHECK(area(constrained_delaunay(input.pslg).mesh) ==
            doctest::Approx(area(mesh)).epsilon(1e-9));
    } else {
      CHECK_THROWS_AS(read_gmsh(*file), InputError);
    }
  }
}

TEST_CASE("hostile .msh files are read, or refused with the reason") {
  for (const char* name :
       {"m01_tags_noncontiguous_64bit", "m07_binary_little_endian", "m17_orphan_nodes"}) {
    CAPTURE(name);
    if (const auto file = test::real_input("nasty/" + std::string(name) + ".msh"))
      CHECK(area(mesh_from_triangles(*read_gmsh(*file).triangles).mesh) == doctest::Approx(1));
  }
  const std::vector<std::pair<std::string, std::string>> reasons = {
      {"m03_second_order", "1 second-order triangle (6-node)"},
      {"m05_tetrahedra_only", "found 1 tetrahedron"},
      {"m09_missing_node_reference", "node 99 in element 2"},
      {"m13_count_1e18", "1000000000000000000 nodes"},
      {"m15_unknown_version", "MSH version 9.9"},
      {"m19_no_elements", "no elements"},
      {"m21_sections_swapped_crlf", "elements come before the nodes"}};
  for (const auto& row : reasons) {
    const auto& name = row.first;
    const auto& reason = row.second;
    CAPTURE(name);
    if (const auto file = test::real_input("nasty/" + name + ".msh"))
      CHECK(contains(error_of<InputError>([&] { read_gmsh(*file); }), reason));
  }
}

TEST_CASE("in old formats, elements of one tag but different groups are entities of their own") {
  const ScratchFolder scratch;
  const GmshInput input = read_gmsh(scratch.put(
      "old.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
      "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
      "$Elements\n4\n1 1 2 11 0 1 2\n2 1 2 12 0 2 3\n3 2 2 21 0 1 2 3\n4 2 2 22 0 1 3 4\n"
      "$EndElements\n"));
  const TriangleSoup& soup = *input.triangles;
  REQUIRE(soup.entities.curves.size() == 2);
  REQUIRE(soup.entities.surfaces.size() == 2);
  CHECK(soup.entities.curves[0].tag == 11);
  CHECK(soup.entities.surfaces[1].tag == 22);
  for (const SurfaceEntity& surface : soup.entities.surfaces) {
    REQUIRE(surface.groups.size() == 1);
    CHECK(soup.entities[surface.groups[0]].tag == surface.tag);
  }
  CHECK(constrained_delaunay(input.pslg).mesh.entities().surfaces.size() == 2);
}

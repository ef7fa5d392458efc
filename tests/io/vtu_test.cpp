#include "lepp/io/vtu.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "io/sample_meshes.hpp"
#include "io/scratch_folder.hpp"
#include "lepp/triangulation/quality.hpp"

using namespace lepp;
using test::contains;
using test::ScratchFolder;

namespace {

// The numbers of a named data array.
std::vector<double> array_of(const std::string& text, const std::string& name) {
  const auto head = text.find("Name=\"" + name + "\"");
  REQUIRE(head != std::string::npos);
  const auto begin = text.find(">\n", head) + 2;
  std::istringstream stream(text.substr(begin, text.find('<', begin) - begin));
  std::vector<double> numbers;
  for (double x = 0; stream >> x;) numbers.push_back(x);
  return numbers;
}

}  // namespace

TEST_CASE("a .vtu file has the triangles with region, angles and admissibility") {
  const ScratchFolder folder;
  const Mesh mesh = test::two_squares_mesh();
  write_vtu(mesh, folder / "a.vtu", {.at_vertices = {{"u <V>", std::vector<double>(9, 0.1)}}});
  const std::string text = folder.text("a.vtu");
  CHECK(contains(text, "NumberOfPoints=\"9\" NumberOfCells=\"10\""));
  CHECK(array_of(text, "connectivity").size() == 30);
  CHECK(array_of(text, "offsets").back() == 30);
  CHECK(array_of(text, "u &lt;V&gt;") == std::vector<double>(9, 0.1));
  const auto regions = array_of(text, "region");
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(regions[i] == mesh.entities()[mesh.region(TriangleId(i))].tag);
  }
  const Quality quality = measure(mesh);
  CHECK(std::ranges::min(array_of(text, "min_angle_deg")) == quality.min_angle_deg);
  CHECK(std::ranges::max(array_of(text, "max_angle_deg")) == quality.max_angle_deg);
}

TEST_CASE("a triangle is marked where an edge factor of its region is negative") {
  Pslg pslg;  // a flat triangle below a tall one: the base of the flat one faces an obtuse angle
  pslg.points = {{0, 0}, {4, 0}, {2, 0.5}, {2, 6}};
  for (const auto& [a, b] : {std::pair(0U, 1U), {1U, 3U}, {3U, 0U}, {0U, 2U}, {2U, 1U}}) {
    pslg.segments.push_back({VertexId(a), VertexId(b), std::nullopt, 0, 1});
  }
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  const ScratchFolder folder;
  write_vtu(mesh, folder / "a.vtu");
  const auto admissible = array_of(folder.text("a.vtu"), "admissible");
  REQUIRE(admissible.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& v = mesh.vertices(TriangleId(i));
    const bool is_flat = std::ranges::find(v, VertexId(3U)) == v.end();
    if (is_flat) CHECK(admissible[i] == 0);
  }
}

TEST_CASE("boxes are polygons with their area") {
  const ScratchFolder folder;
  const Mesh mesh = test::two_squares_mesh();
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  write_boxes_vtu(mesh, boxes, folder / "a.vtu");
  const std::string text = folder.text("a.vtu");
  const auto vertices = array_of(text, "vertex");
  CHECK(vertices.size() == boxes.piece_triangle.size());
  CHECK(array_of(text, "box_area").size() == vertices.size());
  CHECK(array_of(text, "offsets").back() == static_cast<double>(boxes.corners.size()));
}

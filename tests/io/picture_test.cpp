#include "lepp/io/picture.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include "io/sample_meshes.hpp"
#include "io/scratch_folder.hpp"

using namespace lepp;
using test::contains;
using test::ScratchFolder;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// The length of all lines "Mx yLx y" in the path of the boxes.
double box_lines_length(const std::string& text) {
  const auto path = text.find("stroke=\"#2a7f62\"");
  REQUIRE(path != std::string::npos);
  const auto begin = text.find(" d=\"", path) + 4;
  std::string numbers = text.substr(begin, text.find('"', begin) - begin);
  for (char& c : numbers) {
    if (c == 'M' || c == 'L') c = ' ';
  }
  std::istringstream stream(numbers);
  double sum = 0;
  for (Point p, q; stream >> p.x >> p.y >> q.x >> q.y;) sum += std::hypot(q.x - p.x, q.y - p.y);
  return sum;
}

}  // namespace

TEST_CASE("a picture has a fill per region, all triangles, and the boundary") {
  const ScratchFolder folder;
  write_picture(test::two_squares_mesh(), folder / "a.svg");
  const std::string text = folder.text("a.svg");
  CHECK(text.starts_with("<svg "));
  CHECK(text.ends_with("</svg>\n"));
  CHECK(count(text, "<path ") == 4);  // two regions, inside edges, boundary
  CHECK(count(text, "Z\n") == 10);
  CHECK(count(text, "M") == 10 + 2 + 6);
  CHECK(contains(text, "width=\"1020.0\" height=\"520.0\""));
}

TEST_CASE("the picture does not depend on where the mesh lies, nor on its unit") {
  const ScratchFolder folder;
  Pslg pslg = test::two_squares();
  write_picture(constrained_delaunay(pslg).mesh, folder / "a.svg");
  for (Point& p : pslg.points) p = {500000 + 1024 * p.x, 4649000 + 1024 * p.y};
  for (RegionSeed& s : pslg.seeds) s.at = {500000 + 1024 * s.at.x, 4649000 + 1024 * s.at.y};
  write_picture(constrained_delaunay(pslg).mesh, folder / "b.svg");
  CHECK(folder.text("a.svg") == folder.text("b.svg"));
}

TEST_CASE("y points up") {
  const ScratchFolder folder;
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {0, 2}};
  write_picture(constrained_delaunay(pslg).mesh, folder / "a.svg", {.width = 100});
  CHECK(contains(folder.text("a.svg"), "10.00 10.00"));   // the top corner
  CHECK(contains(folder.text("a.svg"), "60.00 110.00"));  // the right one
}

TEST_CASE("boxes are drawn over the triangles, each face once") {
  const ScratchFolder folder;
  Pslg pslg;  // one equilateral triangle: three faces meet in the middle
  pslg.points = {{0, 0}, {1, 0}, {0.5, 0.8660254037844386}};
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  write_picture(mesh, folder / "plain.svg");
  write_picture(mesh, folder / "boxes.svg", {.boxes = &boxes});
  CHECK(count(folder.text("boxes.svg"), "M") == count(folder.text("plain.svg"), "M") + 3);
}

TEST_CASE("all faces are drawn, and none twice, where rounding differs between two boxes") {
  // Rows of points, every second one shifted by half a step: many faces are vertical up to
  // rounding.
  Pslg pslg;
  for (int row = 0; row < 9; ++row) {
    for (int i = 0; i < 9; ++i) {
      pslg.points.push_back({0.1 * i + (row % 2 == 0 ? 0 : 0.05), 0.09 * row});
    }
  }
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  const ScratchFolder folder;
  write_picture(mesh, folder / "a.svg", {.boxes = &boxes});
  double wanted = 0;
  for (const VoronoiFace& face : boxes.faces) wanted += face.length;
  const double scale = 1000 / 0.85;  // the drawing is 1000 wide
  CHECK(box_lines_length(folder.text("a.svg")) / scale == doctest::Approx(wanted).epsilon(1e-3));
}

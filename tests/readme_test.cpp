#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "io/scratch_folder.hpp"

#include "lepp/io/gmsh_import.hpp"
#include "lepp/io/msh.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "lepp/voronoi/voronoi_boxes.hpp"

using namespace lepp;
namespace fs = std::filesystem;

namespace {

const fs::path project = LEPP_PROJECT;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

const fs::path this_file = project / "tests/readme_test.cpp";

// The lines of this file between the two marks, flush left, after a line end.
std::string shown_lines() {
  std::istringstream lines(text_of(this_file));
  std::string line, shown = "\n";
  while (std::getline(lines, line) && line != "  // README begins") {
  }
  while (std::getline(lines, line) && line != "  // README ends") shown += line.substr(2) + '\n';
  return shown;
}

// A folder in which the project's meshes are in meshes/, as the lines expect, is the current one.
class Workplace {
 public:
  Workplace() : before_(fs::current_path()) {
    fs::create_directory_symlink(project / "meshes", scratch_ / "meshes");
    fs::current_path(scratch_ / ".");
  }
  ~Workplace() { fs::current_path(before_); }

 private:
  test::ScratchFolder scratch_;
  fs::path before_;
};

}  // namespace

TEST_CASE("README.md shows the lines that this file runs") {
  const std::string shown = shown_lines();
  CAPTURE(shown);
  CHECK(std::ranges::count(shown, '\n') == 10);
  CHECK(test::contains(text_of(project / "README.md"), shown));
}

TEST_CASE("README.md includes nothing that this file does not include") {
  std::istringstream readme(text_of(project / "README.md"));
  const std::string ours = text_of(this_file);
  for (std::string line; std::getline(readme, line);) {
    CAPTURE(line);
    if (line.starts_with("#include")) CHECK(test::contains(ours, "\n" + line + "\n"));
  }
}

TEST_CASE("the lines that README.md shows do what it says") {
  const Workplace workplace;
  double sum = 0;
  const auto assemble = [&](VertexId k, VertexId l, double transmissibility) {
    CHECK(k < l);
    CHECK(transmissibility >= 0);
    sum += transmissibility;
  };
  // README begins
  const Pslg pslg = read_geo("meshes/valid/annulus.geo");
  Mesh mesh = constrained_delaunay(pslg).mesh;
  const RefineReport refined = refine(mesh, {.min_angle_deg = 28});
  const Certificate certificate = certify(mesh);
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  for (const VoronoiFace& f : boxes.faces) {  // two-point flux: length / distance * (u_k - u_l)
    assemble(f.k, f.l, f.length / f.distance);
  }
  write_msh(mesh, "annulus.msh");
  // README ends
  CHECK(refined.goal_reached);
  CHECK(certificate.summary() == "admissible");
  CHECK(sum > 0);
  CHECK(read_gmsh("annulus.msh").triangles->triangles.size() == mesh.triangle_count());
}

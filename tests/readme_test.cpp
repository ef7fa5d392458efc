#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "io/scratch_folder.hpp"

// README.md shows the lines between the marks, here and below, and this file runs them.
// README: includes begin
#include "lepp/io/gmsh_import.hpp"
#include "lepp/io/msh.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/voronoi/admissible.hpp"
// README: includes end

using namespace lepp;
namespace fs = std::filesystem;

namespace {

const fs::path project = LEPP_PROJECT;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The lines of this file between two marks, less the indentation of the first.
std::string shown_lines(const std::string& what) {
  std::istringstream lines(text_of(project / "tests/readme_test.cpp"));
  std::string line, shown;
  while (std::getline(lines, line) && !line.ends_with("// README: " + what + " begin")) {
  }
  const std::size_t indentation = line.find_first_not_of(' ');
  while (std::getline(lines, line) && !line.ends_with("// README: " + what + " end")) {
    shown += line.substr(indentation) + '\n';
  }
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

TEST_CASE("README.md shows the lines that this test runs") {
  const std::string readme = text_of(project / "README.md");
  for (const std::string what : {"includes", "lines"}) {
    const std::string shown = shown_lines(what);
    CAPTURE(shown);
    CHECK(shown.size() > 100);
    CHECK(test::contains(readme, shown));
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
  // README: lines begin
  const Pslg pslg = read_geo("meshes/valid/annulus.geo");
  Mesh mesh = constrained_delaunay(pslg).mesh;
  const RefineReport refined = refine(mesh, {.min_angle_deg = 28});
  const Certificate certificate = certify(mesh);
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  for (const VoronoiFace& f : boxes.faces) {  // two-point flux: length / distance * (u_k - u_l)
    assemble(f.k, f.l, f.length / f.distance);
  }
  write_msh(mesh, "annulus.msh");
  // README: lines end
  CHECK(refined.goal_reached);
  CHECK(certificate.summary() == "admissible");
  CHECK(sum > 0);
  CHECK(read_gmsh("annulus.msh").triangles->triangles.size() == mesh.triangle_count());
}

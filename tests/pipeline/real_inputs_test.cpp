// The program on real files; see support/real_inputs.hpp.

#include <doctest/doctest.h>

#include <set>

#include "pipeline/program.hpp"
#include "support/table.hpp"

using namespace lepp::test;
namespace fs = std::filesystem;

TEST_CASE("real .geo files: certified meshes where Gmsh makes a plane mesh, else a clear error") {
  const auto rows = table("geo_properties.csv");
  CHECK((rows.size() > 10 || !has_real_inputs()));
  for (const Row& row : rows) {
    const auto file = real_input(row.at("file"));
    if (!file) continue;
    if (row.at("gmsh484_result") == "no result in 60 s") continue;  // so is ours: a time limit
    CAPTURE(row.at("file"));
    const bool elements = row.at("triangles") != "0" || row.at("quads") != "0";
    const bool good = row.at("gmsh484_result") == "ok" && row.at("planar") == "yes" && elements;
    const ScratchFolder folder;
    const Outcome made = run(folder.path(), "mesh " + quoted(*file) + " -o out.msh -q --json -");
    CAPTURE(made.err);
    if (!good) {
      CHECK((made.status == 2 || made.status == 4));
      CHECK(files_in(folder.path()).empty());
      continue;
    }
    REQUIRE(made.status == 0);
    const Json report = Json::parse(made.out);
    CHECK(report["goal_reached"] == true);
    CHECK(report["admissible"] == true);
    CHECK(report["obtuse_constrained"] == 0);
    CHECK(report["non_delaunay_edges"] == 0);
  }
}

TEST_CASE("real .msh files: check counts what others counted, and refuses the rest by name") {
  const auto rows = table("msh_properties.csv");
  CHECK((rows.size() > 40 || !has_real_inputs()));
  for (const Row& row : rows) {
    const auto file = real_input(row.at("file"));
    if (!file) continue;
    CAPTURE(row.at("file"));
    const ScratchFolder folder;
    const Outcome checked = run(folder.path(), "check " + quoted(*file) + " -q --json -");
    CAPTURE(checked.err);
    const std::string& elements = row.at("element_counts_2d");
    const bool good = row.at("gmsh484_reader") == "ok" && row.at("planar") == "yes" &&
                      elements.starts_with("tri3") && elements.find(' ') == std::string::npos;
    if (!good) {
      CHECK(checked.status == 2);
      continue;
    }
    REQUIRE(checked.status == 0);
    const Json report = Json::parse(checked.out);
    const auto& tolerant = report["tolerant"];
    CHECK(report["triangles"] == std::stoi(row.at("triangles")));
    CHECK(report["min_angle_deg"].get<double>() ==
          doctest::Approx(std::stod(row.at("min_angle_deg"))).epsilon(1e-3));
    CHECK(tolerant["obtuse_triangles"] == std::stoi(row.at("obtuse_triangles")));
    CHECK(tolerant["non_delaunay_edges"] == std::stoi(row.at("non_delaunay_edges")));
    CHECK(tolerant["obtuse_boundary"] == std::stoi(row.at("boundary_edges_facing_obtuse")));
    for (const char* key : {"obtuse_triangles", "non_delaunay_edges", "obtuse_boundary"}) {
      CHECK(report[key].get<int>() >= tolerant[key].get<int>());
    }
    const Outcome better = run(folder.path(), "mesh " + quoted(*file) + " -o out.msh -q --json -");
    CAPTURE(better.err);
    CHECK(better.status == 0);
  }
}

TEST_CASE("nasty inputs: mesh or error as their list says, no crash, no file left behind") {
  const auto list = real_input("nasty/README.md");
  if (!list) return;
  std::ifstream in(*list);
  std::string line;
  int rows = 0;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string bar, name, must;
    if (!(cells >> bar >> name >> bar >> must) || bar != "|" || !line.starts_with("| ")) continue;
    const auto kind = fs::path(name).extension();
    if (kind != ".poly" && kind != ".geo" && kind != ".msh" && kind != ".ele") continue;
    const auto file = real_input("nasty/" + name);
    if (!file) continue;
    ++rows;
    CAPTURE(name);
    const ScratchFolder folder;
    const Outcome made = run(folder.path(), "mesh " + quoted(*file) + " -o out.msh");
    CAPTURE(made.err);
    const std::set<int> allowed = must == "mesh"    ? std::set<int>{0}
                                  : must == "error" ? std::set<int>{2, 4}
                                                    : std::set<int>{0, 2, 3, 4};
    CHECK(allowed.contains(made.status));
    const auto left = files_in(folder.path());
    CHECK(left ==
          (made.status == 0 ? std::vector<std::string>{"out.msh"} : std::vector<std::string>{}));
    if (made.status == 0) CHECK(run(folder.path(), "check out.msh -q --delaunay").status == 0);
    else CHECK(made.err.size() + made.out.size() > 20);
  }
  CHECK(rows > 40);
}

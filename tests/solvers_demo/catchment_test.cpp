// From a height grid to a solution on its catchment: lepp terrain, then lepp-poisson.

#include <doctest/doctest.h>

#include "pipeline/program.hpp"
#include "support/real_inputs.hpp"

using namespace lepp::test;
namespace fs = std::filesystem;

namespace {

// Water that seeps in everywhere leaves through the outline: all of it, whatever the mesh is like.
void check_balance(const fs::path& grid, const std::string& error, double area) {
  const ScratchFolder folder;
  const Outcome meshed = run(folder.path(), "terrain " + quoted(grid) +
                                                " -o catchment.msh --nonobtuse --json - -q "
                                                "--max-error " +
                                                error);
  REQUIRE(meshed.status == 0);
  CHECK(Json::parse(meshed.out)["admissible"] == true);
  const Outcome solved = run(folder.path(),
                             "catchment.msh --method fv --diffusion terrain=50 --source "
                             "terrain=0.001 --dirichlet outline=0 --json -",
                             LEPP_POISSON_PROGRAM);
  CAPTURE(solved.err);
  REQUIRE(solved.status == 0);
  const Json report = Json::parse(solved.out);
  CHECK(report["admissible"] == true);
  CHECK(report["inflow"]["outline"] == doctest::Approx(-0.001 * area).epsilon(1e-9));
  CHECK(report["min"] == 0.0);  // no value below those on the outline: the maximum principle
  CHECK(report["max"] > 0.1);
}

}  // namespace

TEST_CASE("diffusion over a catchment made of a height grid loses no water") {
  // 1564 cells and half cells of 25 m
  check_balance(fs::path(LEPP_MESHES) / "terrain" / "hill.asc", "2", 977500);
}

TEST_CASE("diffusion over the catchment of a real DEM loses no water") {
  const auto grid = real_input("dem/landlab_hugo_site.asc");
  if (grid) check_balance(*grid, "0.5", 210600);
}

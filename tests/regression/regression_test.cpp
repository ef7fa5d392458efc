// Each .poly in this folder once showed a bug, told in its first line. Every one must give a valid
// mesh from refine(), whatever it says about the goal.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "lepp/io/poly.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/boundary_meetings.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"
#include "lepp/voronoi/admissible.hpp"

using namespace lepp;

TEST_CASE("inputs that once showed a bug give valid meshes with reasons that hold") {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LEPP_REGRESSION)) {
    if (entry.path().extension() != ".poly") continue;
    ++files;
    CAPTURE(entry.path().filename().string());
    Mesh mesh = constrained_delaunay(read_poly(entry.path()), {Crossings::split}).mesh;
    REQUIRE(validate(mesh).summary() == "valid");
    const RefineReport report = refine(mesh);
    CHECK_FALSE(first_boundary_meeting(mesh));
    MeshClaims claims;
    claims.min_angle_deg = 30;
    claims.nonobtuse = true;
    claims.unfinished = report.unfinished;
    CHECK(validate(mesh, claims).summary() == "valid");
    const bool thin = entry.path().stem() == "thin_channel";
    const bool endless = thin || entry.path().stem() == "split_off_the_line";  // a gap of 1e-16
    CHECK(report.goal_reached != endless);
    const bool below_floor = std::ranges::any_of(
        report.unfinished, [](const Unfinished& u) { return u.reason == Reason::input_feature; });
    if (!endless) CHECK(certify(mesh).admissible == !below_floor);
  }
  CHECK(files >= 5);
}

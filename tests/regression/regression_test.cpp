// Each .poly in this folder once showed a bug, told in its first line. Every one must give a valid
// mesh from refine(), whatever it says about the goal.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "lepp/bisection/forest.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/boundary_meetings.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "lepp/voronoi/admissible.hpp"

using namespace lepp;

namespace {

// A gap, a wedge or a needle that would need more vertices than the budget has.
bool is_endless(const std::string& name) {
  const char* const names[] = {"thin_channel", "split_off_the_line", "fan_of_wedges_1e-9",
                               "needle_of_5_ulp", "six_points_1e-11"};
  return std::ranges::find(names, name) != std::end(names);
}

}  // namespace

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
    const bool endless = is_endless(entry.path().stem().string());
    CHECK(report.goal_reached != endless);
    const bool below_floor = std::ranges::any_of(
        report.unfinished, [](const Unfinished& u) { return u.reason == Reason::input_feature; });
    if (!endless && !below_floor) CHECK(certify(mesh).admissible);
  }
  CHECK(files >= 5);
}

TEST_CASE("bisecting inputs that once showed a bug never makes a mesh meet itself") {
  for (const auto& entry : std::filesystem::directory_iterator(LEPP_REGRESSION)) {
    if (entry.path().extension() != ".poly") continue;
    CAPTURE(entry.path().filename().string());
    Forest forest(constrained_delaunay(read_poly(entry.path()), {Crossings::split}).mesh);
    for (int round = 0; round < 8; ++round) {
      std::vector<TriangleId> all;
      for (std::size_t t = 0; t < forest.mesh().triangle_count(); ++t) all.emplace_back(t);
      forest.bisect(all);
      REQUIRE_FALSE(first_boundary_meeting(forest.mesh()));
    }
    CHECK(validate(forest.mesh(), {.delaunay = false}).summary() == "valid");
  }
}

TEST_CASE("with a largest angle asked for, report and check agree on inputs that showed a bug") {
  for (const auto& entry : std::filesystem::directory_iterator(LEPP_REGRESSION)) {
    if (entry.path().extension() != ".poly") continue;
    for (const double bound : {90.0, 100.0, 179.9999}) {
      CAPTURE(entry.path().filename().string());
      CAPTURE(bound);
      Mesh mesh = constrained_delaunay(read_poly(entry.path()), {Crossings::split}).mesh;
      const RefineReport report =
          refine(mesh, {.max_angle_deg = bound, .max_vertices = mesh.vertex_count() + 500});
      MeshClaims claims;
      claims.min_angle_deg = 30;
      claims.max_angle_deg = bound;
      claims.nonobtuse = true;
      claims.unfinished = report.unfinished;
      CHECK(validate(mesh, claims).summary() == "valid");
    }
  }
}

TEST_CASE("no angle above 90 degrees is left beside sharp vertices whose edges end nearby") {
  for (const char* name :
       {"free_wedge_50_degrees", "triangle_30_degrees", "crossing_at_53_degrees"}) {
    CAPTURE(name);
    const auto path = std::filesystem::path(LEPP_REGRESSION) / (std::string(name) + ".poly");
    Mesh mesh = constrained_delaunay(read_poly(path), {Crossings::split}).mesh;
    const RefineReport report = refine(mesh, {.max_angle_deg = 90});
    CHECK(report.goal_reached);
    CHECK(validate(mesh, {.max_angle_deg = 90}).summary() == "valid");
    CHECK(measure(mesh).obtuse_triangles.exact == 0);
  }
}

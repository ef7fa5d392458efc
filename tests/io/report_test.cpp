#include "lepp/io/report.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "io/sample_meshes.hpp"
#include "io/scratch_folder.hpp"

using namespace lepp;
using nlohmann::json;
using test::contains;

namespace {

RunReport sample() {
  RunReport report;
  report.input = "plate.geo";
  report.quality.vertices = 116;
  report.quality.triangles = 149;
  report.quality.min_angle_deg = 30.77;
  report.quality.obtuse_triangles = {7, 6};
  report.quality.obtuse_constrained = {2, 1};
  report.quality.non_delaunay_edges = {3, 0};
  report.input_vertices = 6;
  report.steiner_points = 110;
  report.below_bound = count_reasons({{TriangleId(4U), Reason::input_angle},
                                      {TriangleId(5U), Reason::budget},
                                      {TriangleId(6U), Reason::budget}});
  report.goal_reached = false;
  report.admissible = true;
  for (const char* name : {"triangulate", "refine", "nonobtuse"}) {
    report.stages.push_back({name, report.quality, 17});
  }
  report.seconds.read = 0.5;
  report.seconds.total = 1.5;
  report.warnings = {"duplicate points merged"};
  return report;
}

}  // namespace

TEST_CASE("the JSON report has every figure under its name") {
  const json report = json::parse(to_json(sample()));
  CHECK(report["schema_version"] == 1);
  CHECK(report["vertices"] == 116);
  CHECK(report["triangles"] == 149);
  CHECK(report["input_vertices"] == 6);
  CHECK(report["steiner_points"] == 110);
  CHECK(report["min_angle_deg"] == 30.77);
  CHECK(report["below_bound"] == json{{"input_angle", 1},
                                      {"input_feature", 0},
                                      {"size_floor", 0},
                                      {"budget", 2},
                                      {"cancelled", 0},
                                      {"method", 0},
                                      {"kept_border", 0}});
  CHECK(report["obtuse_constrained"] == 2);
  CHECK(report["non_delaunay_edges"] == 3);
  CHECK(report["tolerant"]["obtuse_constrained"] == 1);
  CHECK(report["tolerant"]["non_delaunay_edges"] == 0);
  CHECK(report["tolerant"]["obtuse_triangles"] == 6);
  CHECK(report["admissible"] == true);
  CHECK(report["goal_reached"] == false);
  CHECK(report["valid"].is_null());  // was not asked
  REQUIRE(report["stages"].size() == 3);
  CHECK(report["stages"][2]["name"] == "nonobtuse");
  CHECK(report["stages"][2]["insertions"] == 17);
  for (const char* figure : {"vertices", "triangles", "min_angle_deg", "mean_min_angle_deg",
                             "max_angle_deg", "mean_max_angle_deg", "obtuse_constrained"}) {
    CHECK(report["stages"][0].contains(figure));
  }
  for (const char* part :
       {"read", "triangulate", "refine", "nonobtuse", "voronoi", "check", "write", "total"}) {
    CHECK(report["seconds"].contains(part));
  }
  CHECK(report["seconds"]["total"] == 1.5);
  CHECK(report["warnings"][0] == "duplicate points merged");
}

TEST_CASE("a name that is no UTF-8 and a figure that is no number make valid JSON all the same") {
  RunReport report;
  report.warnings = {"caf\xE9"};
  report.quality.min_angle_deg = std::numeric_limits<double>::quiet_NaN();
  const json parsed = json::parse(to_json(report));
  CHECK(parsed["warnings"][0] == "caf\xEF\xBF\xBD");
  CHECK(parsed["min_angle_deg"].is_null());
}

TEST_CASE("groups are reported with entities and size") {
  const auto groups = group_figures(test::two_squares_mesh());
  REQUIRE(groups.size() == 8);
  CHECK(groups[2].name == "plate");
  CHECK(groups[2].dimension == 2);
  CHECK(groups[2].entities == 2);
  CHECK(groups[2].measure == doctest::Approx(2));
  CHECK(groups[3].entities == 4);
  CHECK(groups[3].measure == doctest::Approx(5));
  CHECK(groups[7].entities == 1);
  CHECK(groups[7].measure == 1);
  RunReport report;
  report.groups = groups;
  const json parsed = json::parse(to_json(report));
  CHECK(parsed["groups"][2]["area"] == doctest::Approx(2));
  CHECK(parsed["groups"][3]["length"] == doctest::Approx(5));
  CHECK(parsed["groups"][7]["points"] == 1);
}

TEST_CASE("offending edges are named in the user's numbers, with place and region") {
  Pslg pslg;
  pslg.base = 1;
  pslg.points = {{0, 0}, {4, 0}, {2, 0.5}};
  pslg.entities.surfaces = {{77, {}, 77, 1e300}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    pslg.segments.push_back({VertexId(i), VertexId((i + 1) % 3), std::nullopt, 0, 1});
  }
  pslg.seeds = {{{2, 0.25}, SurfaceId(0U)}};
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  const auto edges = offending_edges(mesh, certify(mesh, voronoi_boxes(mesh)));
  REQUIRE(edges.size() == 1);
  CHECK(edges[0].k == 1);
  CHECK(edges[0].l == 2);
  CHECK(edges[0].at_l == Point{4, 0});
  CHECK(edges[0].region == 77);
  CHECK(edges[0].factor < 0);
}

TEST_CASE("the text report has a column per stage and says what is wrong") {
  const std::string text = to_text(sample());
  CHECK(contains(text, "   triangulate        refine     nonobtuse\n"));
  CHECK(contains(text, "30.77         30.77         30.77\n"));
  CHECK(contains(text, "1 input_angle, 2 budget"));
  CHECK(contains(text, "2 (1 beyond 1e-9 degrees)"));
  CHECK(contains(text, "warning: duplicate points merged"));
}

TEST_CASE("this process has used memory, in bytes") {
  CHECK(peak_memory_bytes() > 500'000);
  CHECK(peak_memory_bytes() < 100'000'000'000);
}

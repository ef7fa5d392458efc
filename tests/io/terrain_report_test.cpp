#include "lepp/io/terrain_report.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "io/scratch_folder.hpp"
#include "support/hand_made.hpp"

using namespace lepp;
using test::contains;

namespace {

TerrainReport sample() {
  TerrainReport report;
  report.input = "dem.asc";
  report.columns = 60;
  report.rows = 40;
  report.samples = 1608;
  report.lowest = 488.2;
  report.highest = 729.6;
  report.by = "lepp";
  report.metric = "planar";
  report.max_error = 2.5;
  report.min_angle_deg = 30;
  report.whole = {"dem.ply", "", 427, 795, {}, {431550, 5103725}};
  report.whole.error.max = 2.25;
  report.whole.error.column = 14;
  report.whole.error.row = 26;
  report.whole.error.samples = 1608;
  report.whole.error.on_hard_lines.max = 2.25;
  report.whole.error.elsewhere.max = 1.75;
  report.whole.error.samples_on_hard_lines = 7;
  report.levels.push_back({"dem.level1.ply", "level 1", 40, 66, {}, {}});
  report.levels[0].min_angle_deg = 12.75;
  report.levels[0].below_bound[static_cast<std::size_t>(Reason::budget)] = 5;
  report.whole.below_bound[static_cast<std::size_t>(Reason::kept_border)] = 3;
  report.error_kept = report.goal_reached = report.valid = true;
  report.warnings = {"a warning"};
  return report;
}

}  // namespace

TEST_CASE("the terrain report for machines names the error, its place, and every reason") {
  const auto json = nlohmann::json::parse(to_json(sample()));
  CHECK(json["schema_version"] == 1);
  CHECK(json["output"] == "dem.ply");
  CHECK(json["heights"] == nlohmann::json({488.2, 729.6}));
  CHECK(json["asked_for"]["max_error"] == 2.5);
  CHECK(json["asked_for"]["max_vertices"].is_null());
  CHECK(json["error"]["max"] == 2.25);
  CHECK(json["error"]["column"] == 14);
  CHECK(json["error"]["on_hard_lines"] ==
        nlohmann::json({{"samples", 7}, {"max", 2.25}, {"max_elsewhere", 1.75}}));
  CHECK(json["error"]["at"] == nlohmann::json({431550.0, 5103725.0}));
  CHECK(json["levels"][0]["output"] == "dem.level1.ply");
  CHECK(json["levels"][0]["min_angle_deg"] == 12.75);
  CHECK(json["levels"][0]["below_bound"]["budget"] == 5);
  CHECK(json["levels"][0]["below_bound"]["kept_border"] == 0);
  CHECK(json["prefixes"].is_null());
  CHECK(json["below_bound"].size() == ReasonCounts().size());
  CHECK(json["below_bound"]["kept_border"] == 3);
  CHECK(json["admissible"].is_null());
  CHECK(json["error_kept"] == true);
  CHECK(json["smallest_angles"].size() == 12);
}

TEST_CASE("the terrain report for machines lists the errors of prefixes if it has them") {
  TerrainReport report = sample();
  report.prefixes = {4, {9.5, 2.25}};
  const auto json = nlohmann::json::parse(to_json(report));
  CHECK(json["prefixes"]["first"] == 4);
  CHECK(json["prefixes"]["max_errors"] == nlohmann::json({9.5, 2.25}));
}

TEST_CASE("the terrain report for people says what was asked for beside what was found") {
  const std::string text = to_text(sample());
  CHECK(contains(text, "2.25 (asked for: 2.5)"));
  CHECK(contains(text, "column 14, row 26: (431550, 5103725)"));
  CHECK(contains(text, "7 samples, off by up to 2.25; elsewhere 1.75"));
  CHECK(contains(text, "60 x 40 samples, 1608 with data\n"));
  CHECK(contains(text, "3 kept_border"));
  CHECK(contains(text, "5 budget"));
  CHECK(contains(text, "12.75"));
  CHECK(contains(text, "dem.level1.ply"));
  CHECK(contains(text, "warning: a warning"));
  CHECK_FALSE(contains(text, "admissible"));
}

TEST_CASE("both reports list a tile that failed, and why; JSON says what was asked of all") {
  TerrainReport report = sample();
  report.border_error = 1.5;
  report.tiling = {2, 1};
  report.window = GridWindow{5, 6, 60, 40};
  report.tiles = {{"dem_0_0.ply", "tile 0 0", 40, 66, {}, {}},
                  {"", "tile 1 0", 0, 0, {}, {}, "the disk is full"}};
  const auto json = nlohmann::json::parse(to_json(report));
  CHECK(json["asked_for"]["border_error"] == 1.5);
  CHECK(json["asked_for"]["tiles"] == nlohmann::json({2, 1}));
  CHECK(json["asked_for"]["window"] == nlohmann::json({5, 6, 60, 40}));
  CHECK(json["tiles"][0]["problem"].is_null());
  CHECK(json["tiles"][1]["problem"] == "the disk is full");
  CHECK_FALSE(json["levels"][0].contains("problem"));
  const std::string text = to_text(report);
  CHECK(contains(text, "the disk is full"));
  CHECK(contains(text, "1608 with data, twice where tiles share them"));
  CHECK(contains(text, "dem_0_0.ply"));
  CHECK(contains(text, "dem.level1.ply"));
}

TEST_CASE("a long list of tiles is cut short for people, but never its end") {
  TerrainReport report = sample();
  for (int i = 0; i < 100; ++i)
    report.tiles.push_back({"", "tile " + std::to_string(i) + " 0", 1, 1, {}, {}});
  report.tiles.back().problem = "cancelled";
  const std::string text = to_text(report);
  CHECK(contains(text, "tile 19 0"));
  CHECK_FALSE(contains(text, "tile 20 0"));
  CHECK(contains(text, "... and 76 more"));
  CHECK(contains(text, "cancelled"));
  CHECK(contains(text, "dem.level1.ply"));
}

TEST_CASE("by the surface metric both reports list what breaks the sphere criterion") {
  TerrainReport report = sample();
  report.in_space = {12.5, 40.25, 7, 2, {{{1, 2}, {3, 4}, KeptBy::angle}, {{}, {}, KeptBy::shape}}};
  auto json = nlohmann::json::parse(to_json(report));
  CHECK(json["in_space"] ==
        nlohmann::json({{"min_angle_deg", 12.5}, {"mean_min_angle_deg", 40.25}}));
  report.metric = "surface";
  json = nlohmann::json::parse(to_json(report));
  CHECK(json["in_space"]["tame"] == 7);
  CHECK(json["in_space"]["kept_edges"].size() == 2);
  CHECK(json["in_space"]["kept_edges"][0]["to"] == nlohmann::json({3.0, 4.0}));
  CHECK(json["in_space"]["kept_edges"][0]["kept_by"] == to_string(KeptBy::angle));
  const std::string text = to_text(report);
  CHECK(contains(text, "7, 2"));
  CHECK(contains(text, "1 " + to_string(KeptBy::angle)));
  CHECK(contains(text, "mean of the smallest 40.25"));
}

TEST_CASE("the histogram counts each triangle once, by its smallest angle") {
  const AngleHistogram square = angle_histogram(test::square());  // two triangles of 45 degrees
  CHECK(square[8] + square[9] == 2);
  const AngleHistogram hexagon = angle_histogram(test::hexagon());  // six of 60, up to rounding
  CHECK(hexagon[11] == 6);
}

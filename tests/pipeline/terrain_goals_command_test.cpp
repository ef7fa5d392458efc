// lepp terrain: what can be asked for besides an error.

#include <doctest/doctest.h>

#include "pipeline/obj_tin.hpp"
#include "support/real_inputs.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("levels are nested, each with its error, each in a file and a picture of its own") {
  const ScratchFolder folder;
  const HeightGrid grid = hill_grid();
  for (const std::string by : {"lepp", "greedy"}) {
    CAPTURE(by);
    const Outcome made =
        run(folder.path(), "terrain " + hill() +
                               " -o t.obj --force --max-error 2 --levels 20,8 "
                               "--picture t.png --picture-width 60 --json - --by " +
                               by);
    REQUIRE(made.status == 0);
    const Json report = Json::parse(made.out);
    REQUIRE(report["levels"].size() == 2);
    const ObjTin levels[] = {read_obj(folder / "t.level1.obj"), read_obj(folder / "t.level2.obj"),
                             read_obj(folder / "t.obj")};
    const double errors[] = {20, 8, 2};
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(measured(levels[i], grid).error <= errors[i] + 1e-9);
      if (i < 2) CHECK(report["levels"][i]["vertices"] == levels[i].vertices.size());
      if (i == 0) continue;
      const std::set<Place> finer(levels[i].vertices.begin(), levels[i].vertices.end());
      for (const Place& v : levels[i - 1].vertices) CHECK(finer.contains(v));
    }
    for (const char* picture : {"t.png", "t.level1.png", "t.level2.png"}) {
      CHECK(content_of(folder / picture).starts_with("\x89PNG"));
    }
  }
}

TEST_CASE("--nonobtuse: the file is admissible, and the error is kept") {
  const ScratchFolder folder;
  const Outcome made =
      run(folder.path(), "terrain " + hill() + " -o t.msh --max-error 3 --nonobtuse --json -");
  REQUIRE(made.status == 0);
  const Json report = Json::parse(made.out);
  CHECK(report["admissible"] == true);
  CHECK(report["obtuse_constrained"] == 0);
  CHECK(report["error"]["max"] <= 3 + 1e-9);
  const Outcome checked =
      run(folder.path(), "check t.msh --nonobtuse --admissible --delaunay --min-angle 30");
  CHECK(checked.status == 0);
  CHECK(has(checked.out, "read in plan, without its heights"));
}

TEST_CASE("heights of more digits than floats hold are kept: whole, in tiles, in both modes") {
  const ScratchFolder folder;
  std::string text = "ncols 25\nnrows 21\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 25 * 21; ++i) {  // 1e6 + k * 1e-6
    const int k =
        static_cast<int>(std::lround(20 * std::sin(i % 25 * 0.4) * std::cos(i / 25 * 0.3)));
    text += std::to_string(k < 0 ? 999999 : 1000000) + "." +
            std::to_string(1000000 + (k < 0 ? 1000000 + k : k)).substr(1) + "\n";
  }
  folder.put("fine.asc", text);
  const HeightGrid grid = read_height_grid(folder / "fine.asc");
  const double ulp = 0x1p-33;  // of a million
  for (const std::string by : {"lepp", "greedy"}) {
    for (const std::string tiles : {"", " --tiles 2x2 --tile-output mesh"}) {
      for (const std::string error : {"0", "1e-6", "5e-6"}) {
        CAPTURE(by + tiles + " " + error);
        const Outcome made = run(folder.path(), "terrain fine.asc -o t.obj --force --json - --by " +
                                                    by + " --max-error " + error + tiles);
        REQUIRE(made.status == 0);
        const Json report = Json::parse(made.out);
        CHECK(report["warnings"].empty());
        CHECK(report["error"]["max"] <= std::stod(error) * (1 + 1e-9) + 4 * ulp);
        const Found found = measured(read_obj(folder / "t.obj"), grid);
        CHECK(found.outside == 0);
        CHECK(std::abs(found.error - report["error"]["max"].get<double>()) <= 4 * ulp);
      }
    }
  }
}

TEST_CASE("the surface metric keeps the error, and lists what breaks its criterion") {
  const ScratchFolder folder;
  const HeightGrid grid = hill_grid();
  for (const std::string effort : {"fast", "normal"}) {
    CAPTURE(effort);
    const Outcome made = run(
        folder.path(), "terrain " + hill() + " -o t.obj --force --json - --max-error 2 --metric " +
                           "surface --effort " + effort);
    REQUIRE(made.status == 0);
    const Json report = Json::parse(made.out);
    CHECK(report["valid"] == true);
    CHECK(measured(read_obj(folder / "t.obj"), grid).error <= 2 + 1e-9);
    CHECK(report["min_angle_deg"] >= 15 - 1e-9);
    CHECK(report["in_space"]["plan_angle_deg"] == 15);
    CHECK(report["in_space"]["mean_min_angle_deg"] > 30);
    for (const Json& edge : report["in_space"]["kept_edges"]) CHECK(edge.contains("kept_by"));
    CHECK(has(made.err, "edges against the sphere rule"));
  }
}

TEST_CASE("levels without room for the outline or for angles are warned of and counted") {
  const ScratchFolder folder;
  std::string text = "ncols 25\nnrows 6\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 25 * 6; ++i) {
    text += std::to_string(20 * std::sin(i % 25 * 0.31 + 2) * std::cos(i / 25 * 0.23)) + "\n";
  }
  folder.put("dem.asc", text);
  const Outcome made = run(folder.path(),
                           "terrain dem.asc -o t.obj --max-vertices 150 --level-vertices 3,6,60 "
                           "--json -");
  REQUIRE(made.status == 0);
  const Json report = Json::parse(made.out);
  CHECK(report["levels"][0]["vertices"] == 4);
  CHECK(has(made.err,
            "warning: level 1: the outline and lines alone have 4 vertices, more than "
            "the 3 asked for"));
  const Json& level = report["levels"][1];
  CHECK(level["min_angle_deg"] < 30);
  CHECK(level["below_bound"]["budget"] > 0);
  CHECK(has(made.err,
            "warning: level 2: 4 triangles are below 30 degrees, the smallest angle is "
            "22.61: 6 vertices leave no room"));
  CHECK(report["min_angle_deg"] >= 30 - 1e-9);
  CHECK(report["goal_reached"] == true);
}

TEST_CASE("the DEM of the paper: errors of one nested sequence at 4, 43, 275 and 937 vertices") {
  const auto file = real_input("dem/ashby.stm");
  if (!file) return;
  const ScratchFolder folder;
  const Outcome made = run(folder.path(), "terrain " + quoted(*file) +
                                              " -o t.ele --max-vertices 937 "
                                              "--level-vertices 4,43,275 --json - -q");
  CHECK(made.status == 0);
  const Json report = Json::parse(made.out);
  const double published[] = {372.65, 135.7, 59.0, 31.1};
  const std::size_t counts[] = {4, 43, 275, 937};
  REQUIRE(report["levels"].size() == 3);
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& level = i < 3 ? report["levels"][i] : report;
    CHECK(level["vertices"] <= counts[i]);
    CHECK(level["error"]["max"] <= published[i] + 0.05);
  }
}

TEST_CASE("--fit-heights: the same places, the bound kept, a smaller root mean square") {
  const ScratchFolder folder;
  const HeightGrid grid = hill_grid();
  const std::string rest = " --max-error 4 --levels 20 --json - -o ";
  const Outcome made = run(folder.path(), "terrain " + hill() + rest + "plain.obj");
  const Outcome fitted =
      run(folder.path(), "terrain " + hill() + " --fit-heights" + rest + "fitted.obj");
  REQUIRE(made.status == 0);
  REQUIRE(fitted.status == 0);
  const Json before = Json::parse(made.out), after = Json::parse(fitted.out);
  CHECK(after["vertices"] == before["vertices"]);
  CHECK(before["unfitted_error"].is_null());
  CHECK(after["unfitted_error"]["rms"] == before["error"]["rms"]);
  CHECK(after["error"]["rms"] < 0.95 * before["error"]["rms"].get<double>());
  CHECK(after["levels"][0]["error"]["rms"] < before["levels"][0]["error"]["rms"]);
  CHECK(measured(read_obj(folder / "fitted.obj"), grid).error <= 4 + 1e-9);
  CHECK(run(folder.path(), "terrain " + hill() + " --fit-heights --metric surface" + rest + "x.obj")
            .status == 1);
}

TEST_CASE("--fit-heights: tiles keep the heights of their borders") {
  const ScratchFolder folder;
  const HeightGrid grid = hill_grid();
  const Outcome made = run(folder.path(), "terrain " + hill() +
                                              " -o t.obj --max-error 3 --tiles 2x2 --tile-output "
                                              "both --fit-heights --json -");
  REQUIRE(made.status == 0);
  const Json report = Json::parse(made.out);
  CHECK(report["error"]["rms"] < report["unfitted_error"]["rms"]);
  const double middle = grid.origin.x + 29 * grid.step_x;
  for (const std::string row : {"0", "1"}) {
    const auto west = on_line(read_obj(folder / ("t_" + row + "_0.obj")), 0, middle);
    CHECK(west.size() > 5);
    CHECK(west == on_line(read_obj(folder / ("t_" + row + "_1.obj")), 0, middle));
  }
  CHECK(measured(read_obj(folder / "t.obj"), grid).error <= 3 + 1e-9);
}

TEST_CASE("--prefix-errors: the TIN of so many vertices has the error that was listed") {
  const ScratchFolder folder;
  const HeightGrid grid = hill_grid();
  const std::string start = "terrain " + hill() + " --by greedy --force --json - -o t.obj ";
  const Outcome made = run(folder.path(), start + "--max-error 5 --prefix-errors");
  REQUIRE(made.status == 0);
  const Json report = Json::parse(made.out);
  const std::size_t first = report["prefixes"]["first"], whole = report["vertices"];
  const std::vector<double> errors = report["prefixes"]["max_errors"];
  REQUIRE(errors.size() == whole - first + 1);
  CHECK(errors.back() == report["error"]["max"]);
  for (const std::size_t vertices : {first + 1, (first + whole) / 2, whole - 1}) {
    CAPTURE(vertices);
    const Outcome part = run(folder.path(), start + "--max-vertices " + std::to_string(vertices));
    REQUIRE(part.status == 0);
    CHECK(Json::parse(part.out)["prefixes"].is_null());
    const ObjTin tin = read_obj(folder / "t.obj");
    CHECK(tin.vertices.size() == vertices);
    CHECK(measured(tin, grid).error == doctest::Approx(errors[vertices - first]).epsilon(1e-9));
  }
}

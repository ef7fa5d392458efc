// lepp terrain: tiles, windows, and grids cut apart.

#include <doctest/doctest.h>

#include "pipeline/obj_tin.hpp"
#include "support/real_inputs.hpp"

using namespace lepp;
using namespace lepp::test;
namespace fs = std::filesystem;

TEST_CASE("tiles share the vertices of their borders, and join without a gap") {
  const ScratchFolder folder;
  const HeightGrid grid = hill_grid();
  for (const std::string by : {"lepp", "greedy"}) {
    CAPTURE(by);
    const Outcome made =
        run(folder.path(), "terrain " + hill() +
                               " -o t.obj --force --max-error 3 "
                               "--tiles 2x2 --tile-output both --levels 12 --json - --by " +
                               by);
    REQUIRE(made.status == 0);
    const Json report = Json::parse(made.out);
    CHECK(report["tiles"].size() == 4);
    CHECK(report["valid"] == true);
    const double middle = grid.origin.x + 29 * grid.step_x;  // 59 columns of cells in two
    for (const std::string row : {"0", "1"}) {
      const auto west = on_line(read_obj(folder / ("t_" + row + "_0.obj")), 0, middle);
      CHECK(west.size() > 5);
      CHECK(west == on_line(read_obj(folder / ("t_" + row + "_1.obj")), 0, middle));
      CHECK(west == on_line(read_obj(folder / ("t_" + row + "_1.level1.obj")), 0, middle));
    }
    const ObjTin joined = read_obj(folder / "t.obj");
    const Found found = measured(joined, grid);
    CHECK(found.error <= 3 + 1e-9);
    CHECK(found.outside == 0);
    CHECK(found.covered == 0);
    CHECK(report["vertices"] == joined.vertices.size());
    CHECK(std::set<Place>(joined.vertices.begin(), joined.vertices.end()).size() ==
          joined.vertices.size());
  }
}

// A .f32 file without georeference: waves, and a height of one's own choice.
void put_f32(const ScratchFolder& folder, std::uint32_t columns, std::uint32_t rows,
             std::optional<std::pair<std::uint32_t, float>> odd = {}) {
  std::ofstream out(folder / "dem.f32", std::ios::binary);
  out << "F32 " << columns << ' ' << rows << " -9999\n";
  for (std::uint32_t i = 0; i < columns * rows; ++i) {
    const double x = i % columns, y = i / columns;
    auto height = static_cast<float>(50 * std::sin(x / 5) * std::cos(y / 7));
    if (odd && odd->first == i) height = odd->second;
    out.write(reinterpret_cast<const char*>(&height), sizeof height);
  }
}

std::set<std::string> names_of(const Json& list) {
  std::set<std::string> names;
  for (const Json& one : list) names.insert(one["name"]);
  return names;
}

TEST_CASE(
    "tiles join level by level, each level within its error and with a picture of the whole") {
  const ScratchFolder folder;
  const HeightGrid grid = hill_grid();
  for (const std::string output : {"mesh", "both"}) {
    CAPTURE(output);
    const Outcome made = run(folder.path(), "terrain " + hill() +
                                                " -o t.obj --force --max-error 3 --levels 120,30,8 "
                                                "--tiles 2x3 --picture t.svg --json - "
                                                "--tile-output " +
                                                output);
    REQUIRE(made.status == 0);
    const Json report = Json::parse(made.out);
    CHECK(report["asked_for"]["tiles"] == Json({2, 3}));
    CHECK(report["columns"] == 60);
    REQUIRE(report["levels"].size() == 3);
    const double errors[] = {120, 30, 8};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name = "t.level" + std::to_string(i + 1);
      const ObjTin joined = read_obj(folder / (name + ".obj"));
      const Found found = measured(joined, grid);
      CHECK(found.error <= errors[i] + 1e-9);
      CHECK(found.outside == 0);
      CHECK(found.covered == 0);
      CHECK(report["levels"][i]["output"] == name + ".obj");
      CHECK(report["levels"][i]["vertices"] == joined.vertices.size());
      CHECK(report["levels"][i]["triangles"] == joined.triangles.size());
      CHECK(report["levels"][i]["error"]["max"] == doctest::Approx(found.error).epsilon(1e-9));
      CHECK(std::set<Place>(joined.vertices.begin(), joined.vertices.end()).size() ==
            joined.vertices.size());
      CHECK(has(content_of(folder / (name + ".svg")), "<path"));
      CHECK(fs::exists(folder / ("t_1_2.level" + std::to_string(i + 1) + ".obj")) ==
            (output == "both"));
    }
    CHECK(has(content_of(folder / "t.svg"), "<path"));
    CHECK(fs::exists(folder / "t_1_2.obj") == (output == "both"));
    CHECK(fs::exists(folder / "t_1_2.level2.svg") == (output == "both"));
  }
}

TEST_CASE("the joined mesh has the groups of the whole, and passes as one mesh") {
  const ScratchFolder folder;
  REQUIRE(run(folder.path(),
              "terrain " + hill() + " -o t.msh -q --max-error 3 --tiles 2x2 --tile-output mesh")
              .status == 0);
  const Outcome checked = run(folder.path(), "check t.msh --json - -q");
  CHECK(checked.status == 0);
  const Json report = Json::parse(checked.out);
  CHECK(group_measures(report).count({1, "outline"}) == 1);
  CHECK(group_measures(report).count({2, "terrain"}) == 1);
  REQUIRE(run(folder.path(), "terrain " + hill() + " -o w.msh -q --max-error 3").status == 0);
  const Json whole = Json::parse(run(folder.path(), "check w.msh --json - -q").out);
  // Tiles fill the notches of their own outline alone.
  for (const auto& [group, measure] : group_measures(whole))
    CHECK(group_measures(report)[group] == doctest::Approx(measure).epsilon(0.003));
}

TEST_CASE("a tile that fails ends the run: the report lists it and why, the ones before stay") {
  const ScratchFolder folder;
  put_f32(folder, 40, 31, std::pair(40 * 20 + 7, INFINITY));
  const std::string command = "terrain dem.f32 -o t.obj -q --json r.json --tiles 3x1 ";
  const Outcome made = run(folder.path(), command + "--max-error 2");
  CHECK(made.status == 2);
  CHECK(has(made.err, "infinite"));
  const Json report = Json::parse(content_of(folder / "r.json"));
  CHECK(names_of(report["tiles"]) == std::set<std::string>{"tile 0 0", "tile 1 0"});
  CHECK(report["tiles"][0]["problem"].is_null());
  CHECK(report["tiles"][0]["output"] == "t_0_0.obj");
  CHECK(has(report["tiles"][1]["problem"], "column 7, row 20: the height is infinite"));
  CHECK(report["tiles"][1]["output"] == "");
  CHECK(report["goal_reached"] == false);
  CHECK(report["error_kept"] == false);
  CHECK(folder.names() == std::set<std::string>{"dem.f32", "r.json", "t_0_0.obj"});
  // Percentages are of the range of all heights, which is looked for first.
  fs::remove(folder / "t_0_0.obj");
  fs::remove(folder / "r.json");
  CHECK(run(folder.path(), command + "--max-error 2%").status == 2);
  CHECK(folder.names() == std::set<std::string>{"dem.f32", "r.json"});
  const Json early = Json::parse(content_of(folder / "r.json"));
  CHECK(early["tiles"].empty());
  CHECK(early["goal_reached"] == false);
  CHECK(early["error_kept"] == false);
  CHECK(early["asked_for"]["tiles"] == Json({3, 1}));
  CHECK(has(early["warnings"].dump(), "no tile was begun: "));
  CHECK(has(early["warnings"].dump(), "column 7, row 20: the height is infinite"));
}

TEST_CASE("pictures of tiles go by the heights of all: they match as pictures of the whole would") {
  const ScratchFolder folder;
  put_f32(folder, 20, 11, std::pair(20 * 10 + 19, 1000.0F));
  const std::string window = "terrain dem.f32 -q --max-error 2 -o ";
  REQUIRE(run(folder.path(), window + "t.obj --tiles 1x2 --picture t.svg --json r.json").status ==
          0);
  CHECK(Json::parse(content_of(folder / "r.json"))["heights"][1] == 1000);
  put_f32(folder, 20, 11);
  REQUIRE(run(folder.path(), window + "u.obj --tiles 1x2 --picture u.svg").status == 0);
  CHECK(content_of(folder / "t_0_0.obj") == content_of(folder / "u_0_0.obj"));
  CHECK(content_of(folder / "t_0_0.svg") != content_of(folder / "u_0_0.svg"));
}

TEST_CASE("a usage error that is found by the range of heights leaves no report") {
  const ScratchFolder folder;
  put_f32(folder, 20, 11);
  CHECK(run(folder.path(),
            "terrain dem.f32 -q --tiles 1x2 -o t.obj --max-error 5% --levels 5% "
            "--json r.json")
            .status == 1);
  CHECK(folder.names() == std::set<std::string>{"dem.f32"});
}

TEST_CASE("percentages are of the range of the whole raster, also where a tile fails") {
  const ScratchFolder folder;
  put_f32(folder, 40, 31, std::pair(40 * 30 + 39, 1000.0F));
  fs::create_symlink("nowhere/t.obj", folder / "t_1_0.obj");
  const Outcome made =
      run(folder.path(),
          "terrain dem.f32 -o t.obj -q --json - --tiles 3x1 --max-error 1% --border-error 0.5%");
  CHECK(made.status == 5);
  const Json report = Json::parse(made.out);
  const double low = report["heights"][0];
  CHECK(report["heights"][1] == 1000);
  CHECK(report["asked_for"]["max_error"] == doctest::Approx(0.01 * (1000 - low)).epsilon(1e-9));
  CHECK(report["asked_for"]["border_error"] == doctest::Approx(0.005 * (1000 - low)));
  REQUIRE(report["tiles"].size() == 2);
  CHECK(has(report["tiles"][1]["problem"], "t_1_0.obj"));
}

TEST_CASE("an interrupted run leaves whole tiles, and its report says how far it got") {
  const std::string program = "\"" + std::string(LEPP_PROGRAM) + "\"";
  for (const std::string signal : {"INT", "TERM"}) {
    CAPTURE(signal);
    const ScratchFolder folder;
    put_f32(folder, 120, 61);
    // The second tile goes into a pipe that does not hold all of it. Once the pipe is open, the
    // first tile is done; the rest is read after the signal.
    const Outcome made =
        run(folder.path(),
            "-c 'mkfifo t_1_0.obj; " + program +
                " terrain dem.f32 -o t.obj -q --json r.json --max-error 0 --by greedy "
                "--tiles 3x1 --force & exec 3< t_1_0.obj; kill -" +
                signal + " $!; cat <&3 > seen; wait $!'",
            "/bin/sh");
    CHECK(made.status == 4);
    CHECK(has(made.err, "cancelled; nothing more was written; the tiles that are done stay"));
    CHECK(folder.names() ==
          std::set<std::string>{"dem.f32", "r.json", "seen", "t_0_0.obj", "t_1_0.obj"});
    CHECK(read_obj(folder / "t_0_0.obj").triangles.size() > 10);
    CHECK(fs::file_size(folder / "seen") > 1 << 16);
    const Json report = Json::parse(content_of(folder / "r.json"));
    CHECK(names_of(report["tiles"]) == std::set<std::string>{"tile 0 0", "tile 1 0"});
    CHECK(report["asked_for"]["tiles"] == Json({3, 1}));
    CHECK(report["goal_reached"] == false);
    CHECK(report["error_kept"] == false);
  }
}

TEST_CASE("whatever a run will write is looked at before the first tile is made") {
  const std::string crs = R"(PROJCS["made up",GEOGCS["g",DATUM["d",SPHEROID["s",6378137,298]]]])";
  const std::string command = "terrain dem.asc -q --max-error 5 --tiles 2x2 --levels 20 ";
  const std::pair<const char*, const char*> taken[] = {
      {"t_1_1.prj", "-o t.obj"},
      {"t_1_1.level1.prj", "-o t.obj"},
      {"t_0_1.level1.poly", "-o t.ele"},
      {"t_1_0.node", "-o t.ele"},
      {"t.level1.node", "-o t.ele --tile-output both"},
      {"t.prj", "-o t.obj --tile-output mesh"},
      {"p_0_1.level1.png", "-o t.obj --picture p.png"},
      {"p.level1.svg", "-o t.obj --picture p.svg --tile-output mesh"}};
  for (const auto& [name, options] : taken) {
    CAPTURE(name);
    const ScratchFolder folder;
    fs::copy(fs::path(LEPP_MESHES) / "terrain" / "hill.asc", folder / "dem.asc");
    folder.put("dem.prj", crs);
    folder.put(name, "taken");
    const Outcome made = run(folder.path(), command + options);
    CHECK(made.status == 5);
    CHECK(has(made.err, std::string(name) + "\n      exists already"));
    CHECK(folder.names() == std::set<std::string>{"dem.asc", "dem.prj", name});
    CHECK(run(folder.path(), command + "--force " + options).status == 0);
    CHECK(folder.text(name) != "taken");
    CHECK(folder.text("dem.prj") == crs);
  }
}

TEST_CASE("no file beside an input is replaced, and no two outputs are one file") {
  const std::string crs = R"(PROJCS["made up",GEOGCS["g",DATUM["d",SPHEROID["s",6378137,298]]]])";
  const ScratchFolder folder;
  fs::copy(fs::path(LEPP_MESHES) / "terrain" / "hill.asc", folder / "dem.asc");
  folder.put("dem.prj", crs + "\n\n");
  folder.put("lines.json", R"({"type": "LineString", "coordinates": [[431500, 5103700],
                               [432200, 5104000]]})");
  folder.put("lines.prj", "another");
  const std::string command = "terrain dem.asc -q --force --max-error 20 ";
  // The grid's own .prj says what the TIN's would say: it serves both.
  CHECK(run(folder.path(), "terrain dem.asc -q --max-error 20 -o dem.obj").status == 0);
  CHECK(folder.text("dem.prj") == crs + "\n\n");
  const Outcome other = run(folder.path(), command + "-o lines.obj --breaklines lines.json");
  CHECK(other.status == 5);
  CHECK(has(other.err, "lines.prj\n      is also the input"));
  CHECK(run(folder.path(), command + "-o a.obj --json dem.prj").status == 5);
  CHECK(run(folder.path(), command + "-o a.obj --json a.prj").status == 5);
  CHECK(run(folder.path(), command + "-o a.ele --json a.node").status == 5);
  CHECK(run(folder.path(), command + "-o a.obj --levels 50 --json a.level1.prj").status == 5);
  fs::create_directory(folder / "c.level1.prj");
  const Outcome folder_there = run(folder.path(), command + "-o c.obj --levels 50");
  CHECK(folder_there.status == 5);
  CHECK(has(folder_there.err, "c.level1.prj\n      is a folder"));
  fs::create_symlink("a.obj", folder / "b.png");
  folder.put("a.obj", "old");
  const Outcome twice = run(folder.path(), command + "-o a.obj --picture b.png");
  CHECK(twice.status == 5);
  CHECK(has(twice.err, "is named for two outputs"));
  CHECK(folder.text("a.obj") == "old");
  CHECK(folder.text("dem.prj") == crs + "\n\n");
  CHECK(folder.text("lines.prj") == "another");
}

TEST_CASE("a .prj beside a mesh that has no coordinate system is warned of") {
  const std::string crs = R"(PROJCS["made up",GEOGCS["g",DATUM["d",SPHEROID["s",6378137,298]]]])";
  const ScratchFolder folder;
  fs::copy(fs::path(LEPP_MESHES) / "terrain" / "hill.asc", folder / "dem.asc");
  folder.put("dem.prj", crs);
  const auto warnings = [&](const std::string& options) {
    const Outcome made =
        run(folder.path(), "terrain dem.asc --max-error 20 --force --json - " + options);
    REQUIRE(made.status == 0);
    return Json::parse(made.out)["warnings"].dump();
  };
  CHECK_FALSE(has(warnings("-o a.obj"), "a.prj"));
  CHECK(has(warnings("-o a.obj --origin 431000 5103000"), "a.prj stands beside a mesh without"));
  CHECK_FALSE(has(warnings("-o b.obj --origin 431000 5103000"), "stands beside"));
  CHECK_FALSE(has(warnings("-o a.nc --origin 431000 5103000"), "stands beside"));
  fs::remove(folder / "dem.prj");
  folder.put("a_0_1.prj", crs);
  CHECK(has(warnings("-o a.obj --tiles 1x2"), "a_0_1.prj stands beside"));
  CHECK(folder.text("a.prj") == crs + "\n");
}

#ifdef LEPP_HAS_GDAL
TEST_CASE("a .prj beside a GeoTIFF is no input of it: it knows its own system") {
  const auto real = real_input("dem/lux_elev.tif");
  if (!real) return;
  const ScratchFolder folder;
  fs::copy(*real, folder / "dem.tif");
  folder.put("dem.prj", "of an earlier dem.tif");
  const std::string command = "terrain dem.tif -q --max-error 20% -o dem.ply ";
  const Outcome kept = run(folder.path(), command);
  CHECK(kept.status == 5);
  CHECK(has(kept.err, "dem.prj\n      exists already"));
  CHECK(run(folder.path(), command + "--force").status == 0);
  CHECK(has(folder.text("dem.prj"), "WGS 84"));
  // Beside lines, which GDAL reads by it, it is one.
  folder.put("other.json", R"({"type": "LineString", "coordinates": [[5.9, 49.6], [6.2, 49.8]]})");
  folder.put("other.prj", "of lines");
  CHECK(run(folder.path(),
            "terrain dem.tif -q --max-error 20% -o other.ply --force "
            "--breaklines other.json")
            .status == 5);
}
#endif

TEST_CASE("cells in another unit than metres are warned of where heights are compared with them") {
  const std::string system = R"(PROJCS["p",GEOGCS["g",DATUM["d",SPHEROID["s",6378137,298]]],UNIT[)";
  const std::string kilometres = system + R"("kilometre",1000]])";
  const std::string metres = system + R"("metre",1]])";
  const std::string feet_up = ",VERT_CS[\"v\",UNIT[\"foot\",0.3048]]]";
  const auto warnings = [](const std::string& crs, const std::string& options) {
    const ScratchFolder folder;
    fs::copy(fs::path(LEPP_MESHES) / "terrain" / "hill.asc", folder / "dem.asc");
    folder.put("dem.prj", crs);
    const Outcome made =
        run(folder.path(), "terrain dem.asc -o a.obj --max-error 20% --json - " + options);
    REQUIRE(made.status == 0);
    return Json::parse(made.out)["warnings"].dump();
  };
  CHECK(has(warnings(kilometres, "--picture a.svg"), "cells are measured in km"));
  CHECK(has(warnings(kilometres, "--metric surface"), "heights are taken in the same unit; if"));
  CHECK(has(warnings(kilometres, "--picture a.svg --tiles 1x2"), "cells are measured in km"));
  CHECK(has(
      warnings("COMPD_CS[\"c\"," + metres + feet_up, "--picture a.svg"),
      "cells are measured in m and heights are taken in the same unit, though the file says ft"));
  CHECK_FALSE(has(warnings(kilometres, ""), "same unit"));  // the plane knows no heights
  CHECK_FALSE(has(warnings(kilometres, "--picture a.svg --cell 30000 30000"), "same unit"));
  CHECK_FALSE(has(warnings(metres, "--picture a.svg"), "same unit"));
}

TEST_CASE("a tiling of one tile is one, too") {
  const ScratchFolder folder;
  const Outcome made = run(folder.path(), "terrain " + hill() +
                                              " -o t.obj --max-error 8 --tiles 1x1 "
                                              "--tile-output both --json -");
  REQUIRE(made.status == 0);
  CHECK(Json::parse(made.out)["tiles"].size() == 1);
  CHECK(read_obj(folder / "t_0_0.obj").vertices.size() ==
        read_obj(folder / "t.obj").vertices.size());
}

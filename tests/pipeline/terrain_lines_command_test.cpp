// lepp terrain: clip polygons, breaklines, and other files that it reads.

#include <doctest/doctest.h>

#include "pipeline/obj_tin.hpp"

using namespace lepp;
using namespace lepp::test;
namespace fs = std::filesystem;

TEST_CASE("clip polygons cut, and breaklines are edges with their own heights") {
  const ScratchFolder folder;
  folder.put("clip.geojson",
             R"({"type": "Polygon", "coordinates": [[[431400, 5103600], [432300, 5103600],
                [432300, 5104100], [431400, 5104100], [431400, 5103600]]]})");
  folder.put("dyke.geojson", R"({"type": "LineString", "coordinates":
                [[431500, 5103700, 800], [432200, 5104000, 800]]})");
  const Outcome made = run(folder.path(), "terrain " + hill() +
                                              " -o t.obj --max-error 5 -q --clip "
                                              "clip.geojson --soft-breaklines dyke.geojson");
  CHECK(made.status == 0);
  const ObjTin soft = read_obj(folder / "t.obj");
  for (const Place& v : soft.vertices) {
    CHECK(v[0] >= 431400);
    CHECK(v[1] <= 5104100);
    CHECK(v[2] < 800);
  }
  const Outcome hard = run(folder.path(), "terrain " + hill() +
                                              " -o h.obj --max-error 5 --clip "
                                              "clip.geojson --breaklines dyke.geojson");
  CAPTURE(hard.out);
  CHECK(hard.status == 0);
  CHECK(has(hard.out, "samples lost, nodata covered      0, 0"));
  const ObjTin dyke = read_obj(folder / "h.obj");
  CHECK(std::ranges::count_if(dyke.vertices, [](const Place& v) { return v[2] == 800; }) >= 2);
}

TEST_CASE("a clip polygon without area is named with its file") {
  const ScratchFolder folder;
  folder.put("c.geojson", R"({"type": "Polygon", "coordinates": [[[431400, 5103600],
                             [432300, 5103600], [431400, 5103600]]]})");
  const Outcome made =
      run(folder.path(), "terrain " + hill() + " -o t.obj --max-error 5 --clip c.geojson");
  CHECK(made.status == 2);
  CHECK(has(made.err, "c.geojson, "));
  CHECK(has(made.err, "ring 1"));
}

TEST_CASE(
    "samples on hard breaklines are off by what was asked for: counted, told, and no failure") {
  const ScratchFolder folder;
  std::string grid = "ncols 15\nnrows 15\nxllcenter 0\nyllcenter 0\ncellsize 1\n";
  for (int row = 0; row < 15; ++row) grid += "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
  folder.put("flat.asc", grid);
  folder.put("wall.json", R"({"type": "LineString", "coordinates": [[0, 9, -6], [12, 9, 0]]})");
  const std::string command = "terrain flat.asc --max-error 1 --breaklines wall.json ";
  for (const std::string by : {"--by greedy", "--by lepp", "--nonobtuse", "--metric surface"}) {
    CAPTURE(by);
    const Outcome made = run(folder.path(), command + by + " -o t.obj --json t.json --force");
    CAPTURE(made.out);
    CHECK(made.status == 0);
    CHECK(has(made.out, "error kept                        yes"));
    CHECK(has(made.out, "13 samples, off by up to 6; elsewhere "));
    CHECK(has(made.out,
              "warning: 10 of 13 samples on breaklines with heights of their own are off "
              "by more than the error asked for, by up to 6;"));
    const auto error = Json::parse(content_of(folder / "t.json"))["error"];
    CHECK(error["max"] == 6);
    CHECK(error["on_hard_lines"]["samples"] == 13);
    CHECK(error["on_hard_lines"]["max"] == 6);
    CHECK(error["on_hard_lines"]["max_elsewhere"] <= 1 + 1e-9);
  }
  const Outcome soft = run(folder.path(),
                           "terrain flat.asc --max-error 1 --soft-breaklines "
                           "wall.json -o s.obj");
  CHECK(soft.status == 0);
  CHECK(!has(soft.out, "hard"));
}

TEST_CASE("clip polygons and breaklines are inputs: nothing replaces them, --force or not") {
  const ScratchFolder folder;
  const std::string lines = R"({"type": "Polygon", "coordinates": [[[431400, 5103600],
                            [432300, 5103600], [432300, 5104100], [431400, 5103600]]]})";
  for (const std::string option : {"--clip", "--breaklines", "--soft-breaklines"}) {
    CAPTURE(option);
    folder.put("lines.json", lines);
    const std::string start = "terrain " + hill() + " -q --force --max-error 5 " + option;
    CHECK(run(folder.path(), start + " lines.json -o t.obj --json lines.json").status == 5);
    folder.put("lines.obj", lines);
    CHECK(run(folder.path(), start + " lines.obj -o lines.obj").status == 5);
    CHECK(content_of(folder / "lines.json") == lines);
    CHECK(content_of(folder / "lines.obj") == lines);
  }
}

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
  const Outcome hard =
      run(folder.path(), "terrain " + hill() +
                             " -o h.obj --max-error 5 --clip clip.geojson --breaklines "
                             "dyke.geojson --allow-unfinished --json -");
  CAPTURE(hard.out);
  const Json report = Json::parse(hard.out);
  CHECK(report["valid"] == true);
  CHECK(hard.status == (report["error"]["max"] <= 5 + 1e-9 ? 0 : 3));
  const ObjTin dyke = read_obj(folder / "h.obj");
  CHECK(std::ranges::count_if(dyke.vertices, [](const Place& v) { return v[2] == 800; }) >= 2);
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

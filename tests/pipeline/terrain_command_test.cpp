// lepp terrain: what users type, what comes out, statuses.

#include <doctest/doctest.h>
#include <spawn.h>
#include <unistd.h>

#include "pipeline/obj_tin.hpp"
#include "support/real_inputs.hpp"

using namespace lepp;
using namespace lepp::test;
namespace fs = std::filesystem;

namespace {

const std::string utm_of_prj =
    R"(PROJCS["made up",GEOGCS["g",DATUM["d",SPHEROID["s",6378137,298]]]])";

}  // namespace

TEST_CASE("lepp terrain: what is missing or does not go together is a usage error") {
  const ScratchFolder folder;
  const std::pair<const char*, const char*> cases[] = {
      {"-o x.obj", "--max-error E, --max-vertices N, or both"},
      {"-o x.tif --max-error 1", "name it .obj"},
      {"-o x.obj --max-error many", "give a height from 0 on, or a percentage"},
      {"-o x.obj --max-error -1", "give a height from 0 on"},
      {"-o x.obj --max-error 1 --by foo", "'foo' is none of lepp, greedy"},
      {"-o x.obj --max-error 1 --min-angle 40", "from 0 to 34"},
      {"-o x.obj --max-error 1 --tiles 2", "ROWSxCOLUMNS"},
      {"-o x.obj --max-error 1 --tiles 0x2", "ROWSxCOLUMNS"},
      {"-o x.obj --max-vertices 100 --tiles 2x2", "needs --max-error"},
      {"-o x.obj --max-error 1 --tile-output mesh", "goes with --tiles only"},
      {"-o x.obj --max-error 1 --tiles 2x2 --level-vertices 50", "give --levels"},
      {"-o x.obj --max-error 1 --window 0 0 1 9", "at least two columns and two rows"},
      {"-o x.obj --max-error 1 --window 0 0 9", "--window"},
      {"-o x.obj --max-error 1 --window 0 0 9 -9", "whole number"},
      {"-o x.obj --max-error 1 --window 0 0 9 9 --border-error 1%", "give a height"},
      {"-o x.obj --max-error 1 --tiles 2x2 --nonobtuse", "borders of tiles"},
      {"-o x.obj --max-error 1 --by greedy --nonobtuse", "--by lepp only"},
      {"-o x.obj --max-error 1 --by greedy --min-angle 20", "--by lepp only"},
      {"-o x.obj --max-error 1 --by greedy --effort best", "--by lepp only"},
      {"-o x.obj --max-error 1 --effort much", "'much' is none of fast, normal, best"},
      {"-o x.obj --max-error 1 --levels 5,10", "must be errors that descend"},
      {"-o x.obj --max-error 5 --levels 2", "all above --max-error"},
      {"-o x.obj --max-error 5 --levels 9,5", "all above --max-error"},
      {"-o x.obj --max-error 5% --levels 5%", "all above --max-error"},
      {"-o x.obj --max-vertices 50 --level-vertices 50", "all below --max-vertices"},
      {"-o x.obj --max-error 1 --levels 5 --nonobtuse", "run without levels"},
      {"-o x.obj --max-error 1 --max-vertices 50 --nonobtuse", "give --max-error alone"},
      {"-o x.obj --max-error 1 --border-error 2", "above --max-error"},
      {"-o x.obj --max-error 1 --picture x.gif", "name it .svg or .png"},
      {"-o x.obj --max-error 1 --cell 10", "--cell"},
      {"-o x.obj --max-error 1 --by greedy --prefix-errors", "give --json"},
      {"-o x.obj --max-error 1 --json r.json --prefix-errors", "--by greedy only"},
      {"-o x.obj --max-error 1 --by greedy --fit-heights --json r --prefix-errors", "before"},
      {"-o x.obj --max-error 1 --by greedy --tiles 2x2 --json r --prefix-errors", "--tiles"},
      {"-o x.obj --max-error 1 --format vtk", "--format"},
      {"-o x.obj --max-error 1 --format msh22", "msh22 is of .msh files"},
      {"-o x.slf --max-error 1 --format msh41", "msh41 is of .msh files"},
      {"-o x.msh --max-error 1 --format serafin", "serafin is of .slf files"}};
  for (const auto& [options, message] : cases) {
    CAPTURE(options);
    const Outcome outcome = run(folder.path(), "terrain " + hill() + " " + options);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 1);
    CHECK(has(outcome.err, message));
    CHECK(files_in(folder.path()).empty());
  }
  CHECK(has(run(folder.path(), "terrain --help").out, "lepp terrain dem.tif -o dem.ply"));
}

TEST_CASE("lepp terrain keeps the error that it says, covers all data and nothing else") {
  const ScratchFolder folder;
  const HeightGrid grid = hill_grid();
  for (const std::string by : {"lepp", "greedy"}) {
    for (const double error : {20.0, 5.0, 1.0, 0.0}) {
      CAPTURE(by);
      CAPTURE(error);
      const Outcome made =
          run(folder.path(), "terrain " + hill() + " -o t.obj --force --json - --by " + by +
                                 " --max-error " + std::to_string(error));
      REQUIRE(made.status == 0);
      const Json report = Json::parse(made.out);
      const Found found = measured(read_obj(folder / "t.obj"), grid);
      CHECK(found.error <= error + 1e-9);
      CHECK(report["error"]["max"] == doctest::Approx(found.error).epsilon(1e-9));
      CHECK(found.outside == 0);
      CHECK(found.covered == 0);
      CHECK(report["error"]["samples"] == 1608);
      CHECK(report["error_kept"] == true);
      CHECK(report["valid"] == true);
      if (by == "lepp") CHECK(report["min_angle_deg"].get<double>() >= 30 - 1e-9);
      const std::uint32_t column = report["error"]["column"], row = report["error"]["row"];
      CHECK(grid.has_data(column, row));
    }
  }
}

TEST_CASE("a relative error is one of the range, and the report says what was asked for") {
  const ScratchFolder folder;
  const Outcome made =
      run(folder.path(), "terrain " + hill() + " -o t.ply --max-error 2% --json r.json");
  CHECK(made.status == 0);
  CHECK(has(made.out, "largest error"));
  CHECK(has(made.out, "(asked for: 4.828)"));
  const Json report = Json::parse(content_of(folder / "r.json"));
  CHECK(report["asked_for"]["max_error"] == doctest::Approx(0.02 * (729.6 - 488.2)).epsilon(1e-6));
  CHECK(report["asked_for"]["by"] == "lepp");
  CHECK(report["columns"] == 60);
  CHECK(report["samples"] == 1608);
  CHECK(report["output"] == "t.ply");
  std::size_t triangles = 0;
  for (const std::size_t n : report["smallest_angles"]) triangles += n;
  CHECK(report["triangles"] == triangles);
  for (const char* key : {"read", "domain", "simplify", "measure", "check", "write", "total"}) {
    CHECK(report["seconds"].contains(key));
  }
}

TEST_CASE("--cell leaves coordinates as they are, and says once that angles in them are others") {
  const ScratchFolder folder;
  folder.put("g.asc", "ncols 3\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 1\n1 2 4\n3 9 7\n");
  const std::string warning =
      "warning: lengths and angles are those of cells of 2 x 3, as --cell "
      "says; coordinates stay those of the file, where cells are 1 x 1";
  for (const std::string tiles : {"", " --tiles 1x2 --tile-output both"}) {
    CAPTURE(tiles);
    const std::string start = "terrain g.asc -o t.obj --force --max-error 9" + tiles;
    const Outcome made = run(folder.path(), start + " --cell 2 3");
    REQUIRE(made.status == 0);
    CHECK(read_obj(folder / "t.obj").vertices.size() >= 4);
    for (const Place& v : read_obj(folder / "t.obj").vertices) CHECK(v[0] <= 2);
    const std::size_t at = made.out.find(warning);
    CHECK(at != std::string::npos);
    CHECK(made.out.find(warning, at + 1) == std::string::npos);
    CHECK_FALSE(has(run(folder.path(), start + " --cell 2 2").out, "warning"));
  }
}

TEST_CASE("on flat ground all percentages are one height, and levels are all the same") {
  const ScratchFolder folder;
  folder.put("flat.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n7 7 7\n7 7 7\n");
  const Outcome made =
      run(folder.path(), "terrain flat.asc -o t.obj --max-error 1% --levels 50%,10% --json - -q");
  REQUIRE(made.status == 0);
  const Json report = Json::parse(made.out);
  REQUIRE(report["levels"].size() == 2);
  CHECK(report["levels"][0]["vertices"] == report["vertices"]);
}

TEST_CASE("every format is written, and no file is overwritten without --force") {
  const ScratchFolder folder;
  for (const std::string name : {"a.obj", "b.ply", "c.stl", "d.14", "e.grd", "f.gr3", "g.2dm",
                                 "h.slf", "i.nc", "j.msh", "k.vtu", "l.ele"}) {
    CAPTURE(name);
    const std::string command = "terrain " + hill() + " --max-error 10 -q -o " + name;
    CHECK(run(folder.path(), command).status == 0);
    CHECK(fs::file_size(folder / name) > 500);
    const Outcome again = run(folder.path(), command);
    CHECK(again.status == 5);
    CHECK(has(again.err, "exists already"));
  }
  CHECK(run(folder.path(), "terrain " + hill() + " --max-error 9 -q --force -o a.obj").status == 0);
  CHECK(run(folder.path(), "check l.ele --min-angle 30 --delaunay -q").status == 0);
  const auto taken = folder.put("taken.png", "x");
  CHECK(run(folder.path(), "terrain " + hill() + " --max-error 9 -o n.obj --picture taken.png")
            .status == 5);
  CHECK(folder.text("taken.png") == "x");
}

TEST_CASE("a folder in place of an output is found before any work") {
  const ScratchFolder folder;
  fs::create_directory(folder / "a.stl");
  fs::create_directory(folder / "b.png");
  // Work would find first that the grid is not there.
  for (const char* options : {"-o a.stl --force", "-o a.ply --picture b.png --force"}) {
    CAPTURE(options);
    const Outcome outcome =
        run(folder.path(), "terrain none.asc --max-error 1 " + std::string(options));
    CHECK(outcome.status == 5);
    CHECK(has(outcome.err, "is a folder"));
  }
}

TEST_CASE("a place where nothing can be written is found before any work") {
  const ScratchFolder folder;
  fs::create_directory(folder / "locked");
  fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  std::vector<std::pair<std::string, std::string>> cases = {
      {"-o x.y/a.obj", "x.y/a.obj\n      there is no folder x.y"},
      {"-o a.obj --picture p/a.png", "p/a.png"},
      {"-o a.obj --json j/r.json", "j/r.json"}};
  if (::geteuid() != 0) cases.emplace_back("-o a.obj --json locked/r.json", "may write to");
  for (const auto& [options, message] : cases) {
    CAPTURE(options);
    // Work would find first that the grid is not there.
    const Outcome outcome = run(folder.path(), "terrain none.asc --max-error 1 " + options);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 5);
    CHECK(has(outcome.err, message));
  }
  // With a coordinate system, too, it is the mesh that is named, not its .prj.
  fs::copy(fs::path(LEPP_MESHES) / "terrain" / "hill.asc", folder / "dem.asc");
  folder.put("dem.prj", utm_of_prj);
  CHECK(has(run(folder.path(), "terrain dem.asc -o x/a.obj --max-error 20").err, "x/a.obj\n"));
}

TEST_CASE("kinds of files go by their names in capitals, too") {
  const ScratchFolder folder;
  fs::copy(fs::path(LEPP_MESHES) / "terrain" / "hill.asc", folder / "DEM.ASC");
  for (const std::string name : {"A.OBJ", "B.STL", "C.NC", "D.MSH"}) {
    const Outcome made = run(folder.path(), "terrain DEM.ASC -q --max-error 20 --levels 50 -o " +
                                                name + " --picture " + name + ".SVG");
    CAPTURE(made.err);
    CHECK(made.status == 0);
    CHECK(fs::exists(folder / name));
    CHECK(has(folder.text(name + ".SVG"), "<svg"));
  }
  CHECK(folder.text("A.OBJ").starts_with("# "));
  CHECK(fs::exists(folder / "A.level1.OBJ"));
  CHECK(folder.text("C.NC").starts_with("CDF"));
  CHECK(run(folder.path(), "convert D.MSH -o E.ELE").status == 0);
  CHECK(run(folder.path(), "check E.ELE -q").status == 0);
  CHECK(run(folder.path(), "picture E.ELE -o E.SVG").status == 0);
}

#if !defined(__SANITIZE_ADDRESS__)
TEST_CASE("memory that is not there is said of the grid, and what to do") {
  const ScratchFolder folder;
  folder.put("dem.pgm", "P5\n8000 8000\n255\n");
  fs::resize_file(folder / "dem.pgm", fs::file_size(folder / "dem.pgm") + 64'000'000);
  const Outcome outcome = run(folder.path(), "terrain dem.pgm -o a.obj --max-error 1",
                              "prlimit' --as=150000000 '" LEPP_PROGRAM);
  CAPTURE(outcome.err);
  CHECK(outcome.status == 4);
  CHECK(has(outcome.err, "dem.pgm\n      there is not enough memory"));
  CHECK(has(outcome.err, "--tiles"));
}

TEST_CASE("the peak of memory is that of the program, not of the one that started it") {
  const ScratchFolder folder;
  const std::vector<char> large(std::size_t{128} << 20, 1);
  std::vector<std::string> words = {LEPP_PROGRAM,
                                    "terrain",
                                    LEPP_MESHES "/terrain/hill.asc",
                                    "-o",
                                    folder / "a.obj",
                                    "--max-error",
                                    "20",
                                    "-q",
                                    "--json",
                                    folder / "r.json"};
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  REQUIRE(::posix_spawn(&process, LEPP_PROGRAM, nullptr, nullptr, pointers.data(), environ) == 0);
  int status = -1;
  ::waitpid(process, &status, 0);
  REQUIRE(status == 0);
  const Json report = Json::parse(content_of(folder / "r.json"));
  CHECK(report["peak_memory_bytes"].get<std::size_t>() < large.size() / 2);
}
#endif

TEST_CASE("a number of vertices that is too small for the error is status 3 and writes nothing") {
  const ScratchFolder folder;
  const std::string command = "terrain " + hill() + " -o t.obj --max-vertices 120 ";
  CHECK(run(folder.path(), command + "--max-error 0.5 -q").status == 3);
  CHECK(files_in(folder.path()).empty());
  CHECK(run(folder.path(), command + "--max-error 0.5 -q --allow-unfinished").status == 3);
  CHECK(read_obj(folder / "t.obj").vertices.size() <= 120);
}

TEST_CASE("a number of vertices that the outline alone exceeds is status 3, and says so") {
  const ScratchFolder folder;
  const std::string command = "terrain " + hill() + " -o t.obj --max-vertices 10 ";
  for (const std::string by : {"lepp", "greedy"}) {
    const Outcome made = run(folder.path(), command + "--by " + by);
    CHECK(made.status == 3);
    CHECK(has(made.out + made.err, "the outline and lines alone have"));
    CHECK(files_in(folder.path()).empty());
  }
  CHECK(run(folder.path(), command + "--allow-unfinished").status == 3);
  CHECK(read_obj(folder / "t.obj").vertices.size() > 10);
}

TEST_CASE("cells that world coordinates cannot hold are refused, and --origin is what helps") {
  const ScratchFolder folder;
  std::ofstream(folder / "tiny.asc")
      << "ncols 3\nnrows 3\nxllcorner 500000.25\nyllcorner 4649776.5\n"
         "cellsize 0.00000095367431640625\n1 2 3\n2 7 4\n3 4 5\n";
  const Outcome refused = run(folder.path(), "terrain tiny.asc -o t.obj --max-error 0");
  CHECK(refused.status == 2);
  CHECK(has(refused.err, "--origin 500000 4649776"));
  const Outcome made = run(folder.path(),
                           "terrain tiny.asc -o t.obj --max-error 0 --nonobtuse "
                           "--origin 500000 4649776");
  CHECK(made.status == 0);
  const ObjTin tin = read_obj(folder / "t.obj");
  CHECK(tin.vertices.size() >= 5);
  for (const auto& [x, y, z] : tin.vertices) {  // pixel centres, from half a cell on
    CHECK((x >= 0.25 + 0x1p-21 && x <= 0.25 + 5 * 0x1p-21));
    CHECK((y >= 0.5 + 0x1p-21 && y <= 0.5 + 5 * 0x1p-21));
  }
}

TEST_CASE("--origin goes for lines, too, and takes the coordinate reference system away") {
  const ScratchFolder folder;
  std::ofstream(folder / "a.asc") << "ncols 4\nnrows 4\nxllcorner 1000\nyllcorner 2000\n"
                                     "cellsize 1\n1 2 3 4\n1 2 3 4\n1 2 3 4\n1 2 3 4\n";
  std::ofstream(folder / "a.prj") << "LOCAL_CS[\"here\",UNIT[\"metre\",1]]\n";
  std::ofstream(folder / "c.geojson")
      << R"({"type":"Polygon","coordinates":[[[1000.5,2000.5],[1002.5,2000.5],)"
         R"([1002.5,2003.5],[1000.5,2003.5],[1000.5,2000.5]]]})";
  const Outcome made = run(folder.path(),
                           "terrain a.asc -o t.obj --max-error 0 --origin 1000 2000 "
                           "--clip c.geojson");
  CHECK(made.status == 0);
  for (const auto& [x, y, z] : read_obj(folder / "t.obj").vertices) {
    CHECK((x == 0.5 || x == 2.5));
    CHECK((y == 0.5 || y == 3.5));
  }
  CHECK_FALSE(fs::exists(folder / "t.prj"));
  CHECK(has(made.out + made.err, "coordinates count from (1000, 2000)"));
}

TEST_CASE("grids that cannot be meshed are refused as their folder says") {
  const std::pair<const char*, int> cases[] = {
      {"d01_all_nodata.asc", 2},          {"d05_ragged_row.asc", 2},
      {"d07_cellsize_negative.asc", 2},   {"d09_dims_1e5x1e5.asc", 2},
      {"d11_utm_offset_llcenter.asc", 0}, {"d13_dx_dy.asc", 0},
      {"d15_too_many_values.asc", 2},     {"d17_negative_dims.asc", 2}};
  for (const auto& [name, status] : cases) {
    const auto file = real_input(std::string("nasty/") + name);
    if (!file) continue;
    const ScratchFolder folder;
    CAPTURE(name);
    const Outcome made =
        run(folder.path(), "terrain " + quoted(*file) + " -o t.obj --max-error 1%");
    CAPTURE(made.err);
    CHECK(made.status == status);
    if (status == 0)
      CHECK(measured(read_obj(folder / "t.obj"), read_height_grid(*file)).error < 10);
  }
}

TEST_CASE("heights where none are bring a hint at a value of no data") {
  const ScratchFolder folder;
  folder.put("a.asc",
             "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
             "1 2 -3.4e38\n2 3 4\n");
  const Outcome made = run(folder.path(), "terrain a.asc -o t.obj --max-error 1");
  CHECK(made.status == 0);
  CHECK(has(made.out + made.err, "add --nodata -3.4e+38"));
  const Outcome mended =
      run(folder.path(), "terrain a.asc -o t.obj --force --max-error 1 --nodata -3.4e+38");
  CHECK(mended.status == 0);
  CHECK_FALSE(has(mended.out + mended.err, "--nodata"));
}

// lepp refine: regions, the two ways, and what it refuses.

#include <doctest/doctest.h>

#include <cmath>

#include "lepp/bisection/refine_where.hpp"
#include "lepp/bisection/region.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "pipeline/program.hpp"

using namespace lepp;
using namespace lepp::test;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

// A square in two parts, meshed as start.ele.
void make_start(const ScratchFolder& folder) {
  write(folder.path() / "in.poly",
        "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 0\n6 0.5 1\n"
        "5 1\n1 1 2 5\n2 2 3 6\n3 3 4 7\n4 4 1 8\n5 5 6 9\n0\n");
  REQUIRE(run(folder.path(), "mesh in.poly --max-edge 0.3 -q -o start.ele").status == 0);
}

// The unit square as two triangles, square.ele.
void make_square(const ScratchFolder& folder) {
  write(folder.path() / "square.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n");
  write(folder.path() / "square.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
}

std::size_t too_large(const fs::path& file, const Region& region, double eps) {
  const Mesh mesh = mesh_from_triangles(read_ele(file)).mesh;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    count += !(diameter(mesh, t) < eps) && meets(region, mesh.corners(t)) ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("lepp refine makes every triangle that meets a region small, either way") {
  const ScratchFolder folder;
  make_start(folder);
  write(folder.path() / "corners.txt", "0.1 0.1\n0.4 0.2\n0.2 0.5\n");
  const std::pair<std::string, Region> regions[] = {
      {"disc 0.3 0.4 0.1", Disc{{0.3, 0.4}, 0.1}},
      {"box 0 0 1 0.05", Box{{0, 0}, {1, 0.05}}},
      {"polygon corners.txt", PolygonArea{{{0.1, 0.1}, {0.4, 0.2}, {0.2, 0.5}}}}};
  for (const auto& [text, region] : regions) {
    for (const std::string by : {"bisect", "delaunay"}) {
      CAPTURE(text);
      CAPTURE(by);
      const Outcome done = run(
          folder.path(), "refine start.ele -o out.ele --force -q --json - --max-edge 0.02 --by " +
                             by + " --in \"" + text + "\"");
      REQUIRE(done.status == 0);
      const Json report = Json::parse(done.out);
      CHECK(report["goal_reached"] == true);
      CHECK(report["valid"] == true);
      CHECK(report["vertices"] < 20000);
      CHECK(too_large(folder.path() / "out.ele", region, 0.02) == 0);
      if (by == "bisect") continue;
      CHECK(report["admissible"] == true);
      CHECK(report["min_angle_deg"] >= 30 - 1e-9);
      CHECK(report["obtuse_constrained"] == 0);
    }
  }
}

TEST_CASE("lepp refine without a region refines all of the mesh; newest vertices do as well") {
  const ScratchFolder folder;
  make_start(folder);
  const Region all = Box{{-1, -1}, {2, 2}};
  for (const std::string rule : {"longest-edge", "newest-vertex"}) {
    REQUIRE(
        run(folder.path(), "refine start.ele -o out.ele --force -q --max-edge 0.05 --rule " + rule)
            .status == 0);
    CHECK(too_large(folder.path() / "out.ele", all, 0.05) == 0);
  }
}

TEST_CASE("a size at a point inside a large triangle holds there, at any grading") {
  const ScratchFolder folder;
  make_start(folder);
  write(folder.path() / "sizes.txt", "0.21 0.37 1e-3\n");
  REQUIRE(run(folder.path(), "refine start.ele -o out.ele -q --size-file sizes.txt --grading 0.9")
              .status == 0);
  CHECK(too_large(folder.path() / "out.ele", Disc{{0.21, 0.37}, 0}, 1.0001e-3) == 0);
}

TEST_CASE("lepp refine by delaunay: a size at a point reaches the triangle around it") {
  const ScratchFolder folder;
  make_start(folder);
  write(folder.path() / "one.txt", "0.45 0.56 0.24\n");
  for (const std::string grading : {"0", "0.25", "0.9"}) {
    CAPTURE(grading);
    const std::string arguments =
        "refine start.ele -o out.ele --force -q --by delaunay --size-file one.txt --grading ";
    CHECK(run(folder.path(), arguments + grading).status == 0);
    CHECK(too_large(folder.path() / "out.ele", Disc{{0.45, 0.56}, 0}, 0.24001) == 0);
  }
}

TEST_CASE("lepp refine: edges as long as --max-edge are too long, either way and at any grading") {
  const ScratchFolder folder;
  make_square(folder);
  for (const std::string options : {"--max-edge 1", "--max-edge 1 --in \"box 0 0 1 1\" --grading 0",
                                    "--max-edge 0.5 --in \"disc 0.5 0.5 0.1\" --grading 0"}) {
    for (const std::string by : {"bisect", "delaunay"}) {
      CAPTURE(options);
      CAPTURE(by);
      const std::string start = "refine square.ele -o out.ele --force -q --by ";
      CHECK(run(folder.path(), start + by + " " + options).status == 0);
    }
  }
  CHECK(run(folder.path(), "refine square.ele -o out.ele --force -q --max-edge 1").status == 0);
  CHECK(too_large(folder.path() / "out.ele", Box{{-1, -1}, {2, 2}}, 1) == 0);
}

TEST_CASE("lepp refine overwrites neither a size file nor a polygon, --force or not") {
  const ScratchFolder folder;
  make_square(folder);
  const std::string polygon = "0.1 0.1\n0.9 0.1\n0.5 0.9\n", sizes = "0.5 0.5 0.1\n";
  for (const char* name : {"p.txt", "p.msh"}) write(folder.path() / name, polygon);
  for (const char* name : {"s.txt", "s.msh"}) write(folder.path() / name, sizes);
  const std::string with_polygon = "refine square.ele -q --max-edge 0.5 --force --in ";
  const std::string with_sizes = "refine square.ele -q --force --size-file ";
  for (const std::string& arguments :
       {with_sizes + "s.txt -o new.msh --json s.txt", with_sizes + "s.msh -o s.msh",
        with_polygon + "'polygon p.txt' -o new.msh --json p.txt",
        with_polygon + "' polygon  p.txt ' -o new.msh --json ./p.txt",
        with_polygon + "'polygon p.msh' -o p.msh"}) {
    CAPTURE(arguments);
    CHECK(run(folder.path(), arguments).status == 5);
  }
  for (const char* name : {"p.txt", "p.msh"}) CHECK(content_of(folder.path() / name) == polygon);
  for (const char* name : {"s.txt", "s.msh"}) CHECK(content_of(folder.path() / name) == sizes);
}

TEST_CASE("lepp refine: blanks around a region do not count, another line does") {
  const ScratchFolder folder;
  make_square(folder);
  write(folder.path() / "my corners.txt", "0.1 0.1\n0.9 0.1\n0.5 0.9\n");
  const auto status = [&](const std::string& region) {
    return run(folder.path(),
               "refine square.ele -o out.ele -q --force --max-edge 0.5 --in '" + region + "'")
        .status;
  };
  for (const std::string region : {"polygon my corners.txt", "polygon  my corners.txt",
                                   " polygon my corners.txt ", "\tdisc 0 0  0.1 "}) {
    CAPTURE(region);
    CHECK(status(region) == 0);
  }
  for (const std::string region :
       {"disc 0 0 1\ndisc 1 1 1", "polygon ", "polygon", "polygons my corners.txt"}) {
    CAPTURE(region);
    CHECK(status(region) == 2);
  }
}

TEST_CASE("lepp refine by delaunay ends at the budget that the library sets for such sizes") {
  const ScratchFolder folder;
  // A sliver of 1e-12 beside a square: triangles of this size could fill it with millions.
  fs::copy_file(LEPP_REGRESSION "/sliver_beside_a_square.poly", folder.path() / "in.poly");
  REQUIRE(run(folder.path(), "mesh in.poly -q -o start.ele").status == 0);
  const Outcome stopped =
      run(folder.path(), "refine start.ele -o out.ele -q --json - --max-edge 0.05 --by delaunay");
  CHECK(stopped.status == 3);
  const Json report = Json::parse(stopped.out);
  CHECK(report["vertices"] < 200000);
  CHECK(report["below_bound"]["budget"] > 0);
}

TEST_CASE("lepp refine refuses options that would have no effect") {
  const ScratchFolder folder;
  make_square(folder);
  write(folder.path() / "s.txt", "0.5 0.5 0.1\n");
  for (const std::string options :
       {"--max-edge 0.5 --by delaunay --rule newest-vertex", "--max-edge 0.5 --min-angle 20",
        "--size-file s.txt --in 'disc 0 0 1'"}) {
    CAPTURE(options);
    CHECK(run(folder.path(), "refine square.ele -o out.ele -q " + options).status == 1);
  }
}

TEST_CASE("lepp refine says in its help that curves are cut along chords") {
  CHECK(run(ScratchFolder().path(), "refine --help").out.find("along their chords") !=
        std::string::npos);
}

TEST_CASE("lepp refine stops at its limit with status 3 and writes only if told to") {
  const ScratchFolder folder;
  make_start(folder);
  const std::string arguments = "refine start.ele -o out.ele -q --max-edge 1e-3 --max-vertices 500";
  CHECK(run(folder.path(), arguments).status == 3);
  CHECK_FALSE(fs::exists(folder.path() / "out.ele"));
  CHECK(run(folder.path(), arguments + " --allow-unfinished").status == 3);
  CHECK(read_ele(folder.path() / "out.ele").points.size() == 500);
}

TEST_CASE("lepp refine refuses geometry, regions that are none, and to do nothing") {
  const ScratchFolder folder;
  make_start(folder);
  CHECK(run(folder.path(), "refine in.poly -o out.ele --max-edge 0.1").status == 2);
  CHECK(run(folder.path(), "refine start.ele -o out.ele").status == 1);
  for (const char* region : {"disc 1 2", "disc 0 0 -1", "box 1 0 0 1", "circle 0 0 1",
                             "polygon nowhere.txt", "disc a b c", ""}) {
    CAPTURE(region);
    const Outcome refused =
        run(folder.path(),
            std::string("refine start.ele -o out.ele --max-edge 0.1 --in \"") + region + "\"");
    CHECK(refused.status == 2);
    CHECK_FALSE(refused.err.empty());
  }
  CHECK_FALSE(fs::exists(folder.path() / "out.ele"));
}

// The command line: exit statuses, overwriting, formats, clean output.

#include <doctest/doctest.h>

#include "pipeline/program.hpp"

using namespace lepp::test;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

const char* const square =
    "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 5\n2 2 3 6\n3 3 4 7\n4 4 1 8\n0\n";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the version and the help are printed with status 0, usage errors have status 1") {
  const ScratchFolder folder;
  CHECK(run(folder.path(), "--version").out == "lepp 0.1.0\n");
  const Outcome help = run(folder.path(), "mesh --help");
  CHECK(help.status == 0);
  CHECK(has(help.out, "lepp mesh plate.geo -o plate.msh"));
  for (const char* wrong :
       {"", "frobnicate", "mesh", "mesh in.poly", "mesh in.poly -o x.msh --method none",
        "mesh in.poly -o x.msh --min-angle many", "mesh in.poly -o x.msh --min-angle nan",
        "mesh in.poly -o x.msh --max-edge 0", "mesh in.poly -o x.msh --max-vertices -5"}) {
    CAPTURE(wrong);
    CHECK(run(folder.path(), wrong).status == 1);
  }
}

TEST_CASE("a wrong value of an option is a usage error that says what to give, in a line") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  const std::pair<const char*, const char*> cases[] = {
      {"--grading -1", "give a number from 0 on"},
      {"--grading nan", "give a number from 0 on"},
      {"--grading inf", "give a number from 0 on"},
      {"--chord-tolerance 0", "give a number above 0"},
      {"--max-edge inf", "give a number above 0"},
      {"--max-vertices 0", "give a whole number from 1 on"},
      {"--max-vertices 99999999999999999999", "give a whole number from 1 on"},
      {"--effort foo", "'foo' is none of fast, normal, best"},
      {"--effort 1", "'1' is none of fast, normal, best"},
      {"--region-edge copper", "give REGION=VALUE"},
      {"--region-edge copper=-1", "give REGION=VALUE"},
      {"--region-area copper=nan", "give REGION=VALUE"},
      {"--region-edge a=1 --region-edge a=2", "region a is given twice"},
      {"--method paper --max-angle 90", "goes with --method unified only"},
      {"--method paper --effort best", "goes with --method unified only"},
      {"--max-angle 90 --placement midpoint", "needs --placement offcentre or best"}};
  for (const auto& [options, message] : cases) {
    CAPTURE(options);
    const Outcome outcome = run(folder.path(), std::string("mesh in.poly -o x.msh ") + options);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 1);
    CHECK(has(outcome.err, message));
    CHECK(outcome.err.size() < 200);
  }
  const Outcome idle = run(folder.path(), "mesh in.poly -o x.msh --grading 1");
  CHECK(idle.status == 0);
  CHECK(has(idle.out, "--grading has no effect"));
  CHECK(run(folder.path(), "mesh in.poly -o x.msh --force -q --effort BEST").status == 0);
}

TEST_CASE("a mesh goes out as .msh, .vtu and .ele, and comes back") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  for (const char* target : {"a.msh", "b.vtu", "c.ele"}) {
    CAPTURE(target);
    const Outcome made =
        run(folder.path(), std::string("mesh in.poly --max-edge 0.3 -q -o ") + target);
    CAPTURE(made.err);
    CHECK(made.status == 0);
    CHECK(fs::exists(folder.path() / target));
  }
  CHECK(fs::exists(folder.path() / "c.node"));
  CHECK(fs::exists(folder.path() / "c.poly"));
  const Json msh = Json::parse(run(folder.path(), "check a.msh -q --json -").out);
  const Json ele = Json::parse(run(folder.path(), "check c.ele -q --json -").out);
  CHECK(msh["triangles"] == ele["triangles"]);
  CHECK(msh["min_angle_deg"] == ele["min_angle_deg"]);
}

TEST_CASE("nothing is overwritten without --force, and an input never") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  write(folder.path() / "out.msh", "mine");
  CHECK(run(folder.path(), "mesh in.poly -o out.msh -q").status == 5);
  CHECK(content_of(folder.path() / "out.msh") == "mine");
  CHECK(run(folder.path(), "mesh in.poly -o out.msh -q --force").status == 0);
  CHECK(run(folder.path(), "mesh in.poly -o in.ele -q --force").status == 5);  // in.poly is input
  CHECK(content_of(folder.path() / "in.poly") == square);
}

TEST_CASE("a report never replaces an input or the mesh of the same run") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  CHECK(run(folder.path(), "mesh in.poly -o out.msh -q --force --json in.poly").status == 5);
  CHECK(run(folder.path(), "mesh in.poly -o out.msh -q --force --json out.msh").status == 5);
  CHECK(run(folder.path(), "info in.poly --json in.poly").status == 5);
  CHECK(content_of(folder.path() / "in.poly") == square);
  CHECK_FALSE(fs::exists(folder.path() / "out.msh"));
  CHECK(run(folder.path(), "info in.poly > /dev/full").status == 5);
}

TEST_CASE("a size file is an input too: neither the mesh nor the report replaces it") {
  const ScratchFolder folder;
  const std::string sizes = "0.5 0.5 0.1\n";
  write(folder.path() / "sizes.txt", sizes);
  write(folder.path() / "sizes.msh", sizes);
  write(folder.path() / "in.poly", square);
  const auto status = [&](const std::string& rest) {
    return run(folder.path(), "mesh in.poly -q --force " + rest).status;
  };
  CHECK(status("-o out.msh --size-file sizes.txt --json sizes.txt") == 5);
  CHECK(status("-o sizes.msh --size-file sizes.msh") == 5);
  CHECK(content_of(folder.path() / "sizes.txt") == sizes);
  CHECK(content_of(folder.path() / "sizes.msh") == sizes);
}

TEST_CASE("bad input has status 2 and names file and line; nothing is written") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", "3 2 0 0\n1 0 0\n2 nan 0\n3 0 1\n0 0\n0\n");
  const Outcome made = run(folder.path(), "mesh in.poly -o out.msh");
  CHECK(made.status == 2);
  CHECK(has(made.err, "in.poly, line 3"));
  CHECK(files_in(folder.path()) == std::vector<std::string>{"in.poly"});
  CHECK(run(folder.path(), "mesh missing.poly -o out.msh").status == 2);
  const Outcome of_folder = run(folder.path(), "mesh . -o out.msh");
  CHECK(of_folder.status == 2);
  CHECK(has(of_folder.err, "is a folder, not a file"));
  CHECK(run(folder.path(), "mesh in.poly -o out.stl").status == 1);
}

TEST_CASE("an unreached goal has status 3 and writes only if asked to") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  const std::string few =
      "mesh in.poly -o out.msh -q --json report.json --max-edge 0.01 --max-vertices 100";
  CHECK(run(folder.path(), few).status == 3);
  CHECK_FALSE(fs::exists(folder.path() / "out.msh"));
  const Json report = Json::parse(content_of(folder.path() / "report.json"));
  CHECK(report["goal_reached"] == false);
  CHECK(report["below_bound"]["budget"].get<int>() > 0);
  CHECK(run(folder.path(), few + " --allow-unfinished").status == 3);
  CHECK(fs::exists(folder.path() / "out.msh"));
  CHECK(run(folder.path(), "check out.msh -q --delaunay").status == 0);
}

TEST_CASE("sizes beyond any budget are refused with status 4 before work starts") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  const Outcome made = run(folder.path(), "mesh in.poly -o out.msh --max-edge 1e-9");
  CHECK(made.status == 4);
  CHECK_FALSE(fs::exists(folder.path() / "out.msh"));
}

TEST_CASE("a full device has status 5") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  fs::create_symlink("/dev/full", folder.path() / "full.msh");
  CHECK(run(folder.path(), "mesh in.poly -o full.msh -q --force --max-edge 0.02").status == 5);
  CHECK(run(folder.path(), "mesh in.poly -o no/such/folder.msh -q").status == 5);
}

TEST_CASE("--json - leaves nothing but JSON on standard output") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  const Outcome made = run(folder.path(), "mesh in.poly -o out.msh --json -");
  const Json report = Json::parse(made.out);
  for (const char* key :
       {"schema_version", "vertices", "triangles", "input_vertices", "steiner_points",
        "min_angle_deg", "mean_min_angle_deg", "mean_max_angle_deg", "max_angle_deg", "below_bound",
        "obtuse_constrained", "non_delaunay_edges", "tolerant", "admissible", "goal_reached",
        "stages", "seconds", "peak_memory_bytes", "groups"}) {
    CAPTURE(key);
    CHECK(report.contains(key));
  }
  CHECK(report["seconds"].contains("triangulate"));
  CHECK(report["peak_memory_bytes"].get<double>() > 1e6);
}

TEST_CASE("check: status 3 for a claim that fails") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", "3 2 0 0\n1 0 0\n2 4 0\n3 2 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  REQUIRE(run(folder.path(), "mesh in.poly -o out.msh -q --min-angle 0 --no-nonobtuse").status ==
          0);
  CHECK(run(folder.path(), "check out.msh -q").status == 0);
  CHECK(run(folder.path(), "check out.msh -q --delaunay").status == 0);
  CHECK(run(folder.path(), "check out.msh -q --nonobtuse").status == 3);
  CHECK(run(folder.path(), "check out.msh -q --admissible").status == 3);
  const Json report = Json::parse(run(folder.path(), "check out.msh -q --json -").out);
  CHECK(report["admissible"] == false);
  REQUIRE(report["offending_edges"].size() == 1);
}

TEST_CASE("check excuses what the input forced on a mesh, as mesh does, and nothing else") {
  const ScratchFolder folder;
  // A polygon that runs back to one point: wedges whose sides refinement cuts at equal distances.
  write(
      folder.path() / "in.poly",
      "11 2 0 0\n0 440 4152\n1 440 4208\n2 296 4192\n3 368 4192\n4 400 4200\n5 400 4176\n"
      "6 368 4192\n7 296 4192\n8 264 4200\n9 288 4160\n10 296 4192\n"
      "11 0\n0 0 1\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 7\n7 7 8\n8 8 9\n9 9 10\n10 10 0\n0\n");
  for (const std::string target : {"out.ele", "out.msh"}) {
    CAPTURE(target);
    REQUIRE(run(folder.path(), "mesh in.poly -q --force --json report.json -o " + target).status ==
            0);
    const Outcome checked = run(folder.path(), "check -q --min-angle 30 --json - " + target);
    CHECK(checked.status == 0);
    const Json made = Json::parse(content_of(folder.path() / "report.json"));
    CHECK(Json::parse(checked.out)["below_bound"] == made["below_bound"]);
    CHECK(made["below_bound"]["input_angle"] > 2);
  }
  // A point near the middle of a side: two angles of one degree that no wedge forces.
  write(folder.path() / "bad.node", "6 2 0 0\n1 0 0\n2 0.5 0\n3 1 0\n4 1 1\n5 0 1\n6 0.5 0.01\n");
  write(folder.path() / "bad.ele", "5 3 0\n1 1 2 6\n2 2 3 6\n3 3 4 6\n4 4 5 6\n5 5 1 6\n");
  CHECK(run(folder.path(), "check bad.ele -q").status == 0);
  CHECK(run(folder.path(), "check bad.ele -q --min-angle 30").status == 3);
}

TEST_CASE("a mesh does not overlap itself where boundaries are an ulp apart") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly",
        "6 2 0 0\n0 -46.654032 -0.8788341\n1 -46.654008761408086 -0.87880625\n"
        "2 -46.65402 -0.878806\n3 -46.654032 -0.8788341\n4 -46.654 -0.87883\n"
        "5 -46.653968 -0.8787574\n6 0\n0 0 1\n1 1 2\n2 2 0\n3 3 4\n4 4 5\n5 5 3\n0\n");
  for (const std::string target : {"out.msh", "out.ele"}) {
    CAPTURE(target);
    CHECK(run(folder.path(), "mesh in.poly --split-crossings -q -o " + target).status == 0);
    CHECK(run(folder.path(), "check -q " + target).status == 0);
  }
}

TEST_CASE("crossing segments are refused with both ids, or split when asked to") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly",
        "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 1 3\n6 2 4\n0\n");
  const Outcome made = run(folder.path(), "mesh in.poly -o out.msh");
  CHECK(made.status == 2);
  CHECK(has(made.err, "segment 5 and segment 6 cross at (0.5, 0.5)"));
  CHECK(run(folder.path(), "mesh in.poly -o out.msh -q --split-crossings").status == 0);
}

TEST_CASE("convert: geometry to geometry and mesh to mesh, never geometry to mesh") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  CHECK(run(folder.path(), "convert in.poly -o out.geo").status == 0);
  CHECK(run(folder.path(), "mesh out.geo -o out.msh -q").status == 0);
  CHECK(run(folder.path(), "convert out.msh -o back.poly").status == 0);
  CHECK(run(folder.path(), "convert out.msh -o out.vtu").status == 0);
  CHECK(run(folder.path(), "convert out.msh -o old.msh --format msh22").status == 0);
  CHECK(has(content_of(folder.path() / "old.msh"), "2.2 0 8"));
  const Outcome refused = run(folder.path(), "convert in.poly -o direct.msh");
  CHECK(refused.status == 2);
  CHECK(has(refused.err, "lepp mesh"));
}

TEST_CASE("info and picture") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly", square);
  const Json info = Json::parse(run(folder.path(), "info in.poly --json -").out);
  CHECK(info["points"] == 4);
  CHECK(info["segments"] == 4);
  REQUIRE(run(folder.path(), "mesh in.poly -o out.msh -q --max-edge 0.4").status == 0);
  CHECK(run(folder.path(), "picture out.msh -o plain.svg").status == 0);
  CHECK(run(folder.path(), "picture out.msh -o boxes.svg --boxes").status == 0);
  CHECK(has(content_of(folder.path() / "plain.svg"), "</svg>"));
  CHECK(content_of(folder.path() / "plain.svg") != content_of(folder.path() / "boxes.svg"));
}

TEST_CASE("an old mesh is improved: its vertices, boundary and groups survive") {
  const ScratchFolder folder;
  write(folder.path() / "in.poly",
        "6 2 0 0\n1 0 0\n2 20 0\n3 20 1\n4 0 1\n5 4 0.4\n6 16 0.5\n"
        "5 1\n1 1 2 5\n2 2 3 6\n3 3 4 7\n4 4 1 8\n5 5 6 9\n0\n");
  REQUIRE(run(folder.path(), "mesh in.poly -o old.msh -q --min-angle 5 --no-nonobtuse").status ==
          0);
  const Json old = Json::parse(run(folder.path(), "check old.msh -q --json -").out);
  const Outcome made = run(folder.path(), "mesh old.msh -o new.msh -q --json -");
  REQUIRE(made.status == 0);
  const Json better = Json::parse(made.out);
  CHECK(better["goal_reached"] == true);
  CHECK(better["admissible"] == true);
  CHECK(better["input_vertices"] == old["vertices"]);
  const auto before = group_measures(old), after = group_measures(better);
  CHECK(before == after);
  const Outcome anew = run(folder.path(), "mesh old.msh -o anew.msh -q --json - --remesh");
  REQUIRE(anew.status == 0);
  CHECK(Json::parse(anew.out)["input_vertices"].get<int>() <= old["vertices"].get<int>());
}

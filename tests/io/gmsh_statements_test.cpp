#include "lepp/io/gmsh_statements.hpp"

#include <doctest/doctest.h>

#include <string>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using lepp::test::contains;
using lepp::test::error_of;

namespace {

struct Inspected {
  std::string text;
  GmshScript script;
  GeoStatements statements;
};

Inspected inspect(std::string text) {
  Inspected result{std::move(text), {}, {}};
  result.statements = inspect_geo(result.text, "a.geo", result.script);
  return result;
}

bool sets_sizes(const std::string& text) { return inspect(text).script.sets_sizes; }

}  // namespace

TEST_CASE("sizes are seen where a file sets them") {
  for (const char* text :
       {"Point(1) = {0, 0, 0, 0.1};", "Point(p + 1) = {x[0], Sqrt(2, 3), {1}, lc};",
        "Characteristic Length {1} = 0.1;", "MeshSize {1} = 0.1;", "Mesh.MeshSizeMax = 0.1;",
        "Mesh.CharacteristicLengthFactor = 2;", "Transfinite Curve {1} = 5;",
        "Transfinite Line \"*\" = 2;", "Field[1] = Box;", "Background Field = 1;",
        "Extrude {1, 0, 0} { Point{1}; Layers{5}; }"}) {
    CAPTURE(text);
    CHECK(sets_sizes(text));
  }
}

TEST_CASE("what looks like sizes but is none is not taken for them") {
  for (const char* text :
       {"Point(1) = {0, 0, 0};", "Physical Point(1) = {1, 2, 3, 4};", "Point(1) = {0, 0, 0, 1e22};",
        "Point{1} In Surface{1};", "Mesh.Algorithm = 6;", "// Transfinite Curve {1} = 5;",
        "Transfinite Surface {1};", "x = \"Field[1]\";"}) {
    CAPTURE(text);
    CHECK_FALSE(sets_sizes(text));
  }
}

TEST_CASE("statements that mesh or write become blanks of the same length") {
  const Inspected seen =
      inspect("a = 1;\nMesh 2; Save\n \"x.msh\"; b = 2;\nPrintf(\"c\") > \"f\";");
  CHECK(seen.text == "a = 1;\n            \n          b = 2;\n                  ");
  CHECK(seen.script.warnings.size() == 3);
  CHECK(contains(seen.script.warnings[0], "a.geo, line 2: Mesh"));
}

TEST_CASE("options and output on the terminal stay") {
  const std::string text = "Mesh.Algorithm = 6; Print.Width = 3; Printf(\"a > b\");";
  CHECK(inspect(text).text == text);
}

TEST_CASE("statements that run or end programs are refused with their line") {
  for (const char* word : {"SystemCall \"x\"", "System \"x\"", "NonBlockingSystemCall \"x\"",
                           "OnelabRun(\"x\")", "CreateDir \"x\"", "Exit", "Plugin(A).Run"}) {
    CAPTURE(word);
    const std::string message =
        error_of<InputError>([&] { inspect("a = 1;\n" + std::string(word) + ";"); });
    CHECK(contains(message, "a.geo, line 2"));
  }
}

TEST_CASE("included names and curve loops are noted") {
  const Inspected seen = inspect(
      "Include \"b.geo\";\nMerge 'c.step';\nCurve Loop(4) = {1, -2, 3}; Line Loop(5) = {6};");
  REQUIRE(seen.statements.included.size() == 2);
  CHECK(seen.statements.included[1].name == "c.step");
  CHECK(seen.statements.included[1].line == 2);
  REQUIRE(seen.script.loops.size() == 2);
  CHECK(seen.script.loops[0].curves == std::vector<int>{1, 2, 3});
  CHECK(contains(error_of<InputError>([] { inspect("Merge StrCat(\"a\", \"b\");"); }), "line 1"));
}

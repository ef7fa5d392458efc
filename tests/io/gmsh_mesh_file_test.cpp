#include "lepp/io/gmsh_mesh_file.hpp"

#include <doctest/doctest.h>

#include <string>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using lepp::test::contains;
using lepp::test::error_of;
using lepp::test::ScratchFolder;

namespace {

const std::string version_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
    "$Elements\n2\n1 1 2 0 1 1 2\n2 2 2 0 1 1 2 3\n$EndElements\n";
const std::string version_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n"
    "$EndNodes\n$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 3\n$EndElements\n";
const std::string version_1 =
    "$NOD\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$ENDNOD\n$ELM\n1\n1 2 1 1 3 1 2 3\n$ENDELM\n";

/// The message for a file, empty if it is copied.
std::string copy(const std::string& text) {
  const ScratchFolder scratch;
  const auto file = scratch.put("a.msh", text);
  std::filesystem::create_directory(scratch / "private");
  return error_of<Error>([&] { copy_mesh_file(file, scratch / "private"); });
}

std::string replaced(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  REQUIRE(at != text.npos);
  return text.replace(at, old.size(), now);
}

}  // namespace

TEST_CASE("good files of every version are copied") {
  CHECK(copy(version_1).empty());
  CHECK(copy(version_2).empty());
  CHECK(copy(version_4).empty());
  CHECK(copy("\xEF\xBB\xBF" + version_4).empty());
  CHECK(copy("$Comments\nany\n$EndComments\n" + version_2).empty());
}

TEST_CASE("a damaged file is refused with its line and reason") {
  CHECK(contains(copy(replaced(version_2, "$Nodes\n3", "$Nodes\n99999999999")), "line 5"));
  CHECK(contains(copy(replaced(version_4, "1 3 1 3", "1 400 1 3")), "only"));
  CHECK(contains(copy(replaced(version_4, "1 1 1 1", "9999 1 1 1")), "9999 blocks of elements"));
  CHECK(contains(copy(replaced(version_2, "$Elements\n2", "$Elements\n3")), "element 3 of 3"));
  CHECK(
      contains(copy(replaced(version_2, "1 1 2 3\n", "1 1 2 7\n")), "element 2 refers to node 7"));
  CHECK(
      contains(copy(replaced(version_1, "3 1 2 3\n", "3 1 2 8\n")), "element 1 refers to node 8"));
  CHECK(contains(copy(replaced(version_2, "$EndElements", "")), "$EndElements is missing"));
  CHECK(contains(copy(replaced(version_2, "2.2 0", "7.5 0")), "MSH version 7.5"));
  CHECK(contains(copy(replaced(version_2, "2 1 0 0", "two 1 0 0")), "not a number"));
  CHECK(contains(copy("Point(1) = {0, 0, 0};\n"), "does not begin"));
}

TEST_CASE("no beginning of a file is copied as a whole one") {
  for (const std::string& text : {version_1, version_2, version_4})
    for (std::size_t n = 0; n + 1 < text.size(); ++n) {
      CAPTURE(n);
      CHECK_FALSE(copy(text.substr(0, n)).empty());
    }
}

TEST_CASE("elements that are no triangles are counted and named") {
  const std::string quad = replaced(version_4, "2 1 2 1\n1 1 2 3", "2 1 3 1\n1 1 2 3 3");
  CHECK(contains(copy(quad), "found 1 quadrangle (4-node)"));
  const std::string second_order =
      replaced(version_4, "2 1 2 1\n1 1 2 3", "2 1 9 1\n1 1 2 3 1 2 3");
  CHECK(contains(copy(second_order), "1 second-order triangle (6-node)"));
}

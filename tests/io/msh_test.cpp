#include "lepp/io/msh.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "io/sample_meshes.hpp"
#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

namespace {

std::vector<std::string> lines_of(const std::string& text, const std::string& section) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line == "$End" + section) return lines;
    if (inside) lines.push_back(line);
    if (line == "$" + section) inside = true;
  }
  return lines;
}

// Elements of a 2.2 file: (type, group, entity) -> how many.
std::map<std::array<int, 3>, int> count_22(const std::string& text) {
  std::map<std::array<int, 3>, int> counts;
  const auto lines = lines_of(text, "Elements");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::istringstream line(lines[i]);
    int number = 0, type = 0, tags = 0, group = 0, entity = 0;
    line >> number >> type >> tags >> group >> entity;
    CHECK(number == static_cast<int>(i));
    CHECK(tags == 2);
    ++counts[{type, group, entity}];
  }
  return counts;
}

Mesh one_group_each() {
  Pslg pslg = test::two_squares();
  pslg.entities.curves[5].groups.resize(1);
  for (SurfaceEntity& s : pslg.entities.surfaces) s.groups.resize(1);
  return constrained_delaunay(pslg).mesh;
}

}  // namespace

TEST_CASE("4.1 keeps every group of every entity, with names") {
  const ScratchFolder folder;
  write_msh(test::two_squares_mesh(), folder / "a.msh");
  const std::string text = folder.text("a.msh");
  CHECK(text.starts_with("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"));
  const auto names = lines_of(text, "PhysicalNames");
  CHECK(std::ranges::count(names, "2 3 \"plate\"") == 1);
  CHECK(std::ranges::count(names, "0 9 \"well\"") == 1);
  CHECK(std::ranges::count(names, "1 5 \"ungrouped\"") == 1);  // the crack
  CHECK(names.size() == 9);                                    // group 4 has no name
  const auto entities = lines_of(text, "Entities");
  CHECK(entities[0].substr(entities[0].size() - 6) == " 7 2 0");
  CHECK(std::ranges::any_of(entities, [](const std::string& line) {
    return line.starts_with("16 1 0 0 1 1 0 2 3 4 2 ");
  }));
  CHECK(std::ranges::any_of(entities, [](const std::string& line) {
    return line.starts_with("21 0 0 0 1 1 0 2 1 3 4 ");
  }));
  CHECK(lines_of(text, "Nodes")[0].ends_with(" 9 1 9"));
}

TEST_CASE("2.2 has the header that readers compare, and one line per element") {
  const ScratchFolder folder;
  const Mesh mesh = one_group_each();
  write_msh(mesh, folder / "a.msh", MshFormat::msh22);
  const std::string text = folder.text("a.msh");
  CHECK(text.starts_with("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"));
  const auto counts = count_22(text);
  CHECK(counts.at({15, 9, 31}) == 1);
  CHECK(counts.at({1, 1, 11}) == 2);
  CHECK(counts.at({1, 3, 16}) == 1);
  CHECK(counts.at({1, 0, 17}) == 1);  // no group: 0
  CHECK(counts.at({2, 1, 21}) + counts.at({2, 2, 22}) == static_cast<int>(mesh.triangle_count()));
  CHECK(lines_of(text, "Nodes")[0] == "9");
}

TEST_CASE("2.2 keeps triangles of surfaces without group beside others") {
  const ScratchFolder folder;
  Pslg pslg = test::two_squares();
  pslg.entities.curves[5].groups.clear();
  pslg.entities.surfaces[0].groups.resize(1);
  pslg.entities.surfaces[1].groups.clear();
  write_msh(constrained_delaunay(pslg).mesh, folder / "a.msh", MshFormat::msh22);
  CHECK(count_22(folder.text("a.msh")).at({2, 0, 22}) > 0);
}

TEST_CASE("2.2 refuses an entity in several groups, names it, and leaves nothing") {
  const ScratchFolder folder;
  const auto error = error_of<InputError>(
      [&] { write_msh(test::two_squares_mesh(), folder / "a.msh", MshFormat::msh22); });
  CHECK(contains(error, "curve 16: is in several physical groups (3 \"interface\", 4)"));
  CHECK(contains(error, "use format msh41"));
  CHECK(folder.names().empty());
}

TEST_CASE("a group name that the format cannot hold, or a negative tag, is refused") {
  const ScratchFolder folder;
  Pslg pslg = test::two_squares();
  pslg.entities.groups[0].name = "5\" pipe";
  CHECK(contains(
      error_of<InputError>([&] { write_msh(constrained_delaunay(pslg).mesh, folder / "a.msh"); }),
      "physical group 1 of dimension 2: its name has a double quote"));
  pslg.entities.groups[0] = {2, -1, "left"};
  CHECK(contains(
      error_of<InputError>([&] { write_msh(constrained_delaunay(pslg).mesh, folder / "a.msh"); }),
      "its tag is negative"));
  CHECK(folder.names().empty());
}

TEST_CASE("the same mesh gives the same bytes") {
  const ScratchFolder folder;
  for (const char* name : {"a.msh", "b.msh"}) write_msh(test::two_squares_mesh(), folder / name);
  CHECK(folder.text("a.msh") == folder.text("b.msh"));
}

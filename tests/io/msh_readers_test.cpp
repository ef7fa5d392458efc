#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "io/sample_meshes.hpp"
#include "io/scratch_folder.hpp"
#include "lepp/io/msh.hpp"

// What programs that others wrote find in our .msh files.

using namespace lepp;
using test::ScratchFolder;

namespace {

struct Ran {
  int status = 0;
  std::string output;
};

Ran run(const std::string& command) {
  Ran ran;
  FILE* pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) {
    ran.output.append(buffer, n);
  }
  const int status = ::pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ran;
}

std::string quoted(const std::filesystem::path& path) {
  return std::string("'").append(path.string()).append("'");
}

// The groups that meshio finds; nothing without meshio.
std::optional<std::string> meshio_groups(const std::filesystem::path& msh) {
  const auto script = std::filesystem::path(LEPP_TESTS) / "io" / "meshio_groups.py";
  if (!std::filesystem::exists("/usr/bin/python3")) return std::nullopt;
  const Ran ran = run("/usr/bin/python3 " + quoted(script) + " " + quoted(msh));
  if (ran.status == 3) return std::nullopt;
  CHECK(ran.status == 0);
  return ran.output;
}

// Lets Gmsh read a file and write what has a group again as format 2.2.
bool gmsh_copies(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (run("command -v gmsh").status != 0) return false;
  const Ran ran = run("gmsh " + quoted(from) + " -save -format msh22 -o " + quoted(to) + " 2>&1");
  CHECK(ran.status == 0);
  CHECK_FALSE(test::contains(ran.output, "Warning"));
  CHECK_FALSE(test::contains(ran.output, "Error"));
  return true;
}

Mesh one_group_each() {
  Pslg pslg = test::two_squares();
  pslg.entities.curves[5].groups.resize(1);
  for (SurfaceEntity& s : pslg.entities.surfaces) s.groups.resize(1);
  return constrained_delaunay(pslg).mesh;
}

const std::string grouped_22 =
    "vertices 9\n0 9 well 1 1\n1 0 - 1 0.25\n1 1 outside 5 5\n1 2 inlet 1 1\n1 3 interface 1 1\n"
    "2 1 left 6 1\n2 2 right 4 1\n";
const std::string grouped_41 =
    "vertices 9\n0 9 well 1 1\n1 1 outside 5 5\n1 2 inlet 1 1\n1 3 interface 1 1\n"
    "1 5 ungrouped 1 0.25\n2 1 left 6 1\n2 2 right 4 1\n";
// Gmsh does not write the crack, which has no group in format 2.2.
const std::string copied_22 =
    "vertices 9\n0 9 well 1 1\n1 1 outside 5 5\n1 2 inlet 1 1\n1 3 interface 1 1\n"
    "2 1 left 6 1\n2 2 right 4 1\n";
const std::string no_groups = "vertices 8\n1 0 - 8 16\n2 0 - 8 8\n";

}  // namespace

TEST_CASE("meshio finds the groups, names and sizes of our .msh files") {
  const ScratchFolder folder;
  write_msh(one_group_each(), folder / "a41.msh");
  write_msh(one_group_each(), folder / "a22.msh", MshFormat::msh22);
  const auto groups = meshio_groups(folder / "a41.msh");
  if (!groups) {
    MESSAGE("skipped: no /usr/bin/python3 with meshio");
    return;
  }
  CHECK(*groups == grouped_41);
  CHECK(*meshio_groups(folder / "a22.msh") == grouped_22);
  const Mesh plain = constrained_delaunay(test::square_with_hole()).mesh;
  write_msh(plain, folder / "b41.msh");
  write_msh(plain, folder / "b22.msh", MshFormat::msh22);
  CHECK(*meshio_groups(folder / "b41.msh") == no_groups);
  CHECK(*meshio_groups(folder / "b22.msh") == no_groups);
}

TEST_CASE("Gmsh reads our .msh files without complaint and loses nothing") {
  const ScratchFolder folder;
  write_msh(one_group_each(), folder / "a41.msh");
  write_msh(one_group_each(), folder / "a22.msh", MshFormat::msh22);
  if (!gmsh_copies(folder / "a41.msh", folder / "a41-copy.msh")) {
    MESSAGE("skipped: no gmsh");
    return;
  }
  gmsh_copies(folder / "a22.msh", folder / "a22-copy.msh");
  const auto groups = meshio_groups(folder / "a41-copy.msh");
  if (!groups) {
    MESSAGE("skipped: no /usr/bin/python3 with meshio");
    return;
  }
  CHECK(*groups == grouped_41);
  CHECK(*meshio_groups(folder / "a22-copy.msh") == copied_22);
}

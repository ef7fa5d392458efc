// lepp-poisson as a user runs it: exit status, and which files it leaves alone.

#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "lepp/io/poly.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "two_materials.hpp"

using namespace lepp;
namespace fs = std::filesystem;

namespace {

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("lepp_poisson_" + std::to_string(getpid()))) {
    fs::create_directories(path_);
    write_ele(constrained_delaunay(test::two_materials_pslg()).mesh, path_ / "plate.ele");
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// The exit status; the mesh lies at plate.ele.
  int run(const std::string& arguments) const {
    const std::string command = "cd '" + path_.string() + "' && '" LEPP_POISSON_PROGRAM "' " +
                                arguments + " >/dev/null 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("lepp-poisson: malformed options are wrong usage, a wrong group is wrong input") {
  const Folder folder;
  CHECK(folder.run("plate.ele --dirichlet 4=0") == 0);
  CHECK(folder.run("plate.ele --dirichlet 4") == 1);
  CHECK(folder.run("plate.ele --dirichlet 4=zero") == 1);
  CHECK(folder.run("plate.ele --robin 4=1") == 1);
  CHECK(folder.run("plate.ele --dirichlet 77=0") == 2);
  CHECK(folder.run("plate.ele --dirichlet 4=0 --dirichlet 4=1") == 2);
}

TEST_CASE("lepp-poisson: an earlier solution is overwritten only with --force") {
  const Folder folder;
  CHECK(folder.run("plate.ele --dirichlet 4=0 -o u.vtu") == 0);
  CHECK(folder.run("plate.ele --dirichlet 4=0 -o u.vtu") == 5);
  CHECK(folder.run("plate.ele --dirichlet 4=0 -o u.vtu --force") == 0);
  CHECK(folder.run("plate.ele --dirichlet 4=0 -o plate.ele --force") == 5);
}

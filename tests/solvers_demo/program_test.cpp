// lepp-poisson as a user runs it: exit status, and which files it leaves alone.

#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
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
  bool has(const std::string& file) const { return fs::is_regular_file(path_ / file); }
  void make_folder(const std::string& name) const { fs::create_directories(path_ / name); }
  nlohmann::json json(const std::string& file) const {
    return nlohmann::json::parse(std::ifstream(path_ / file));
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

TEST_CASE("lepp-poisson --adapt: the files of a series appear in the folder, once") {
  const Folder folder;
  CHECK(folder.run("--adapt l-shape --max-unknowns 20 -o out") == 0);
  for (const std::string name : {"series.pvd", "errors.svg", "step_000.vtu", "step_006.vtu"}) {
    CAPTURE(name);
    CHECK(folder.has("out/" + name));
  }
  CHECK(folder.run("--adapt l-shape --max-unknowns 20 -o out") == 5);
  CHECK(folder.run("--adapt l-shape --max-unknowns 20 -o out --force") == 0);
  CHECK(folder.run("--adapt peak --max-unknowns 20 --estimator zz --theta 1 --solver direct") == 0);
  CHECK(folder.run("--adapt front --by delaunay --max-unknowns 500 -o boxes") == 0);
  CHECK(folder.has("boxes/series.pvd"));
  CHECK(folder.run("--adapt peak --max-unknowns 1 --json one.json") == 0);  // one step, no rate
  CHECK(folder.json("one.json")["rates"]["error"].is_null());
  CHECK(folder.run("--adapt t-shape") == 1);
  CHECK(folder.run("--adapt peak --max-unknowns 20 --error-quadrature centroids") == 0);
  CHECK(folder.run("--adapt peak --error-quadrature exact") == 1);
  for (const std::string theta : {"0", "nan", "1.01", "half"}) {
    CHECK(folder.run("--adapt peak --theta " + theta) == 1);
  }
  CHECK(folder.run("plate.ele --theta 0.5 --dirichlet 4=0") == 1);
}

TEST_CASE("lepp-poisson --adapt: an error in a late step leaves what the steps before have made") {
  const Folder folder;
  folder.make_folder("out/step_003.vtu");  // which the program cannot write then
  CHECK(folder.run("--adapt l-shape --max-unknowns 100 -o out --json report.json") == 5);
  for (const std::string name : {"series.pvd", "errors.svg", "step_002.vtu"}) {
    CAPTURE(name);
    CHECK(folder.has("out/" + name));
  }
  const auto report = folder.json("report.json");
  CHECK(report["steps"].size() == 3);
  CHECK(report.contains("failure"));
}

TEST_CASE("lepp-poisson --adapt: --force leaves no step of an earlier, longer series") {
  const Folder folder;
  CHECK(folder.run("--adapt l-shape --max-unknowns 100 -o out") == 0);
  CHECK(folder.has("out/step_009.vtu"));
  CHECK(folder.run("--adapt l-shape --max-unknowns 20 -o out --force --json short.json") == 0);
  const std::size_t steps = folder.json("short.json")["steps"].size();
  CHECK(steps < 9);
  CHECK(folder.has("out/step_00" + std::to_string(steps - 1) + ".vtu"));
  CHECK_FALSE(folder.has("out/step_00" + std::to_string(steps) + ".vtu"));
  CHECK_FALSE(folder.has("out/step_009.vtu"));
}

TEST_CASE("lepp-poisson: the report replaces no other output of the run") {
  const Folder folder;
  for (const std::string json :
       {"out/errors.svg", "out/../out/series.pvd", "./out/step_000.vtu", "out"}) {
    CAPTURE(json);
    CHECK(folder.run("--adapt l-shape --max-unknowns 20 -o out --force --json " + json) == 5);
  }
  CHECK(folder.run("--adapt l-shape --max-unknowns 20 -o out --json out/report.json") == 0);
  CHECK(folder.run("plate.ele --dirichlet 4=0 -o u.vtu --json u.vtu") == 5);
}

TEST_CASE("lepp-poisson refuses options that would have no effect") {
  const Folder folder;
  for (const std::string option : {"--method fv", "--diffusion 4=2", "--dirichlet 4=0",
                                   "--allow-inadmissible", "--source 4=1"}) {
    for (const std::string problem :
         {"--adapt l-shape --max-unknowns 20 ", "--convergence ", "--maximum-principle "}) {
      CAPTURE(option);
      CHECK(folder.run(problem + option) == 1);
    }
  }
  CHECK(folder.run("--adapt l-shape --max-unknowns 20 --folder out") == 1);
  CHECK(folder.run("plate.ele --dirichlet 4=0 --folder out") == 1);
  CHECK(folder.run("--maximum-principle -o out.vtu") == 1);
}

TEST_CASE("lepp-poisson: output that is lost is an error") {
  const Folder folder;
  for (const std::string options :
       {"--adapt l-shape --max-unknowns 100", "--adapt l-shape --max-unknowns 100 --json -",
        "plate.ele --dirichlet 4=0", "plate.ele --dirichlet 4=0 --json -"}) {
    CAPTURE(options);
    CHECK(folder.run(options + " > /dev/full 2>/dev/null #") == 5);
  }
}

TEST_CASE("lepp-poisson --adapt: a loop that ends before --max-unknowns has missed its goal") {
  const Folder folder;
  CHECK(folder.run("--adapt kellogg --by delaunay --estimator zz --theta 0.01 --max-unknowns 3000 "
                   "--json report.json") == 3);
  CHECK(folder.json("report.json")["steps"].back()["unknowns"] < 3000);
}

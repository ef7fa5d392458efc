#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <exception>

#include "adaptive_problems.hpp"
#include "commands.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/geometry/predicates.hpp"

namespace lepp::demo {
namespace {

constexpr const char* examples = R"(Examples:
  lepp-poisson plate.msh --dirichlet left=0 --dirichlet right=1 -o u.vtu
  lepp-poisson wall.msh --method fv --diffusion brick=0.6 --diffusion wool=0.04 \
      --dirichlet inside=293 --robin outside=25,268 -o wall.vtu
  lepp-poisson --convergence --folder out --json -
  lepp-poisson --maximum-principle --folder out
  lepp-poisson --adapt l-shape --max-unknowns 50000 -o out
  lepp-poisson --adapt kellogg --estimator zz --theta 0.3
  lepp-poisson --adapt l-shape --theta 1 --error-quadrature centroids
  lepp-poisson --adapt front --by delaunay -o out

GROUP is the name or the tag of a physical group. F, V and G are numbers or sums such as
1+2*x-0.5*y. A boundary without a condition lets nothing through. Where two --dirichlet groups
meet, the first one given holds.)";

struct Choice {
  bool convergence = false, maximum_principle = false;
};

/// CLI::Range lets nan pass.
CLI::Validator number_from(double least, double most) {
  return {[=](const std::string& text) {
            double value = 0;
            const char* end = text.data() + text.size();
            const auto read = std::from_chars(text.data(), end, value);
            const bool fits =
                read.ec == std::errc() && read.ptr == end && value >= least && value <= most;
            return fits ? std::string()
                        : fmt::format("'{}' is no number from {} to {}", text, least, most);
          },
          fmt::format("FLOAT in [{} - {}]", least, most)};
}

CLI::Option* describe_adapt(CLI::App& app, CommandLine& line) {
  auto* adapt = app.add_option("--adapt", line.adapt,
                               "solve, estimate, mark and bisect on one of these problems; -o "
                               "names a folder for a diagram and a series of .vtu files")
                    ->type_name("PROBLEM")
                    ->check(CLI::IsMember(adaptive_problem_names()));
  app.add_option("--by", line.by,
                 "bisect: finite elements on bisected triangles; delaunay: finite volumes on "
                 "LEPP-Delaunay meshes, each certified")
      ->capture_default_str()
      ->check(CLI::IsMember({"bisect", "delaunay"}))
      ->needs(adapt);
  app.add_option("--estimator", line.estimator, "of the adaptive loop: jumps, or averages")
      ->capture_default_str()
      ->check(CLI::IsMember({"residual", "zz"}))
      ->needs(adapt);
  app.add_option("--theta", line.theta,
                 "mark the fewest triangles with this part of the sum of eta^2; 1: all")
      ->capture_default_str()
      ->check(number_from(0.01, 1))
      ->needs(adapt);
  app.add_option("--max-unknowns", line.max_unknowns, "the first mesh with as many is the last")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}))
      ->needs(adapt);
  app.add_option("--solver", line.solver,
                 "multigrid, on the forest or on the earlier meshes; or a factorisation")
      ->capture_default_str()
      ->check(CLI::IsMember({"multigrid", "direct"}))
      ->needs(adapt);
  app.add_option("--error-quadrature", line.error_quadrature,
                 "graded: the true error, also at singular points; centroids: of 16 equal parts of "
                 "each triangle, as some published figures are")
      ->capture_default_str()
      ->check(CLI::IsMember({"graded", "centroids"}))
      ->needs(adapt);
  return adapt;
}

void describe(CLI::App& app, CommandLine& line, Choice& choice) {
  app.footer(examples);
  auto* mesh = app.add_option("mesh", line.mesh, "the mesh, .msh or .ele");
  std::vector<CLI::Option*> of_a_mesh;  // without effect on the problems of the program's own
  of_a_mesh.push_back(app.add_option("--method", line.method, "fe: P1 elements; fv: Voronoi boxes")
                          ->default_val("fe")
                          ->check(CLI::IsMember({"fe", "fv"})));
  const auto repeated = [&](const char* name, std::vector<std::string>& values, const char* shape,
                            const char* what) {
    of_a_mesh.push_back(app.add_option(name, values, what)
                            ->type_name(shape)
                            ->take_all()
                            ->allow_extra_args(false));  // GROUP=VALUE once per option
  };
  repeated("--diffusion", line.groups.diffusion, "GROUP=D", "D in a surface group (1 if none)");
  repeated("--source", line.groups.source, "GROUP=F", "f in a surface group");
  repeated("--dirichlet", line.groups.dirichlet, "GROUP=V", "u = V on a curve or point group");
  repeated("--neumann", line.groups.neumann, "GROUP=G", "D du/dn = G on a curve group");
  repeated("--robin", line.groups.robin, "GROUP=ALPHA,V", "D du/dn = ALPHA (V - u)");
  auto* output = app.add_option("-o,--output", line.output, "write the solution as .vtu");
  app.add_option("--json", line.json, "write a report for machines; - is the standard output");
  app.add_flag("--force", line.force, "overwrite the solution of an earlier run");
  of_a_mesh.push_back(app.add_flag("--allow-inadmissible", line.allow_inadmissible,
                                   "finite volumes on any mesh: the solution may be wrong"));
  auto* convergence = app.add_flag("--convergence", choice.convergence,
                                   "measure the orders of both methods on six meshes");
  auto* principle = app.add_flag("--maximum-principle", choice.maximum_principle,
                                 "show what obtuse angles at the boundary do");
  auto* folder = app.add_option("--folder", line.folder, "where these two write their files");
  auto* adapt = describe_adapt(app, line);
  convergence->excludes(mesh)->excludes(principle)->excludes(adapt);
  principle->excludes(mesh)->excludes(adapt);
  adapt->excludes(mesh);
  for (CLI::Option* option : of_a_mesh) {
    for (CLI::Option* other : {convergence, principle, adapt}) other->excludes(option);
  }
  for (CLI::Option* other : {convergence, principle}) other->excludes(output);
  for (CLI::Option* other : {mesh, adapt}) other->excludes(folder);
}

ExitStatus status_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::input:
      return bad_input;
    case ErrorKind::refused:
      return refused;
    case ErrorKind::output:
      return not_written;
  }
  return our_bug;
}

ExitStatus tell_lost_output() {
  fmt::print(stderr,
             "lepp-poisson: standard output could not be written: look where it is sent "
             "to\n");
  return not_written;
}

ExitStatus run(const CommandLine& line, const Choice& choice) {
  if (choice.convergence) return run_convergence_study(line);
  if (choice.maximum_principle) return run_maximum_principle(line);
  if (!line.adapt.empty()) return run_adapt(line);
  return run_solve(line);
}

}  // namespace
}  // namespace lepp::demo

int main(int argc, char** argv) {
  using namespace lepp::demo;
  CommandLine line;
  Choice choice;
  CLI::App app{"Solves -div(D grad u) = f on a mesh by finite elements or finite volumes."};
  describe(app, line, choice);
  try {
    app.parse(argc, argv);
    if (line.mesh.empty() && line.adapt.empty() && !choice.convergence &&
        !choice.maximum_principle) {
      throw CLI::RequiredError("MESH, --adapt, --convergence or --maximum-principle");
    }
    check_form(line.groups);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : usage;
  } catch (const lepp::InputError& error) {
    fmt::print(stderr, "lepp-poisson: {}\n", error.what());
    return usage;
  }
  try {
    if (!lepp::predicates_self_test()) {
      fmt::print(stderr, "lepp-poisson: this build breaks floating-point arithmetic\n");
      return our_bug;
    }
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size becomes an error of the writer
    const ExitStatus status = run(line, choice);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return tell_lost_output();
    return status;
  } catch (const lepp::Error& error) {
    fmt::print(stderr, "lepp-poisson: {}\n", error.what());
    return status_of(error.kind());
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return tell_lost_output();  // fmt throws an error of its own
    fmt::print(stderr, "lepp-poisson: internal error: {}\n", error.what());
    return our_bug;
  }
}

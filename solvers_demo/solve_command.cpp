#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/gmsh_import.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/io/vtu.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "poisson_fe.hpp"
#include "poisson_fv.hpp"

namespace lepp::demo {
namespace {

namespace fs = std::filesystem;

Mesh read_mesh(const std::string& file) {
  const std::string kind = fs::path(file).extension().string();
  if (kind == ".ele") return mesh_from_triangles(read_ele(file)).mesh;
  if (kind != ".msh") {
    throw InputError(file, "is neither a .msh nor an .ele file",
                     "make a mesh with `lepp mesh " + file + " -o mesh.msh`");
  }
  const GmshInput input = read_gmsh(file);
  for (const std::string& warning : input.warnings) {
    fmt::print(stderr, "lepp-poisson: {}: {}\n", file, warning);
  }
  if (input.triangles) return mesh_from_triangles(*input.triangles).mesh;
  throw InputError(file, "holds no triangles",
                   "make a mesh with `lepp mesh " + file + " -o mesh.msh`");
}

/// A target that is also the input, or would be lost, is refused before any work is done.
void check_target(const std::string& target, const std::string& mesh, bool overwrite) {
  std::error_code ignored;  // one of them does not exist: they differ
  if (!target.empty() && fs::equivalent(target, mesh, ignored)) {
    throw OutputError(target, "is also the input", "give another file name");
  }
  if (!overwrite && fs::is_regular_file(target, ignored)) {
    throw OutputError(target, "exists already", "choose another name, or add --force");
  }
}

Solution solve_by(const CommandLine& line, const Mesh& mesh, const VoronoiBoxes& boxes,
                  const Certificate& certificate, const PoissonProblem& problem) {
  if (line.method == "fe") return solve_fe(mesh, problem);
  if (!certificate.admissible && !line.allow_inadmissible) {
    throw InputError(line.mesh, "is not admissible for finite volumes: " + certificate.summary(),
                     "mesh it with `lepp mesh`, or accept a wrong solution with "
                     "--allow-inadmissible");
  }
  return solve_fv(mesh, boxes, problem);
}

std::string title_of(const CommandLine& line) {
  return line.method == "fe" ? "P1 finite elements" : "finite volumes on Voronoi boxes";
}

void print_report(const CommandLine& line, const Mesh& mesh, const Certificate& certificate,
                  const PoissonProblem& problem, const Solution& solution, double seconds) {
  fmt::print("{}: {} vertices, {} triangles, {}\n", line.mesh, mesh.vertex_count(),
             mesh.triangle_count(), certificate.admissible ? "admissible" : "NOT admissible");
  fmt::print("  {}, {} unknowns, {:.3f} s\n", title_of(line), solution.unknowns, seconds);
  fmt::print("  u lies between {:.6g} and {:.6g}\n", solution.u.minCoeff(), solution.u.maxCoeff());
  for (std::size_t i = 0; i < problem.dirichlet.size(); ++i) {
    fmt::print("  flow into the domain through \"{}\": {:.8g}\n", problem.dirichlet[i].part.name,
               solution.inflow[i]);
  }
  if (!line.output.empty()) fmt::print("  wrote {}\n", line.output);
}

std::string json_report(const CommandLine& line, const Mesh& mesh, const Certificate& certificate,
                        const PoissonProblem& problem, const Solution& solution, double seconds) {
  nlohmann::ordered_json report{{"schema_version", 1},
                                {"mesh", line.mesh},
                                {"method", line.method},
                                {"vertices", mesh.vertex_count()},
                                {"triangles", mesh.triangle_count()},
                                {"admissible", certificate.admissible},
                                {"unknowns", solution.unknowns},
                                {"min", solution.u.minCoeff()},
                                {"max", solution.u.maxCoeff()},
                                {"inflow", nlohmann::ordered_json::object()},
                                {"seconds", seconds}};
  for (std::size_t i = 0; i < problem.dirichlet.size(); ++i) {
    report["inflow"][problem.dirichlet[i].part.name] = solution.inflow[i];
  }
  return report.dump(2) + "\n";
}

}  // namespace

void write_json(const std::string& where, const std::string& text) {
  if (where == "-") {
    fmt::print("{}", text);
    return;
  }
  AtomicFiles files;
  files.add(where) << text;
  files.commit();
}

bool is_same_place(const fs::path& a, const fs::path& b) {
  return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
}

fs::path make_folder(const std::string& name) {
  std::error_code error;
  fs::create_directories(name, error);
  if (error) throw OutputError(name, error.message(), "choose another folder");
  return name;
}

ExitStatus run_solve(const CommandLine& line) {
  check_target(line.output, line.mesh, line.force);
  if (line.json != "-") check_target(line.json, line.mesh, true);  // a report may be replaced
  if (!line.json.empty() && !line.output.empty() && is_same_place(line.json, line.output)) {
    throw OutputError(line.json, "is named for two outputs", "give --json another name");
  }
  const Mesh mesh = read_mesh(line.mesh);
  const PoissonProblem problem = problem_from(line.groups, mesh);
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  const Certificate certificate = certify(mesh, boxes);

  const auto start = std::chrono::steady_clock::now();
  const Solution solution = solve_by(line, mesh, boxes, certificate, problem);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  if (!line.output.empty()) {
    write_vtu(mesh, line.output, {{{"u", {solution.u.begin(), solution.u.end()}}}, {}});
  }
  if (line.json != "-") print_report(line, mesh, certificate, problem, solution, seconds);
  if (!line.json.empty()) {
    write_json(line.json, json_report(line, mesh, certificate, problem, solution, seconds));
  }
  return done;
}

}  // namespace lepp::demo

#include <memory>

#include "commands.hpp"
#include "inputs.hpp"
#include "lepp/triangulation/join_segments.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "outputs.hpp"
#include "stopwatch.hpp"

namespace lepp::cli {

namespace {

struct CheckCommand {
  std::filesystem::path mesh;
  MeshClaims claims;
  double min_angle_deg = 0;
  bool admissible = false, quiet = false;
  std::string json;
};

// Triangles below the bound that the input forces, as far as a mesh shows its input.
std::vector<Unfinished> forced(const Mesh& mesh, double min_angle_deg) {
  std::vector<Unfinished> found;
  const InputReasons input(mesh);
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    if (!is_below(mesh, t, min_angle_deg)) continue;
    if (const auto reason = input.of(t)) found.push_back({t, *reason});
  }
  return found;
}

int run(CheckCommand& command) {
  const auto start = Clock::now();
  check_report_target(command.json, {command.mesh});
  RunReport report;
  report.input = command.mesh.string();
  Mesh mesh = read_mesh(command.mesh, report.warnings).mesh;
  join_segments_in_line(mesh);  // a file does not tell Steiner points from those of the input
  report.seconds.read = seconds_since(start);
  if (command.min_angle_deg > 0) {
    command.claims.min_angle_deg = command.min_angle_deg;
    command.claims.unfinished = forced(mesh, command.min_angle_deg);
    report.below_bound = count_reasons(command.claims.unfinished);
  }
  const MeshReport checked = validate(mesh, command.claims);
  report.seconds.check = seconds_since(start) - report.seconds.read;
  const Certificate certificate = certify(mesh);
  report.seconds.voronoi = seconds_since(start) - report.seconds.read - report.seconds.check;
  report.quality = measure(mesh);
  report.input_vertices = mesh.vertex_count();
  report.admissible = certificate.admissible;
  report.offending_edges = offending_edges(mesh, certificate);
  const bool obtuse = report.quality.obtuse_constrained.exact > 0;
  report.valid = checked.valid() && (certificate.admissible || !command.admissible) &&
                 (!obtuse || !command.claims.nonobtuse);
  report.violations = checked.violations;
  report.groups = group_figures(mesh);
  report.seconds.total = seconds_since(start);
  report.peak_memory_bytes = peak_memory_bytes();
  print_report(report, command.json, command.quiet);
  return *report.valid ? done : unfinished;
}

}  // namespace

void add_check_command(CLI::App& app, int& status) {
  const auto command = std::make_shared<CheckCommand>();
  command->claims.delaunay = false;
  CLI::App& check =
      *app.add_subcommand("check", "Check a mesh: status 0 if all that is asked holds");
  check.add_option("MESH", command->mesh, ".msh or .ele")->required();
  check.add_flag("--delaunay", command->claims.delaunay,
                 "every unconstrained edge must be locally Delaunay (exact)");
  check.add_flag("--nonobtuse", command->claims.nonobtuse,
                 "no angle above 90 degrees opposite a boundary, interface or line (exact)");
  check.add_flag("--admissible", command->admissible,
                 "every Voronoi box must be admissible, region by region");
  check
      .add_option("--min-angle", command->min_angle_deg,
                  "every angle must reach it, but in wedges of constrained edges below 60 degrees")
      ->check(CLI::Range(0.0, 60.0));
  check
      .add_option("--max-angle", command->claims.max_angle_deg,
                  "no angle of any triangle may be above it (exact for 90)")
      ->check(CLI::Range(60.0, 180.0));
  check.add_option("--json", command->json, "write the report as JSON to a file, or - for stdout");
  check.add_flag("-q,--quiet", command->quiet, "no report on the terminal");
  check.footer(
      "Example:\n  lepp check plate.msh --delaunay --nonobtuse --admissible --min-angle 30");
  check.callback([command, &status] { status = run(*command); });
}

}  // namespace lepp::cli

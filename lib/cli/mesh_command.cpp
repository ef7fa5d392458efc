#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "interrupt.hpp"
#include "outputs.hpp"
#include "pipeline.hpp"
#include "stopwatch.hpp"
#include "validators.hpp"

namespace lepp::cli {

namespace {

struct MeshCommand {
  std::filesystem::path input;
  OutputOptions output;
  MeshOptions mesh;
  GmshOptions gmsh;
  std::string json;
  bool no_nonobtuse = false, split_crossings = false, allow_unfinished = false, quiet = false;
};

int cancel(RunReport& report) {
  report.goal_reached = false;
  report.warnings.push_back("cancelled; nothing was written");
  return refused;
}

int run(MeshCommand& command) {
  const auto start = Clock::now();
  const Files inputs{command.input, command.mesh.sizes.file};
  check_mesh_target(command.output, inputs);
  check_report_target(command.json, inputs, files_of(command.output.target));
  command.mesh.nonobtuse = !command.no_nonobtuse;
  command.mesh.triangulation.crossings =
      command.split_crossings ? Crossings::split : Crossings::refuse;
  command.gmsh.keep_going = [] { return !interrupted(); };
  const Input input = read_input(command.input, command.gmsh);
  const double reading = seconds_since(start);
  Meshed meshed = make_mesh(input, command.mesh);
  RunReport& report = meshed.report;
  report.input = command.input.string();
  report.seconds.read = reading;

  int status = done;
  if (!*report.valid) status = bug;
  else if (interrupted()) status = cancel(report);
  else if (!*report.goal_reached) status = unfinished;
  if (status == done || (status == unfinished && command.allow_unfinished)) {
    const auto writing = Clock::now();
    write_mesh(meshed.mesh, command.output);
    report.output = command.output.target.string();
    report.seconds.write = seconds_since(writing);
  } else if (status == unfinished) {
    report.warnings.push_back(
        "the goal was not reached, so nothing was written; "
        "--allow-unfinished writes the valid mesh all the same");
  }
  report.seconds.total = seconds_since(start);
  report.peak_memory_bytes = peak_memory_bytes();
  if (command.quiet && status == unfinished && report.output.empty()) {
    std::fprintf(stderr, "lepp: %s: %s\n", report.input.c_str(), report.warnings.back().c_str());
  }
  print_report(report, command.json, command.quiet);
  return status;
}

// Options that would have no effect.
void refuse_ignored(const CLI::App& app, const MeshCommand& command) {
  refuse_repeated_regions(command.mesh.sizes);
  const Placement placement = command.mesh.refine.placement;
  if (app.count("--max-angle") > 0 &&
      (placement == Placement::centroid || placement == Placement::midpoint)) {
    throw CLI::ValidationError("--max-angle", "needs --placement offcentre or best");
  }
  if (command.mesh.method != Method::paper) return;
  for (const std::string option : {"--effort", "--placement", "--max-angle"}) {
    if (app.count(option) == 0) continue;
    throw CLI::ValidationError(option, "goes with --method unified only");
  }
}

void add_quality_options(CLI::App& app, MeshCommand& command) {
  RefineOptions& refine = command.mesh.refine;
  app.add_option("--min-angle", refine.min_angle_deg, "smallest angle wanted, 0 to 45 degrees")
      ->check(number_from(0, 45))
      ->capture_default_str();
  app.add_option("--max-angle", refine.max_angle_deg,
                 "largest angle of any triangle, 90 to 180 degrees; 90: no obtuse triangle at all")
      ->check(number_from(90, 180));
  add_size_options(app, command.mesh.sizes, refine);
  app.add_option("--max-vertices", refine.max_vertices,
                 "budget of vertices (default: 50 times what input and sizes suggest)")
      ->check(whole_number_from(1));
  static const std::vector<std::pair<std::string, Method>> methods{{"unified", Method::unified},
                                                                   {"paper", Method::paper}};
  app.add_option("--method", command.mesh.method,
                 "unified: angles and obtuse angles in one loop; paper: the paper's two steps")
      ->transform(choice_of(methods));
  static const std::vector<std::pair<std::string, Placement>> placements{
      {"centroid", Placement::centroid},
      {"midpoint", Placement::midpoint},
      {"offcentre", Placement::offcentre},
      {"best", Placement::best}};
  app.add_option(
         "--placement", refine.placement,
         "centroid, midpoint, offcentre or best: where a new point goes (default offcentre)")
      ->transform(choice_of(placements));
  static const std::vector<std::pair<std::string, Effort>> efforts{
      {"fast", Effort::fast}, {"normal", Effort::normal}, {"best", Effort::best}};
  app.add_option("--effort", refine.effort,
                 "fast, normal or best: time spent on fewer vertices (default normal)")
      ->transform(choice_of(efforts));
  app.add_flag("--no-nonobtuse", command.no_nonobtuse,
               "leave obtuse angles opposite boundary and interface edges");
}

}  // namespace

void add_mesh_command(CLI::App& app, int& status) {
  const auto command = std::make_shared<MeshCommand>();
  CLI::App& mesh = *app.add_subcommand("mesh", "Make a mesh, or improve one, and certify it");
  mesh.add_option("IN", command->input, ".geo, .msh, .poly, .node or .ele")->required();
  mesh.add_option("-o,--output", command->output.target, ".msh, .vtu or .ele")->required();
  add_quality_options(mesh, *command);
  add_gmsh_options(mesh, command->gmsh);
  mesh.add_flag("--split-crossings", command->split_crossings,
                "give crossing segments a common point instead of refusing them");
  mesh.add_flag("--certify", command->mesh.certify,
                "certify the Voronoi boxes even with --min-angle 0 --no-nonobtuse");
  mesh.add_option("--threads", command->mesh.triangulation.threads,
                  "threads for large inputs; the mesh does not depend on it (default: as many as "
                  "the machine has; at most two are used)");
  mesh.add_flag("--remesh", command->mesh.remesh,
                "of a mesh keep only outline, interfaces and lines, and start anew");
  add_output_options(mesh, command->output, command->json, command->allow_unfinished,
                     command->quiet);
  mesh.footer(
      "Examples:\n"
      "  lepp mesh plate.geo -o plate.msh\n"
      "  lepp mesh plate.geo -o plate.msh --max-edge 0.05 --json report.json\n"
      "  lepp mesh plate.geo -o plate.msh --size-file wells.txt --region-edge copper=0.1\n"
      "  lepp mesh old.msh -o better.msh --min-angle 28\n"
      "  lepp mesh plate.poly -o plate.ele --method paper");
  mesh.callback([command, &mesh, &status] {
    refuse_ignored(mesh, *command);
    status = run(*command);
  });
}

}  // namespace lepp::cli

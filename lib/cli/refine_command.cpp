#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "inputs.hpp"
#include "interrupt.hpp"
#include "lepp/bisection/refine_where.hpp"
#include "lepp/bisection/region.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/size_file.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/refine/size_field.hpp"
#include "lepp/triangulation/boundary_meetings.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "outputs.hpp"
#include "regions.hpp"
#include "stopwatch.hpp"
#include "validators.hpp"

namespace lepp::cli {

namespace {

enum class By { bisect, delaunay };

constexpr std::size_t most_by_bisection = 10'000'000;  // vertices, if nothing else is said

struct RefineCommand {
  std::filesystem::path input, size_file;
  OutputOptions output;
  std::vector<std::string> regions;
  double max_edge = std::numeric_limits<double>::infinity();
  double grading = 0.25;
  By by = By::bisect;
  BisectionRule rule = BisectionRule::longest_edge;
  double min_angle_deg = 30;
  std::optional<std::size_t> max_vertices;
  unsigned threads = 2;
  std::string json;
  bool allow_unfinished = false, quiet = false;
};

// What is asked of each triangle: where it meets a region, an edge below max_edge; and everywhere
// edges no longer than the size field says.
class Wanted {
 public:
  explicit Wanted(const RefineCommand& command)
      : max_edge_(command.max_edge), grading_(command.grading) {
    for (const std::string& text : command.regions) regions_.push_back(read_region(text));
    if (!command.size_file.empty()) {
      field_ = SizeField(read_size_file(command.size_file), command.grading);
    }
  }

  bool is_too_large(const Mesh& mesh, TriangleId t) const {
    const double size = diameter(mesh, t);
    const auto corners = mesh.corners(t);
    if (!(size < max_edge_) && is_in_region(corners)) return true;
    if (!field_) return false;
    const auto [a, b, c] = corners;
    const double wanted = std::min({(*field_)(a), (*field_)(b), (*field_)(c)});
    return size > field_->least_within(a, b, c, wanted);
  }

  // The largest size at which a triangle is not too large, but for what size_at() says.
  double size_in(const std::array<Point, 3>& corners) const {
    const auto [a, b, c] = corners;
    const double size = is_in_region(corners) ? below_max_edge() : infinite;
    return field_ ? field_->least_within(a, b, c, size) : size;
  }

  // A size for points. A triangle that meets a region has all of its points within its diameter of
  // the region, so with a margin for what the size grows by until there it ends up below max_edge.
  double size_at(Point p) const {
    double size = field_ ? (*field_)(p) : infinite;
    const double at_region = (1 - grading_) * below_max_edge();
    if (regions_.empty()) return std::min(size, below_max_edge());
    for (const Region& region : regions_) {
      size = std::min(size, at_region + grading_ * distance(region, p));
    }
    return size;
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  // Sizes are kept if no edge is longer; below max_edge is what was asked for.
  double below_max_edge() const {
    return max_edge_ < infinite ? std::nextafter(max_edge_, 0.0) : infinite;
  }
  bool is_in_region(const std::array<Point, 3>& corners) const {
    if (regions_.empty()) return true;
    return std::ranges::any_of(regions_, [&](const Region& r) { return meets(r, corners); });
  }

  double max_edge_, grading_;
  std::vector<Region> regions_;
  std::optional<SizeField> field_;
};

Reason reason_of(const Mesh& mesh, const RefineCommand& command) {
  if (interrupted()) return Reason::cancelled;
  return mesh.vertex_count() >= command.max_vertices.value_or(most_by_bisection)
             ? Reason::budget
             : Reason::size_floor;
}

// Triangles that are still too large, and why.
RefineReport bisect(Mesh& mesh, const RefineCommand& command, const Wanted& wanted) {
  RefineReport report;
  Progress progress;
  WhereOptions options;
  options.bisect.threads = command.threads;
  options.bisect.max_vertices = command.max_vertices.value_or(most_by_bisection);
  options.progress = [&](std::size_t vertices) { return progress(vertices); };
  const std::size_t before = mesh.vertex_count();
  Forest forest(std::move(mesh), command.rule);
  const auto is_to_be_cut = [&](const Mesh& m, TriangleId t) { return wanted.is_too_large(m, t); };
  report.goal_reached = refine_where(forest, is_to_be_cut, options).finished;
  mesh = std::move(forest).take_mesh();
  report.steiner_points = mesh.vertex_count() - before;
  if (report.goal_reached) return report;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (!wanted.is_too_large(mesh, TriangleId(i))) continue;
    report.unfinished.push_back({TriangleId(i), reason_of(mesh, command)});
  }
  return report;
}

RefineReport insert(Mesh& mesh, const RefineCommand& command, const Wanted& wanted) {
  Progress progress;
  RefineOptions options;
  options.min_angle_deg = command.min_angle_deg;
  options.size = [&](Point p) { return wanted.size_at(p); };
  options.size_in = [&](Point a, Point b, Point c) { return wanted.size_in({a, b, c}); };
  options.max_vertices = command.max_vertices.value_or(0);  // 0: what the sizes suggest
  options.progress = [&](std::size_t vertices) { return progress(vertices); };
  make_delaunay(mesh);
  return refine(mesh, options);
}

bool is_fine_enough(const Mesh& mesh, const Wanted& wanted) {
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (wanted.is_too_large(mesh, TriangleId(i))) return false;
  }
  return true;
}

void check(const Mesh& mesh, const RefineCommand& command, const RefineReport& refined,
           RunReport& report) {
  MeshClaims claims;
  claims.delaunay = command.by == By::delaunay;
  if (command.by == By::delaunay) {
    claims.nonobtuse = true;
    if (command.min_angle_deg > 0) claims.min_angle_deg = command.min_angle_deg;
    claims.unfinished = refined.unfinished;
    const Certificate certificate = certify(mesh);
    report.admissible = certificate.admissible;
    report.offending_edges = offending_edges(mesh, certificate);
  }
  const MeshReport checked = validate(mesh, claims);
  report.valid = checked.valid();
  report.violations = checked.violations;
  if (const auto meeting = first_boundary_meeting(mesh)) {
    report.valid = false;
    report.violations.push_back({"overlap", "boundary edges that meet near " +
                                                to_text(mesh.point(mesh.origin(meeting->first)))});
  }
}

Files files_read(const RefineCommand& command) {
  Files files{command.input, command.size_file};
  for (const std::string& region : command.regions) {
    if (const auto file = polygon_file(region)) files.push_back(*file);
  }
  return files;
}

int run(RefineCommand& command) {
  const auto start = Clock::now();
  const Files inputs = files_read(command);
  check_mesh_target(command.output, inputs);
  check_report_target(command.json, inputs, files_of(command.output.target));
  const Wanted wanted(command);
  RunReport report;
  report.input = command.input.string();
  Mesh mesh = read_mesh(command.input, report.warnings).mesh;
  report.seconds.read = seconds_since(start);
  report.input_vertices = mesh.vertex_count();
  report.stages.push_back({"read", measure(mesh), 0});

  const auto refining = Clock::now();
  const RefineReport refined =
      command.by == By::bisect ? bisect(mesh, command, wanted) : insert(mesh, command, wanted);
  report.seconds.refine = seconds_since(refining);
  report.quality = measure(mesh);
  report.stages.push_back({"refine", report.quality, refined.steiner_points});
  report.steiner_points = refined.steiner_points;
  report.below_bound = count_reasons(refined.unfinished);
  report.goal_reached = refined.goal_reached && is_fine_enough(mesh, wanted);
  report.groups = group_figures(mesh);
  check(mesh, command, refined, report);

  int status = done;
  if (!*report.valid) status = bug;
  else if (interrupted()) status = refused;
  else if (!*report.goal_reached) status = unfinished;
  if (status == done || (status == unfinished && command.allow_unfinished)) {
    write_mesh(mesh, command.output);
    report.output = command.output.target.string();
  } else if (status == unfinished) {
    report.warnings.push_back(
        "the goal was not reached, so nothing was written; "
        "--allow-unfinished writes the valid mesh all the same");
  }
  report.seconds.total = seconds_since(start);
  report.peak_memory_bytes = peak_memory_bytes();
  print_report(report, command.json, command.quiet);
  return status;
}

// Options that would have no effect.
void refuse_ignored(const CLI::App& app, const RefineCommand& command) {
  const bool has_max_edge = command.max_edge < std::numeric_limits<double>::max();
  if (command.size_file.empty() && !has_max_edge) {
    throw CLI::RequiredError("--max-edge or --size-file");
  }
  if (!command.regions.empty() && !has_max_edge) {
    throw CLI::ValidationError("--in", "needs --max-edge, the size wanted there");
  }
  if (command.by == By::delaunay && app.count("--rule") > 0) {
    throw CLI::ValidationError("--rule", "goes with --by bisect only");
  }
  if (command.by == By::bisect && app.count("--min-angle") > 0) {
    throw CLI::ValidationError("--min-angle", "goes with --by delaunay only");
  }
}

void add_options(CLI::App& refine, RefineCommand& command) {
  refine.add_option("--in", command.regions,
                    "a region: \"disc X Y R\", \"box X0 Y0 X1 Y1\" or \"polygon FILE\"; may be "
                    "given again (default: all of the mesh)");
  refine
      .add_option("--max-edge", command.max_edge,
                  "edges of triangles that meet the region become shorter than this")
      ->check(number_above_zero());
  refine.add_option("--size-file", command.size_file,
                    "points with sizes, lines 'x y h': edges near (x, y) at most h long");
  refine
      .add_option("--grading", command.grading,
                  "how fast sizes grow with the distance from points and, by delaunay, regions")
      ->check(number_from(0, 0.9))
      ->capture_default_str();
  refine
      .add_option("--by", command.by,
                  "bisect: triangles are halved, nested in the old ones; delaunay: points are "
                  "inserted, the mesh stays admissible (default bisect)")
      ->transform(choice_of<By>({{"bisect", By::bisect}, {"delaunay", By::delaunay}}));
  refine.add_option("--rule", command.rule, "which edge bisection cuts (default longest-edge)")
      ->transform(choice_of<BisectionRule>({{"longest-edge", BisectionRule::longest_edge},
                                            {"newest-vertex", BisectionRule::newest_vertex}}));
  refine.add_option("--min-angle", command.min_angle_deg, "smallest angle wanted, by delaunay")
      ->check(number_from(0, 45))
      ->capture_default_str();
  refine
      .add_option("--max-vertices", command.max_vertices,
                  "stop at so many vertices (default: by bisect 10 million, by delaunay 50 times "
                  "what mesh and sizes suggest)")
      ->check(whole_number_from(1));
}

}  // namespace

void add_refine_command(CLI::App& app, int& status) {
  const auto command = std::make_shared<RefineCommand>();
  CLI::App& refine = *app.add_subcommand("refine", "Make a mesh finer, all of it or in a region");
  refine.add_option("IN", command->input, ".msh or .ele")->required();
  refine.add_option("-o,--output", command->output.target, ".msh, .vtu or .ele")->required();
  add_options(refine, *command);
  refine.add_option("--threads", command->threads,
                    "at most so many; the mesh does not depend on it");
  add_output_options(refine, command->output, command->json, command->allow_unfinished,
                     command->quiet);
  refine.footer(
      "Edges on curved boundaries are cut along their chords, for mesh files do not hold the\n"
      "curves. For a finer curve, mesh the geometry anew: lepp mesh.\n\n"
      "Examples:\n"
      "  lepp refine plate.msh -o finer.msh --max-edge 0.02\n"
      "  lepp refine plate.msh -o finer.msh --in \"disc 0.3 0.4 0.1\" --max-edge 0.01\n"
      "  lepp refine plate.msh -o finer.msh --in \"box 0 0 1 0.2\" --max-edge 0.01 --by delaunay");
  refine.callback([command, &refine, &status] {
    refuse_ignored(refine, *command);
    status = run(*command);
  });
}

}  // namespace lepp::cli

#include "maximum_principle.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "lepp/io/picture.hpp"
#include "lepp/io/vtu.hpp"

namespace lepp::demo {
namespace {

constexpr double rounding = 1e-12;

bool within_data(const SchemeOutcome& scheme) {
  return scheme.lowest >= -rounding && scheme.highest <= 1 + rounding;
}

bool is_exact(const SchemeOutcome& scheme) { return scheme.linear_error <= 1e-10; }

void print_scheme(const char* name, const SchemeOutcome& scheme) {
  fmt::print("  {:<40} {:>9.4f} {:>9.4f}   {:<9} {:>9.1e}\n", name, scheme.lowest, scheme.highest,
             within_data(scheme) ? "yes" : "NO", scheme.linear_error);
}

void print_outcome(const char* title, const PlateOutcome& plate) {
  fmt::print("{}: {} vertices, {} obtuse angles face its boundary, {}\n", title,
             plate.mesh.vertex_count(), plate.obtuse_constrained,
             plate.admissible ? "admissible" : "NOT admissible");
  fmt::print("  {:<40} {:>9} {:>9}   {:<9} {:>9}\n", "scheme", "lowest", "highest", "in [0,1]",
             "error if u = x+2y");
  print_scheme("finite elements", plate.fe);
  print_scheme("finite volumes, signed edge factors", plate.fv_unclipped);
  print_scheme("finite volumes, boxes clipped", plate.fv);
}

void write_files(const std::filesystem::path& folder, const std::string& name,
                 const PlateOutcome& plate) {
  write_vtu(plate.mesh, folder / (name + ".vtu"),
            {{{"u_fe", {plate.fe.u.begin(), plate.fe.u.end()}},
              {"u_fv_unclipped", {plate.fv_unclipped.u.begin(), plate.fv_unclipped.u.end()}},
              {"u_fv", {plate.fv.u.begin(), plate.fv.u.end()}}},
             {}});
  const VoronoiBoxes boxes = voronoi_boxes(plate.mesh);
  PictureOptions options;
  options.boxes = &boxes;
  write_picture(plate.mesh, folder / (name + ".svg"), options);
}

nlohmann::ordered_json json_of(const SchemeOutcome& scheme) {
  return {{"min", scheme.lowest}, {"max", scheme.highest}, {"linear_error", scheme.linear_error}};
}

nlohmann::ordered_json json_of(const PlateOutcome& plate) {
  return {{"vertices", plate.mesh.vertex_count()},
          {"obtuse_constrained", plate.obtuse_constrained},
          {"admissible", plate.admissible},
          {"fe", json_of(plate.fe)},
          {"fv_unclipped", json_of(plate.fv_unclipped)},
          {"fv", json_of(plate.fv)}};
}

}  // namespace

ExitStatus run_maximum_principle(const CommandLine& line) {
  const std::filesystem::path folder = make_folder(line.folder);
  const ThinPlate plate = thin_plate();
  const PlateOutcome obtuse = plate_with_obtuse_boundary(plate);
  const PlateOutcome nonobtuse = plate_with_nonobtuse_boundary(plate);
  if (line.json != "-") {
    fmt::print("A thin plate, insulated below, held at 1 and at 0 elsewhere: 0 <= u <= 1.\n");
    print_outcome("Triangulated as drawn", obtuse);
    print_outcome("Meshed by lepp", nonobtuse);
    fmt::print(
        "Only the nonobtuse mesh gives schemes that are both monotone and exact for u=x+2y.\n");
  }
  write_files(folder, "plate_obtuse", obtuse);
  write_files(folder, "plate_nonobtuse", nonobtuse);
  if (!line.json.empty()) {
    const nlohmann::ordered_json report{{"obtuse", json_of(obtuse)},
                                        {"nonobtuse", json_of(nonobtuse)}};
    write_json(line.json, report.dump(2) + "\n");
  }
  const bool fails = !within_data(obtuse.fe) && !within_data(obtuse.fv_unclipped);
  const bool holds = within_data(nonobtuse.fe) && within_data(nonobtuse.fv_unclipped) &&
                     within_data(nonobtuse.fv) && is_exact(nonobtuse.fv);
  return fails && holds ? done : goal_missed;
}

}  // namespace lepp::demo

#include <memory>

#include "commands.hpp"
#include "inputs.hpp"
#include "lepp/io/file_kind.hpp"
#include "lepp/io/geo.hpp"
#include "lepp/io/poly.hpp"
#include "outputs.hpp"

namespace lepp::cli {

namespace {

struct ConvertCommand {
  std::filesystem::path input;
  OutputOptions output;
  GmshOptions gmsh;
  bool quiet = false;
};

void print_warnings(const std::vector<std::string>& warnings, bool quiet) {
  if (quiet) return;
  for (const std::string& warning : warnings)
    std::fprintf(stderr, "warning: %s\n", warning.c_str());
}

int to_geometry(const ConvertCommand& command, const std::string& kind) {
  check_target(command.output.target, {command.input}, command.output.force);
  const Input input = read_input(command.input, command.gmsh);
  print_warnings(input.warnings, command.quiet);
  if (kind == ".poly") {
    write_poly(input.pslg, command.output.target);
  } else if (input.triangles) {
    write_geo(mesh_from_triangles(*input.triangles).mesh, command.output.target);
  } else {
    write_geo(input.pslg, command.output.target);
  }
  return done;
}

int run(const ConvertCommand& command) {
  const std::string kind = file_kind(command.output.target);
  if (kind == ".poly" || kind == ".geo") return to_geometry(command, kind);
  check_mesh_target(command.output, {command.input});
  std::vector<std::string> warnings;
  const Triangulation read = read_mesh(command.input, warnings);
  print_warnings(warnings, command.quiet);
  write_mesh(read.mesh, command.output);
  return done;
}

}  // namespace

void add_convert_command(CLI::App& app, int& status) {
  const auto command = std::make_shared<ConvertCommand>();
  CLI::App& convert = *app.add_subcommand(
      "convert", "Change the format: geometry to geometry, mesh to mesh or to its outline");
  convert.add_option("IN", command->input, ".geo, .msh, .poly, .node or .ele")->required();
  convert.add_option("-o,--output", command->output.target, ".geo, .poly, .msh, .vtu or .ele")
      ->required();
  convert.add_option("--format", command->output.format, "of .msh output")
      ->check(CLI::IsMember({"msh41", "msh22"}))
      ->capture_default_str();
  add_gmsh_options(convert, command->gmsh);
  convert.add_flag("--force", command->output.force, "overwrite the output");
  convert.add_flag("-q,--quiet", command->quiet, "no warnings");
  convert.footer(
      "Examples:\n  lepp convert plate.geo -o plate.poly\n"
      "  lepp convert plate.msh -o plate.vtu\n"
      "Geometry never becomes a mesh here: that is 'lepp mesh'.");
  convert.callback([command, &status] { status = run(*command); });
}

}  // namespace lepp::cli

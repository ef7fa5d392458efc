#include <memory>

#include "commands.hpp"
#include "inputs.hpp"
#include "lepp/io/file_kind.hpp"
#include "lepp/io/picture.hpp"
#include "outputs.hpp"

namespace lepp::cli {

namespace {

struct PictureCommand {
  std::filesystem::path mesh, target;
  PictureOptions picture;
  bool boxes = false, force = false;
};

int run(PictureCommand& command) {
  if (file_kind(command.target) != ".svg") {
    throw InputError(command.target.string(), "pictures are SVG files", "name the output .svg");
  }
  check_target(command.target, {command.mesh}, command.force);
  std::vector<std::string> warnings;
  const Mesh mesh = read_mesh(command.mesh, warnings).mesh;
  VoronoiBoxes boxes;
  if (command.boxes) {
    boxes = voronoi_boxes(mesh);
    command.picture.boxes = &boxes;
  }
  write_picture(mesh, command.target, command.picture);
  return done;
}

}  // namespace

void add_picture_command(CLI::App& app, int& status) {
  const auto command = std::make_shared<PictureCommand>();
  CLI::App& picture = *app.add_subcommand("picture", "Draw a mesh as SVG");
  picture.add_option("MESH", command->mesh, ".msh or .ele")->required();
  picture.add_option("-o,--output", command->target, ".svg")->required();
  picture.add_flag("--boxes", command->boxes, "draw the Voronoi boxes over the triangles");
  picture.add_option("--width", command->picture.width, "longest side of the drawing")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  picture.add_flag("--force", command->force, "overwrite the output");
  picture.footer("Example:\n  lepp picture plate.msh -o plate.svg --boxes");
  picture.callback([command, &status] { status = run(*command); });
}

}  // namespace lepp::cli

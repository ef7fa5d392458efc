#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "describe_meetings.hpp"
#include "inputs.hpp"
#include "interrupt.hpp"
#include "lepp/geometry/text.hpp"
#include "outputs.hpp"

namespace lepp::cli {

namespace {

struct InfoCommand {
  std::filesystem::path input;
  GmshOptions gmsh;
  std::string json;
};

using Json = nlohmann::ordered_json;

Json groups_of(const Entities& entities) {
  Json groups = Json::array();
  for (std::size_t g = 0; g < entities.groups.size(); ++g) {
    const PhysicalGroup& group = entities.groups[g];
    const auto members = [&](const auto& list) {
      return std::ranges::count_if(list, [&](const auto& entity) {
        return std::ranges::find(entity.groups, GroupId(g)) != entity.groups.end();
      });
    };
    const auto count = group.dimension == 0   ? members(entities.points)
                       : group.dimension == 1 ? members(entities.curves)
                                              : members(entities.surfaces);
    groups.push_back({{"name", group.name},
                      {"dimension", group.dimension},
                      {"tag", group.tag},
                      {"entities", count}});
  }
  return groups;
}

Json describe(const Input& input) {
  const Pslg& pslg = input.pslg;
  const Entities& entities = input.triangles ? input.triangles->entities : pslg.entities;
  const std::vector<Point>& points = input.triangles ? input.triangles->points : pslg.points;
  Json info;
  info["schema_version"] = 1;
  info["kind"] = input.triangles ? "mesh" : "geometry";
  info["points"] = points.size();
  if (input.triangles) info["triangles"] = input.triangles->triangles.size();
  info["segments"] = input.triangles ? input.triangles->segments.size() : pslg.segments.size();
  info["curves"] = entities.curves.size();
  info["surfaces"] = entities.surfaces.size();
  info["holes"] = pslg.holes.size();
  if (!points.empty()) {
    const auto [x0, x1] = std::ranges::minmax(points, {}, &Point::x);
    const auto [y0, y1] = std::ranges::minmax(points, {}, &Point::y);
    info["bounding_box"] = {x0.x, y0.y, x1.x, y1.y};
  }
  info["groups"] = groups_of(entities);
  Json broken = Json::array();
  if (!input.triangles) {
    const EndsAtOnce nothing_to_lose;
    const PslgFindings findings = examine(pslg);
    for (const PslgViolation& v : findings.violations)
      broken.push_back({{"rule", v.rule}, {"where", v.where}});
    if (findings.meetings) info["meetings"] = describe_meetings(pslg, *findings.meetings);
  }
  info["violations"] = broken;
  info["warnings"] = input.warnings;
  return info;
}

std::string as_text(const Json& info) {
  std::string text;
  const auto line = [&](const std::string& name, const std::string& value) {
    text += name + std::string(name.size() < 14 ? 14 - name.size() : 1, ' ') + value + "\n";
  };
  for (const char* key :
       {"kind", "points", "triangles", "segments", "curves", "surfaces", "holes"}) {
    if (info.contains(key))
      line(key, info[key].is_string() ? info[key].get<std::string>() : info[key].dump());
  }
  if (info.contains("bounding_box")) {
    const auto& box = info["bounding_box"];
    line("bounding box", to_text(Point{box[0], box[1]}) + " to " + to_text(Point{box[2], box[3]}));
  }
  for (const auto& g : info["groups"]) {
    line("group",
         (g["name"].get<std::string>().empty() ? std::string("(no name)")
                                               : "\"" + g["name"].get<std::string>() + "\"") +
             ", dimension " + g["dimension"].dump() + ", tag " + g["tag"].dump() + ", " +
             g["entities"].dump() + (g["entities"] == 1 ? " entity" : " entities"));
  }
  if (info.contains("meetings")) {  // P3 and P4 are told there
    text += text_of_meetings(info["meetings"]);
  } else {
    for (const auto& broken : info["violations"]) line(broken["rule"], broken["where"]);
  }
  for (const auto& warning : info["warnings"]) line("warning", warning);
  return text;
}

int run(const InfoCommand& command) {
  check_report_target(command.json, {command.input});
  const Json info = describe(read_input(command.input, command.gmsh));
  if (command.json.empty()) write_text("-", as_text(info));
  else write_text(command.json, info.dump(2) + "\n");
  return done;
}

}  // namespace

void add_info_command(CLI::App& app, int& status) {
  const auto command = std::make_shared<InfoCommand>();
  CLI::App& info = *app.add_subcommand("info", "Say what a file holds, and what is wrong with it");
  info.add_option("IN", command->input, ".geo, .msh, .poly, .node or .ele")->required();
  info.add_option("--json", command->json, "as JSON to a file, or - for stdout");
  add_gmsh_options(info, command->gmsh);
  info.footer("Example:\n  lepp info plate.geo");
  info.callback([command, &status] { status = run(*command); });
}

}  // namespace lepp::cli

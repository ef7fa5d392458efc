#include "lepp/io/terrain_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lepp/geometry/triangle_measures.hpp"

namespace lepp {

namespace {

using Json = nlohmann::ordered_json;

constexpr int schema_version = 1;

template <class Value>
Json optional(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json on_hard_lines(const TerrainError& e) {
  return {{"samples", e.samples_on_hard_lines},
          {"max", e.on_hard_lines.max},
          {"max_elsewhere", e.elsewhere.max}};
}

Json error(const TerrainFigures& figures) {
  const TerrainError& e = figures.error;
  return {{"max", e.max},
          {"column", e.column},
          {"row", e.row},
          {"at", {figures.error_at.x, figures.error_at.y}},
          {"highest", e.highest},
          {"lowest", e.lowest},
          {"rms", e.rms},
          {"samples", e.samples},
          {"lost", e.lost},
          {"covered", e.covered},
          {"on_hard_lines", on_hard_lines(e)}};
}

// Before the heights were fitted to the grid.
Json unfitted(const TerrainFigures& figures) {
  if (!figures.unfitted) return {};
  return {{"max", figures.unfitted->max}, {"rms", figures.unfitted->rms}};
}

Json below_bound(const ReasonCounts& counts) {
  Json json;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    json[to_string(static_cast<Reason>(i))] = counts[i];
  }
  return json;
}

Json list_of(const std::vector<TerrainFigures>& list, bool with_problems) {
  Json json = Json::array();
  for (const TerrainFigures& figures : list) {
    json.push_back({{"name", figures.name},
                    {"output", figures.output},
                    {"vertices", figures.vertices},
                    {"triangles", figures.triangles},
                    {"min_angle_deg", figures.min_angle_deg},
                    {"below_bound", below_bound(figures.below_bound)},
                    {"error", error(figures)},
                    {"unfitted_error", unfitted(figures)}});
    if (!with_problems) continue;
    json.back()["problem"] = figures.problem.empty() ? Json() : Json(figures.problem);
  }
  return json;
}

Json prefixes(const std::optional<PrefixErrors>& p) {
  return p ? Json({{"first", p->first}, {"max_errors", p->max_errors}}) : Json();
}

Json numbers_of(const std::optional<GridWindow>& w) {
  return w ? Json({w->column, w->row, w->columns, w->rows}) : Json();
}

Json asked_for(const TerrainReport& r) {
  return {{"by", r.by},
          {"metric", r.metric},
          {"max_error", optional(r.max_error)},
          {"border_error", optional(r.border_error)},
          {"max_vertices", optional(r.max_vertices)},
          {"min_angle_deg", optional(r.min_angle_deg)},
          {"window", numbers_of(r.window)},
          {"tiles", optional(r.tiling)}};
}

Json place(Point p) { return {p.x, p.y}; }

Json in_space(const TerrainReport& r) {
  const TerrainInSpace& s = r.in_space;
  Json json{{"min_angle_deg", s.min_angle_deg}, {"mean_min_angle_deg", s.mean_min_angle_deg}};
  if (r.metric != "surface") return json;
  json["plan_angle_deg"] = s.plan_angle_deg;
  json["tame"] = s.tame;
  json["untame"] = s.untame;
  json["kept_edges"] = Json::array();
  for (const auto& [a, b, rule] : s.kept_edges) {
    json["kept_edges"].push_back(
        {{"from", place(a)}, {"to", place(b)}, {"kept_by", to_string(rule)}});
  }
  return json;
}

Json seconds(const TerrainSeconds& s) {
  return {{"read", s.read},           {"domain", s.domain}, {"simplify", s.simplify},
          {"nonobtuse", s.nonobtuse}, {"fit", s.fit},       {"measure", s.measure},
          {"check", s.check},         {"write", s.write},   {"total", s.total}};
}

}  // namespace

AngleHistogram angle_histogram(const Mesh& mesh) {
  AngleHistogram histogram{};
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const auto [a, b, c] = mesh.corners(TriangleId(i));
    const double smallest = std::ranges::min(angles_deg(a, b, c));
    const auto bin = static_cast<std::size_t>(std::max(smallest, 0.0) / 5);
    ++histogram[std::min(bin, histogram.size() - 1)];
  }
  return histogram;
}

std::string to_json(const TerrainReport& r) {
  Json json;
  json["schema_version"] = schema_version;
  json["input"] = r.input;
  json["output"] = r.whole.output;
  json["columns"] = r.columns;
  json["rows"] = r.rows;
  json["samples"] = r.samples;
  json["heights"] = {r.lowest, r.highest};
  json["asked_for"] = asked_for(r);
  json["vertices"] = r.whole.vertices;
  json["triangles"] = r.whole.triangles;
  json["error"] = error(r.whole);
  json["unfitted_error"] = unfitted(r.whole);
  json["levels"] = list_of(r.levels, false);
  json["prefixes"] = prefixes(r.prefixes);
  json["tiles"] = list_of(r.tiles, true);
  json["min_angle_deg"] = r.whole.min_angle_deg;
  json["mean_min_angle_deg"] = r.mean_min_angle_deg;
  json["max_angle_deg"] = r.max_angle_deg_found;
  json["smallest_angles"] = r.smallest_angles;
  json["in_space"] = in_space(r);
  json["below_bound"] = below_bound(r.whole.below_bound);
  json["obtuse_constrained"] = r.obtuse_constrained;
  json["admissible"] = optional(r.admissible);
  json["error_kept"] = optional(r.error_kept);
  json["goal_reached"] = r.goal_reached;
  json["valid"] = r.valid;
  json["seconds"] = seconds(r.seconds);
  json["peak_memory_bytes"] = r.peak_memory_bytes;
  json["warnings"] = r.warnings;
  json["violations"] = Json::array();
  for (const auto& [rule, where] : r.violations) {
    json["violations"].push_back({{"rule", rule}, {"where", where}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lepp

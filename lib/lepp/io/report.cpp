#include "lepp/io/report.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace lepp {

namespace {

using Json = nlohmann::ordered_json;

constexpr int schema_version = 1;

Json optional(const std::optional<bool>& answer) { return answer ? Json(*answer) : Json(); }

// Counts decided exactly, by name; the twins that forgive 1e-9 degrees go into `tolerant`.
void add_counts(Json& json, const Quality& q) {
  Json tolerant;
  const auto add = [&](const char* name, const Quality::Count& count) {
    json[name] = count.exact;
    tolerant[name] = count.tolerant;
  };
  add("obtuse_constrained", q.obtuse_constrained);
  add("obtuse_boundary", q.obtuse_boundary);
  add("obtuse_triangles", q.obtuse_triangles);
  add("non_delaunay_edges", q.non_delaunay_edges);
  add("non_delaunay_constrained", q.non_delaunay_constrained);
  json["tolerant"] = tolerant;
}

void add_quality(Json& json, const Quality& q) {
  json["vertices"] = q.vertices;
  json["triangles"] = q.triangles;
  json["min_angle_deg"] = q.min_angle_deg;
  json["mean_min_angle_deg"] = q.mean_min_angle_deg;
  json["mean_max_angle_deg"] = q.mean_max_angle_deg;
  json["max_angle_deg"] = q.max_angle_deg;
}

Json below_bound(const ReasonCounts& counts) {
  Json json;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    json[to_string(static_cast<Reason>(i))] = counts[i];
  }
  return json;
}

Json stages(const std::vector<StageFigures>& list) {
  Json json = Json::array();
  for (const auto& [name, quality, insertions] : list) {
    Json stage;
    stage["name"] = name;
    add_quality(stage, quality);
    add_counts(stage, quality);
    stage["insertions"] = insertions;
    json.push_back(stage);
  }
  return json;
}

Json seconds(const Seconds& s) {
  return {{"read", s.read},       {"triangulate", s.triangulate},
          {"refine", s.refine},   {"nonobtuse", s.nonobtuse},
          {"measure", s.measure}, {"voronoi", s.voronoi},
          {"check", s.check},     {"write", s.write},
          {"total", s.total}};
}

Json groups(const std::vector<GroupFigures>& list) {
  Json json = Json::array();
  for (const GroupFigures& g : list) {
    Json group;
    group["name"] = g.name;
    group["dimension"] = g.dimension;
    group["tag"] = g.tag;
    group["entities"] = g.entities;
    if (g.dimension == 0) group["points"] = g.measure;
    if (g.dimension == 1) group["length"] = g.measure;
    if (g.dimension == 2) group["area"] = g.measure;
    json.push_back(group);
  }
  return json;
}

Json offending_edges(const std::vector<OffendingEdge>& list) {
  Json json = Json::array();
  for (const OffendingEdge& e : list) {
    json.push_back({{"vertices", {e.k, e.l}},
                    {"from", {e.at_k.x, e.at_k.y}},
                    {"to", {e.at_l.x, e.at_l.y}},
                    {"region", e.region},
                    {"factor", e.factor},
                    {"opposite_angles_deg", e.angle_deg}});
  }
  return json;
}

Json violations(const std::vector<MeshViolation>& list) {
  Json json = Json::array();
  for (const auto& [rule, where] : list) json.push_back({{"rule", rule}, {"where", where}});
  return json;
}

// Of this program alone: what getrusage() says may be the peak of the program that started it.
std::optional<std::size_t> peak_memory_of_program() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
  }
  return std::nullopt;
}

}  // namespace

std::string to_json(const RunReport& report) {
  Json json;
  json["schema_version"] = schema_version;
  json["input"] = report.input;
  json["output"] = report.output;
  add_quality(json, report.quality);
  json["input_vertices"] = report.input_vertices;
  json["steiner_points"] = report.steiner_points;
  json["below_bound"] = below_bound(report.below_bound);
  add_counts(json, report.quality);
  json["admissible"] = optional(report.admissible);
  json["goal_reached"] = optional(report.goal_reached);
  json["valid"] = optional(report.valid);
  json["stages"] = stages(report.stages);
  json["seconds"] = seconds(report.seconds);
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  json["groups"] = groups(report.groups);
  json["warnings"] = report.warnings;
  json["offending_edges"] = offending_edges(report.offending_edges);
  json["violations"] = violations(report.violations);
  // Names from a file need not be UTF-8; bytes that are not become U+FFFD.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ReasonCounts count_reasons(const std::vector<Unfinished>& unfinished) {
  ReasonCounts counts{};
  for (const Unfinished& u : unfinished) ++counts[static_cast<std::size_t>(u.reason)];
  return counts;
}

std::vector<OffendingEdge> offending_edges(const Mesh& mesh, const Certificate& certificate) {
  std::vector<OffendingEdge> edges;
  for (const EdgeFactor& f : certificate.offending) {
    const auto& surfaces = mesh.entities().surfaces;
    const bool known = f.region.index() < surfaces.size();
    edges.push_back({mesh.base() + f.k.value, mesh.base() + f.l.value, mesh.point(f.k),
                     mesh.point(f.l),
                     known ? surfaces[f.region.index()].tag : static_cast<int>(f.region.value),
                     f.factor, f.angle_deg});
  }
  return edges;
}

std::vector<GroupFigures> group_figures(const Mesh& mesh) {
  const Entities& entities = mesh.entities();
  const std::vector<double> measures = measure_groups(mesh);
  std::vector<std::size_t> members(entities.groups.size());
  const auto count = [&](const auto& list) {
    for (const auto& entity : list) {
      for (const GroupId group : entity.groups) ++members[group.index()];
    }
  };
  count(entities.points);
  count(entities.curves);
  count(entities.surfaces);
  std::vector<GroupFigures> figures;
  for (std::size_t i = 0; i < entities.groups.size(); ++i) {
    const PhysicalGroup& group = entities.groups[i];
    figures.push_back({group.name, group.dimension, group.tag, members[i], measures[i]});
  }
  return figures;
}

std::size_t peak_memory_bytes() {
  if (const auto peak = peak_memory_of_program()) return *peak;
  struct rusage usage {};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts kilobytes
}

}  // namespace lepp

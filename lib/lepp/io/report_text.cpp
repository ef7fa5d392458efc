#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "lepp/io/report.hpp"
#include "lepp/io/report_lines.hpp"

namespace lepp {

namespace {

// One line of the table: a label and a figure per stage.
void add_row(std::string& text, const RunReport& report, std::string_view label, auto figure) {
  text += fmt::format("{:<34}", label);
  for (const StageFigures& stage : report.stages) text += fmt::format("{:>14}", figure(stage));
  text += '\n';
}

std::string degrees(double angle) { return fmt::format("{:.2f}", angle); }

std::string table(const RunReport& report) {
  if (report.stages.empty()) return {};
  std::string text;
  add_row(text, report, "", [](const StageFigures& s) { return s.name; });
  const auto quality = [&](std::string_view label, auto figure) {
    add_row(text, report, label, [&](const StageFigures& s) { return figure(s.quality); });
  };
  quality("vertices", [](const Quality& q) { return q.vertices; });
  quality("triangles", [](const Quality& q) { return q.triangles; });
  quality("min. angle", [](const Quality& q) { return degrees(q.min_angle_deg); });
  quality("mean min. angle", [](const Quality& q) { return degrees(q.mean_min_angle_deg); });
  quality("max. angle", [](const Quality& q) { return degrees(q.max_angle_deg); });
  quality("mean max. angle", [](const Quality& q) { return degrees(q.mean_max_angle_deg); });
  quality("obtuse at constrained edges",
          [](const Quality& q) { return q.obtuse_constrained.exact; });
  add_row(text, report, "inserted vertices", [](const StageFigures& s) { return s.insertions; });
  return text + '\n';
}

// "3", or "3 (1 beyond 1e-9 degrees)" where rounding explains some of it.
std::string count(const Quality::Count& c) {
  if (c.exact == c.tolerant) return fmt::format("{}", c.exact);
  return fmt::format("{} ({} beyond 1e-9 degrees)", c.exact, c.tolerant);
}

std::string summary(const RunReport& report) {
  const Quality& q = report.quality;
  std::string text;
  if (!report.input.empty()) add_line(text, "input", report.input);
  if (!report.output.empty()) add_line(text, "output", report.output);
  add_line(text, "vertices, triangles", fmt::format("{}, {}", q.vertices, q.triangles));
  if (report.steiner_points > 0) {
    add_line(text, "Steiner points",
             fmt::format("{} added to {}", report.steiner_points, report.input_vertices));
  }
  add_line(text, "angles",
           fmt::format("{:.2f} to {:.2f} degrees", q.min_angle_deg, q.max_angle_deg));
  if (report.goal_reached) {
    add_line(text, "goal reached", answer(*report.goal_reached));
    add_line(text, "triangles below the bound", counted<Reason>(report.below_bound));
  }
  add_line(text, "obtuse at constrained edges", count(q.obtuse_constrained));
  add_line(text, "obtuse triangles", count(q.obtuse_triangles));
  add_line(text, "non-Delaunay edges", count(q.non_delaunay_edges));
  if (report.admissible) add_line(text, "admissible Voronoi boxes", answer(*report.admissible));
  if (report.valid) add_line(text, "valid", answer(*report.valid));
  return text;
}

std::string group_lines(const RunReport& report) {
  constexpr const char* kinds[] = {"points", "length", "area"};
  std::string text;
  for (const GroupFigures& g : report.groups) {
    const std::string name =
        g.name.empty() ? fmt::format("{}", g.tag) : fmt::format("{} \"{}\"", g.tag, g.name);
    add_line(text, fmt::format("group {}", name),
             fmt::format("{} {:.10g} of {} {}", kinds[std::clamp(g.dimension, 0, 2)], g.measure,
                         g.entities, g.entities == 1 ? "entity" : "entities"));
  }
  return text;
}

constexpr std::size_t shown_at_most = 20;

template <class List>
void add_list(std::string& text, const List& list, auto line_of) {
  for (std::size_t i = 0; i < std::min(list.size(), shown_at_most); ++i) {
    text += line_of(list[i]) + '\n';
  }
  if (list.size() > shown_at_most) {
    text += fmt::format("... and {} more\n", list.size() - shown_at_most);
  }
}

std::string problems(const RunReport& report) {
  std::string text;
  add_list(text, report.warnings, [](const std::string& w) { return "warning: " + w; });
  add_list(text, report.violations,
           [](const MeshViolation& v) { return v.rule + " broken: " + v.where; });
  add_list(text, report.offending_edges, [](const OffendingEdge& e) {
    return fmt::format(
        "not admissible: edge {}-{} from ({}, {}) to ({}, {}), region {}: factor "
        "{:.3g}, opposite angles sum to {:.6f} degrees",
        e.k, e.l, e.at_k.x, e.at_k.y, e.at_l.x, e.at_l.y, e.region, e.factor, e.angle_deg);
  });
  return text;
}

std::string costs(const RunReport& report) {
  const Seconds& s = report.seconds;
  std::string text;
  add_line(text, "seconds",
           fmt::format("{:.3f} (read {:.3f}, triangulate {:.3f}, refine {:.3f}, nonobtuse {:.3f}, "
                       "measure {:.3f}, voronoi {:.3f}, check {:.3f}, write {:.3f})",
                       s.total, s.read, s.triangulate, s.refine, s.nonobtuse, s.measure, s.voronoi,
                       s.check, s.write));
  add_line(text, "peak memory",
           fmt::format("{:.1f} MB", static_cast<double>(report.peak_memory_bytes) / 1e6));
  return text;
}

}  // namespace

std::string to_text(const RunReport& report) {
  return table(report) + summary(report) + group_lines(report) + costs(report) + problems(report);
}

}  // namespace lepp

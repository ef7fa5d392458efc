#include <fmt/format.h>

#include <string>

#include "lepp/io/report_lines.hpp"
#include "lepp/io/terrain_report.hpp"

namespace lepp {

namespace {

std::string place(const TerrainFigures& f) {
  return fmt::format("column {}, row {}: ({:.10g}, {:.10g})", f.error.column, f.error.row,
                     f.error_at.x, f.error_at.y);
}

// What was made, a line each: vertices, triangles, the smallest angle and the error found.
std::string table(const TerrainReport& r) {
  std::vector<TerrainFigures> list = r.tiles;
  list.insert(list.end(), r.levels.begin(), r.levels.end());
  if (list.empty()) return {};
  std::string text = fmt::format("{:<34}{:>10}{:>10}{:>12}{:>14}{:>12}  {}\n", "", "vertices",
                                 "triangles", "min. angle", "max. error", "RMS", "file");
  const auto row = [&](const std::string& name, const TerrainFigures& f) {
    text += fmt::format("{:<34}{:>10}{:>10}{:>12.2f}{:>14.6g}{:>12.4g}  {}\n", name, f.vertices,
                        f.triangles, f.min_angle_deg, f.error.max, f.error.rms,
                        f.problem.empty() ? f.output : f.problem);
  };
  // The last ones are levels, or a tile that ended the run.
  constexpr std::size_t shown_first = 20, shown_last = 5;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const bool is_shown = i < shown_first || i + shown_last >= list.size();
    if (is_shown) row(list[i].name, list[i]);
    else if (i == shown_first)
      text += fmt::format("... and {} more\n", list.size() - shown_first - shown_last);
  }
  row(r.tiles.empty() ? "finest" : "all", r.whole);
  return text + '\n';
}

std::string error_lines(const TerrainReport& r) {
  const TerrainError& e = r.whole.error;
  std::string text;
  const std::string asked = r.max_error ? fmt::format(" (asked for: {:.6g})", *r.max_error) : "";
  add_line(text, "largest error", fmt::format("{:.6g}{}", e.max, asked));
  add_line(text, "  at", place(r.whole));
  add_line(text, "  grid above, grid below, RMS",
           fmt::format("{:.6g}, {:.6g}, {:.6g}", e.highest, -e.lowest, e.rms));
  if (e.samples_on_hard_lines > 0) {
    add_line(text, "  on hard breaklines",
             fmt::format("{} samples, off by up to {:.6g}; elsewhere {:.6g}",
                         e.samples_on_hard_lines, e.on_hard_lines.max, e.elsewhere.max));
  }
  if (const auto& before = r.whole.unfitted) {
    add_line(text, "before heights were fitted",
             fmt::format("largest {:.6g}, RMS {:.6g}", before->max, before->rms));
  }
  add_line(text, "samples checked", fmt::format("{}", e.samples));
  add_line(text, "samples lost, nodata covered", fmt::format("{}, {}", e.lost, e.covered));
  if (r.error_kept) add_line(text, "error kept", answer(*r.error_kept));
  return text;
}

std::string histogram(const AngleHistogram& counts) {
  std::size_t all = 0;
  for (const std::size_t n : counts) all += n;
  std::string text;
  for (std::size_t i = 0; i < counts.size() && all > 0; ++i) {
    if (counts[i] == 0) continue;
    const double percent = 100.0 * static_cast<double>(counts[i]) / static_cast<double>(all);
    text += fmt::format("{}{}-{}: {:.2f} %", text.empty() ? "" : ", ", 5 * i, 5 * (i + 1), percent);
  }
  return text;
}

std::string rules(const std::vector<KeptEdge>& edges) {
  std::array<std::size_t, 5> counts{};
  for (const KeptEdge& edge : edges) ++counts.at(static_cast<std::size_t>(edge.kept_by));
  return counted<KeptBy>(counts);
}

std::string space_lines(const TerrainReport& r) {
  const TerrainInSpace& s = r.in_space;
  std::string text;
  add_line(text, "angles in space",
           fmt::format("from {:.2f} degrees, mean of the smallest {:.2f}", s.min_angle_deg,
                       s.mean_min_angle_deg));
  if (r.metric != "surface") return text;
  add_line(text, "inserted tame, untame", fmt::format("{}, {}", s.tame, s.untame));
  add_line(text, "edges against the sphere rule", rules(s.kept_edges));
  return text;
}

std::string angle_lines(const TerrainReport& r) {
  std::string text;
  add_line(text, "angles",
           fmt::format("{:.2f} to {:.2f} degrees, mean of the smallest {:.2f}",
                       r.whole.min_angle_deg, r.max_angle_deg_found, r.mean_min_angle_deg));
  add_line(text, "smallest angles", histogram(r.smallest_angles));
  text += space_lines(r);
  if (r.min_angle_deg) {
    const bool in_plan = r.metric != "surface";
    const double bound = in_plan ? *r.min_angle_deg : r.in_space.plan_angle_deg;
    add_line(text, fmt::format("triangles below {:.6g} degrees", bound),
             counted<Reason>(r.whole.below_bound));
    for (const TerrainFigures& level : r.levels) {
      add_line(text, "  of " + level.name, counted<Reason>(level.below_bound));
    }
  }
  if (r.admissible) {
    add_line(text, "obtuse at constrained edges", fmt::format("{}", r.obtuse_constrained));
    add_line(text, "admissible Voronoi boxes", answer(*r.admissible));
  }
  return text;
}

std::string costs(const TerrainReport& r) {
  const TerrainSeconds& s = r.seconds;
  std::string text;
  add_line(text, "seconds",
           fmt::format("{:.3f} (read {:.3f}, domain {:.3f}, simplify {:.3f}, nonobtuse {:.3f}, "
                       "fit {:.3f}, measure {:.3f}, check {:.3f}, write {:.3f})",
                       s.total, s.read, s.domain, s.simplify, s.nonobtuse, s.fit, s.measure,
                       s.check, s.write));
  add_line(text, "peak memory",
           fmt::format("{:.1f} MB", static_cast<double>(r.peak_memory_bytes) / 1e6));
  return text;
}

std::string problems(const TerrainReport& r) {
  std::string text;
  for (const std::string& w : r.warnings) text += "warning: " + w + '\n';
  for (const MeshViolation& v : r.violations) text += v.rule + " broken: " + v.where + '\n';
  return text;
}

}  // namespace

std::string to_text(const TerrainReport& r) {
  std::string text = table(r);
  add_line(text, "input",
           fmt::format("{}, {} x {} samples, {} with data{}", r.input, r.columns, r.rows, r.samples,
                       r.tiling ? ", twice where tiles share them" : ""));
  add_line(text, "heights", fmt::format("{:.6g} to {:.6g}", r.lowest, r.highest));
  if (!r.whole.output.empty()) add_line(text, "output", r.whole.output);
  add_line(text, "vertices, triangles", fmt::format("{}, {}", r.whole.vertices, r.whole.triangles));
  text += error_lines(r) + angle_lines(r);
  add_line(text, "goal reached", answer(r.goal_reached));
  add_line(text, "valid", answer(r.valid));
  return text + costs(r) + problems(r);
}

}  // namespace lepp

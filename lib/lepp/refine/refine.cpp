#include "lepp/refine/refine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lepp/geometry/text.hpp"
#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/refine/angle_test.hpp"
#include "lepp/refine/clean_up.hpp"
#include "lepp/refine/clear_around.hpp"
#include "lepp/refine/even_out.hpp"
#include "lepp/refine/left_alone.hpp"
#include "lepp/refine/size_test.hpp"
#include "lepp/refine/terminal_loop.hpp"
#include "lepp/refine/unified_loop.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/spatial_numbering.hpp"

namespace lepp {

namespace {

constexpr double largest_predicted_size = 1e8;

void check(const RefineOptions& options) {
  const auto refuse = [](const std::string& name, double value, const std::string& range) {
    throw InputError(name, to_text(value) + " is out of range", "give " + range);
  };
  if (!(options.min_angle_deg >= 0 && options.min_angle_deg <= 45)) {
    refuse("minimum angle", options.min_angle_deg, "an angle from 0 to 45 degrees");
  }
  if (!(options.max_angle_deg >= 90 && options.max_angle_deg <= 180)) {
    refuse("maximum angle", options.max_angle_deg, "an angle from 90 to 180 degrees");
  }
  if (!(options.max_edge > 0)) refuse("maximum edge", options.max_edge, "a length above 0");
  if (!(options.max_area > 0)) refuse("maximum area", options.max_area, "an area above 0");
}

// Triangles that the sizes alone will need: as many equilateral ones of that size as fit.
double predicted_triangles(const Mesh& mesh, const RefineOptions& options) {
  const SizeTest size(mesh, options);
  if (!size.any()) return 0;
  double predicted = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    const auto [a, b, c] = mesh.corners(t);
    predicted += size.predicted_triangles(a, b, c, mesh.region(t));
  }
  return predicted;
}

std::size_t vertex_budget(const Mesh& mesh, const RefineOptions& options) {
  const double by_size = predicted_triangles(mesh, options);
  if (by_size > largest_predicted_size) {
    throw RefusedError("size bounds",
                       "they need about " + to_text(std::round(by_size)) +
                           " triangles, more than " + to_text(largest_predicted_size),
                       "ask for larger sizes (--max-edge, --max-area)");
  }
  if (options.max_vertices > 0) return options.max_vertices;
  const double budget = 50 * (static_cast<double>(mesh.vertex_count()) + 1000 + by_size);
  return static_cast<std::size_t>(std::min(budget, 1e9));
}

// What is asked of each triangle: sizes and, in the shape of an indicator, quality.
class Bounds {
 public:
  Bounds(const Mesh& mesh, const RefineOptions& options, const QualityIndicator& quality)
      : quality_(quality),
        floor_(default_size_floor(mesh)),
        angle_(0, options.max_angle_deg),
        size_(mesh, options) {}

  bool has_large_angle(const Mesh& mesh, TriangleId t) const {
    const auto [a, b, c] = mesh.corners(t);
    return angle_.is_above(a, b, c);
  }

  bool poor(const Mesh& mesh, TriangleId t) const { return quality_.q(mesh, t) < quality_.epsilon; }

  // How many times too large, squared lengths or areas; at most 1 if it is not.
  double excess(const Mesh& mesh, TriangleId t) const {
    if (!size_.any()) return 0;
    const auto [a, b, c] = mesh.corners(t);
    return size_.excess(a, b, c, mesh.region(t));
  }

  // Too large first, largest first; then poor quality, poorest first. A poor shape that no
  // insertion can better is no target.
  std::optional<Badness> judge(const Mesh& mesh, TriangleId t) const {
    const double too_large = excess(mesh, t);
    if (too_large > 1) return Badness{true, too_large};
    const double q = quality_.q(mesh, t);
    if (!(q < quality_.epsilon)) return std::nullopt;
    const bool shape = quality_.measures == QualityIndicator::Measures::shape;
    if (shape && (smallest_angle_between_constrained(mesh, t) ||
                  shortest_edge_is_seditious(mesh, t) || at_input_feature(mesh, t, 2 * floor_))) {
      return std::nullopt;
    }
    return Badness{false, quality_.epsilon - q};
  }

 private:
  const QualityIndicator& quality_;
  double floor_;
  AngleTest angle_;
  SizeTest size_;
};

bool faces_obtuse_constrained(const Mesh& mesh, TriangleId t) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    if (mesh.is_constrained(e) && faces_obtuse_angle(mesh, e)) return true;
  }
  return false;
}

// Triangles as they were at the start, to know again those that no insertion touched.
class Untouched {
 public:
  Untouched() = default;  // none
  Untouched(const Mesh& mesh, std::span<const TriangleId> targets)
      : is_target_(mesh.triangle_count(), false) {
    for (const TriangleId t : targets) is_target_[t.index()] = true;
    if (targets.size() == mesh.triangle_count()) return;
    for (const Triangle& t : mesh.triangles()) before_.push_back(t.vertices);
  }

  bool operator()(const Mesh& mesh, TriangleId t) const {
    return t.index() < before_.size() && !is_target_[t.index()] &&
           before_[t.index()] == mesh.vertices(t);
  }

 private:
  std::vector<bool> is_target_;
  std::vector<std::array<VertexId, 3>> before_;
};

template <class Poor>
RefineReport list_unfinished(const Mesh& mesh, const Bounds& bounds, const Poor& poor,
                             ObtuseRule obtuse, const Untouched& untouched, Reason otherwise) {
  RefineReport result;
  result.goal_reached = true;
  std::optional<InputReasons> input;  // made for the first triangle that needs it
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    if (untouched(mesh, t)) continue;
    const bool too_large = bounds.excess(mesh, t) > 1;
    const bool angle_left = bounds.has_large_angle(mesh, t) || (obtuse == ObtuseRule::split_first &&
                                                                faces_obtuse_constrained(mesh, t));
    if (!too_large && !angle_left && !poor(t)) continue;
    if (!input) input.emplace(mesh);
    Reason reason = otherwise;
    if (angle_left) {  // an input angle forces no large one, but for rounding
      if (!too_large && input->by_feature(t)) reason = Reason::input_feature;
      else if (!too_large && is_obtuse_by_rounding(mesh, t)) reason = Reason::input_angle;
    } else if (!too_large) {
      reason = input->of(t).value_or(otherwise);
    }
    result.unfinished.push_back({t, reason});
    if (!is_forced_by_input(reason)) result.goal_reached = false;
  }
  return result;
}

bool is_off_centre(Placement placement) {
  return placement == Placement::offcentre || placement == Placement::best;
}

// Ends of LEPPs answer small angles only.
void refuse_largest_angle(const RefineOptions& options) {
  if (options.max_angle_deg >= 180) return;
  throw InputError("maximum angle", "needs off-centres, which this kind of refinement does not use",
                   "ask refine() with Placement::offcentre or best, or leave the bound away");
}

std::vector<TriangleId> all_triangles(const Mesh& mesh) {
  std::vector<TriangleId> all;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) all.emplace_back(t);
  return all;
}

}  // namespace

QualityIndicator smallest_angle_indicator(double bound_deg) {
  // q = -cos^2 of the smallest angle grows with the angle and needs neither acos nor sqrt.
  QualityIndicator indicator;
  indicator.q = [](const Mesh& mesh, TriangleId t) {
    const auto [a, b, c] = mesh.corners(t);
    return -squared_cos_of_smallest_angle(a, b, c);
  };
  const double bound = (bound_deg - 1e-9) * std::numbers::pi / 180;
  indicator.epsilon = bound_deg > 0 ? -std::pow(std::cos(bound), 2) : -1;
  return indicator;
}

RefineReport improve(Mesh& mesh, std::span<const TriangleId> targets,
                     const QualityIndicator& quality, const RefineOptions& options) {
  check(options);
  refuse_largest_angle(options);
  const Bounds bounds(mesh, options, quality);
  const Untouched untouched(mesh, targets);
  RefineOptions terminal = options;
  if (is_off_centre(options.placement)) terminal.placement = Placement::centroid;
  const std::size_t before = mesh.vertex_count();
  TerminalLoop loop(mesh, terminal, vertex_budget(mesh, options),
                    [&](const Mesh& m, TriangleId t) { return bounds.judge(m, t); });
  for (const TriangleId t : targets) loop.add_target(t);
  loop.run();
  const auto poor = [&](TriangleId t) { return bounds.poor(mesh, t); };
  RefineReport report = list_unfinished(mesh, bounds, poor, options.obtuse, untouched,
                                        loop.stopped().value_or(Reason::size_floor));
  report.steiner_points = mesh.vertex_count() - before;
  return report;
}

namespace {

std::vector<TriangleId> stuck_triangles(const RefineReport& report) {
  std::vector<TriangleId> stuck;
  for (const Unfinished& u : report.unfinished) {
    if (u.reason == Reason::size_floor) stuck.push_back(u.triangle);
  }
  return stuck;
}

// At bounds near 40 degrees the loop now and then runs into the size floor in a corner of the
// boundary. There it begins anew, with more and more around it cleared, by turns with the best of
// several places and with off-centres.
RefineReport run_loop(Mesh& mesh, const RefineOptions& options, const LeftAlone& left_alone,
                      std::size_t budget) {
  constexpr std::size_t most_restarts = 4, most_stuck = 1000;
  RefineOptions turn = options;
  RefineReport report;
  for (std::size_t restart = 0;; ++restart) {
    UnifiedLoop loop(mesh, turn, left_alone, budget);
    loop.run();
    report = judge(mesh, options, loop.stopped().value_or(Reason::size_floor));
    const auto stuck = stuck_triangles(report);
    if (options.effort == Effort::fast || stuck.empty() || stuck.size() > most_stuck ||
        restart == most_restarts) {
      return report;
    }
    if (clear_around(mesh, stuck, std::size_t{100} << restart) == 0) return report;
    turn.placement = restart % 2 == 0 ? Placement::best : options.placement;
  }
}

bool was_cancelled(const RefineReport& report) {
  return std::ranges::find(report.unfinished, Reason::cancelled, &Unfinished::reason) !=
         report.unfinished.end();
}

bool was_stopped(const RefineReport& report) {
  return was_cancelled(report) || std::ranges::find(report.unfinished, Reason::budget,
                                                    &Unfinished::reason) != report.unfinished.end();
}

// The clean-up leaves nothing for the loop to do, but for sizes that flips have changed.
RefineReport refine_once(Mesh& mesh, const RefineOptions& options, const LeftAlone& left_alone) {
  const std::size_t before = mesh.vertex_count();
  const std::size_t budget = vertex_budget(mesh, options);
  RefineReport report = run_loop(mesh, options, left_alone, budget);
  if (options.effort != Effort::fast && options.min_angle_deg > 0 && !was_stopped(report)) {
    CleanUp(mesh, options, default_size_floor(mesh)).run();
    if (SizeTest(mesh, options).any()) EvenOut(mesh, options, default_size_floor(mesh)).run();
    report = judge(mesh, options, Reason::size_floor);
    if (!report.unfinished.empty()) report = run_loop(mesh, options, left_alone, budget);
  }
  report.steiner_points = mesh.vertex_count() - before;
  return report;
}

// The best of several places takes more vertices, but gets past corners where off-centres do not.
RefineReport refine_with_effort(Mesh& mesh, const RefineOptions& options,
                                const LeftAlone& left_alone) {
  if (options.effort != Effort::best || options.placement == Placement::best) {
    return refine_once(mesh, options, left_alone);
  }
  Mesh other = mesh;
  const RefineReport first = refine_once(mesh, options, left_alone);
  const std::size_t stuck = stuck_triangles(first).size();
  if (stuck == 0) return first;
  RefineOptions best = options;
  best.placement = Placement::best;
  const RefineReport second = refine_once(other, best, left_alone);
  if (!second.goal_reached && second.unfinished.size() >= first.unfinished.size()) return first;
  mesh = std::move(other);
  return second;
}

// What went wrong where large angles are left alone. \pre `report` lists the triangles of `mesh`
void say_why(RefineReport& report, const Mesh& mesh, const RefineOptions& options,
             const LeftAlone& left_alone, Reason why) {
  const AngleTest angle(0, options.max_angle_deg);
  for (Unfinished& u : report.unfinished) {
    const auto [a, b, c] = mesh.corners(u.triangle);
    const bool there = angle.is_above(a, b, c) && left_alone.contains(mesh, u.triangle);
    if (there && u.reason == Reason::size_floor) u.reason = why;
  }
}

std::size_t left_to_do(const RefineReport& report) {
  const auto is_left = [](const Unfinished& u) { return !is_forced_by_input(u.reason); };
  return static_cast<std::size_t>(std::ranges::count_if(report.unfinished, is_left));
}

// Bounding the largest angle takes small triangles beside a sharp wedge, and where no mesh has them
// small enough the wedge is cut again and again. Another attempt takes the best of several places;
// then vertices at which that is seen are left alone.
RefineReport refine_unified(Mesh& mesh, const RefineOptions& options) {
  LeftAlone left_alone = LeftAlone::nowhere(mesh);
  if (options.max_angle_deg >= 180) return refine_with_effort(mesh, options, left_alone);
  constexpr int most_attempts = 5;
  const Mesh start = mesh;
  RefineOptions attempted = options;
  // A cascade would use all vertices up; without one a part of them is plenty.
  if (options.max_vertices == 0) attempted.max_vertices = vertex_budget(start, options) / 4;
  RefineReport report = refine_with_effort(mesh, attempted, left_alone);
  const auto is_over = [&] { return report.goal_reached || was_cancelled(report); };
  if (is_over() || !segments_meet_sharply(start)) return report;
  LeftAlone all = LeftAlone::everywhere(start);
  Mesh plain = start;
  RefineReport plain_report = refine_with_effort(plain, options, all);
  if (was_cancelled(plain_report)) {
    mesh = std::move(plain);
    return plain_report;
  }
  bool out_of_vertices = was_stopped(report);
  attempted.placement = Placement::best;
  for (int i = 1; i < most_attempts; ++i) {
    if (i > 1 && !left_alone.add_shrunken(mesh, plain)) break;
    mesh = start;
    report = refine_with_effort(mesh, attempted, left_alone);
    if (is_over()) return report;
    out_of_vertices = out_of_vertices || was_stopped(report);
    if (i > 1) attempted.placement = options.placement;
  }
  if (was_stopped(report) || left_to_do(plain_report) <= left_to_do(report)) {
    std::swap(mesh, plain);
    std::swap(report, plain_report);
    std::swap(left_alone, all);
  }
  say_why(report, mesh, options, left_alone, out_of_vertices ? Reason::budget : Reason::size_floor);
  return report;
}

// A mesh that does not fit into the cache is refined in spatial order.
RefineReport refine_in_order(Mesh& mesh, const RefineOptions& options) {
  constexpr std::size_t fits_into_the_cache = 20000;
  if (mesh.vertex_count() <= fits_into_the_cache) return refine_unified(mesh, options);
  SpatialNumbering numbering(mesh);
  try {
    RefineReport report = refine_unified(mesh, options);
    numbering.undo();
    return report;
  } catch (...) {
    numbering.undo();
    throw;
  }
}

}  // namespace

RefineReport refine(Mesh& mesh, const RefineOptions& options) {
  check(options);
  if (is_off_centre(options.placement)) return refine_in_order(mesh, options);
  return improve(mesh, all_triangles(mesh), smallest_angle_indicator(options.min_angle_deg),
                 options);
}

RefineReport judge(const Mesh& mesh, const RefineOptions& options, Reason otherwise) {
  const QualityIndicator quality = smallest_angle_indicator(options.min_angle_deg);
  const Bounds bounds(mesh, options, quality);
  const auto poor = [&](TriangleId t) {
    const auto [a, b, c] = mesh.corners(t);
    return AngleTest::of_smallest(a, b, c) > -quality.epsilon;
  };
  return list_unfinished(mesh, bounds, poor, options.obtuse, Untouched(), otherwise);
}

}  // namespace lepp

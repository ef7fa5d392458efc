#include "lepp/terrain/validate_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/terrain/simplify.hpp"

namespace lepp {

namespace {

constexpr std::size_t reported_per_rule = 20;
constexpr double forgiven_deg = 1e-6;
constexpr double forgiven_error = 1e-9;  // of the error
constexpr double at_corner = 1e-9;       // cells

using Corners = std::array<VertexId, 3>;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

class Validator {
 public:
  Validator(const HeightGrid& grid, const Tin& tin, const SurfaceClaims& claims)
      : grid_(grid),
        tin_(tin),
        mesh_(tin.mesh),
        claims_(claims),
        rounding_(kept_error(0, interpolation_rounding(grid))) {}

  MeshReport run() {
    note_list();
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) check({TriangleId(t), i});
    }
    return std::move(report_);
  }

 private:
  void broken(const std::string& rule, HalfEdge e, const std::string& problem) {
    ++report_.count;
    if (++per_rule_[rule] > reported_per_rule) return;
    report_.violations.push_back({rule, "edge " + std::to_string(e.edge) + " of triangle " +
                                            std::to_string(e.triangle.value) + ": " + problem});
  }

  void note_list() {
    for (const SphereViolation& v : claims_.violations) {
      const bool exists = v.edge.triangle.index() < mesh_.triangle_count() && v.edge.edge < 3;
      const auto across = exists ? mesh_.twin(v.edge) : std::nullopt;
      if (!across || across->triangle < v.edge.triangle) {
        broken("S2", v.edge, "listed, and no such edge from its lower triangle");
      } else if (!listed_.emplace(v.edge, v.kept_by).second) {
        broken("S2", v.edge, "listed twice");
      }
    }
  }

  void check(HalfEdge e) {
    const auto f = mesh_.twin(e);
    if (!f || f->triangle < e.triangle) return;
    const double sum = angle(mesh_.apex(e), mesh_.origin(e), mesh_.destination(e)) +
                       angle(mesh_.apex(*f), mesh_.origin(e), mesh_.destination(e));
    const auto rule = listed_.find(e);
    if (rule == listed_.end()) {
      if (sum > 180 + forgiven_deg) broken("S1", e, "opposite angles of " + to_text(sum));
      return;
    }
    if (sum <= 180) broken("S2", e, "listed, with opposite angles of " + to_text(sum));
    else if (!holds(rule->second, e, *f)) {
      broken("S2", e, "it is not the rule " + to_string(rule->second) + " that keeps it");
    }
  }

  bool holds(KeptBy rule, HalfEdge e, HalfEdge f) const {
    const VertexId a = mesh_.origin(e), b = mesh_.destination(e), c = mesh_.apex(e),
                   d = mesh_.apex(f);
    const Corners left{a, b, c}, right{b, a, d}, low{c, a, d}, high{d, b, c};
    const auto least = [&](auto smallest, const Corners& s, const Corners& t) {
      return std::min((this->*smallest)(s), (this->*smallest)(t));
    };
    switch (rule) {
      case KeptBy::constraint:
        return mesh_.is_constrained(e);
      case KeptBy::shape:
        return !is_left_turn(low) || !is_left_turn(high);
      case KeptBy::angle:
        return least(&Validator::smallest_in_space, low, high) <=
               least(&Validator::smallest_in_space, left, right) + forgiven_deg;
      case KeptBy::plan_angle: {
        const double after = least(&Validator::smallest_in_plan, low, high);
        return after < claims_.plan_angle_deg + forgiven_deg &&
               after < least(&Validator::smallest_in_plan, left, right) + forgiven_deg;
      }
      case KeptBy::error: {
        const double most = std::max({claims_.bound, error(left), error(right)});
        return std::max(error(low), error(high)) >= most * (1 - forgiven_error) - rounding_;
      }
    }
    return false;
  }

  bool is_left_turn(const Corners& t) const {
    return orient2d(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2])) > 0;
  }

  std::array<double, 3> leg(VertexId from, VertexId to) const {
    const Point p = mesh_.point(from), q = mesh_.point(to);
    const double rise = tin_.heights[to.index()] - tin_.heights[from.index()];
    return {(q.x - p.x) * grid_.cell_width, (q.y - p.y) * grid_.cell_width, rise};
  }

  // In degrees, at `apex` in space.
  double angle(VertexId apex, VertexId a, VertexId b) const {
    const auto u = leg(apex, a), w = leg(apex, b);
    const double sine =
        std::hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]);
    return degrees(std::atan2(sine, u[0] * w[0] + u[1] * w[1] + u[2] * w[2]));
  }
  double smallest_in_space(const Corners& t) const {
    return std::min({angle(t[0], t[1], t[2]), angle(t[1], t[2], t[0]), angle(t[2], t[0], t[1])});
  }
  double smallest_in_plan(const Corners& t) const {
    return std::ranges::min(angles_deg(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2])));
  }

  // Columns and lines, so that samples are whole numbers.
  Point place(VertexId v) const {
    const Point p = mesh_.point(v);
    return {p.x, p.y / grid_.aspect()};
  }

  // The largest error of a triangle at samples that are no corner of it, by asking all samples of
  // its bounding box.
  double error(const Corners& t) const {
    const Point a = place(t[0]), b = place(t[1]), c = place(t[2]);
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [bottom, top] = std::minmax({a.y, b.y, c.y});
    double largest = 0;
    for (double y = std::ceil(bottom - at_corner); y <= top + at_corner; ++y) {
      for (double x = std::ceil(left - at_corner); x <= right + at_corner; ++x) {
        largest = std::max(largest, error_at(t, {a, b, c}, {x, y}));
      }
    }
    return largest;
  }

  double error_at(const Corners& t, const std::array<Point, 3>& at, Point p) const {
    if (p.x < 0 || p.y < 0 || p.x > grid_.columns - 1 || p.y > grid_.rows - 1) return 0;
    const double whole = cross(at[1] - at[0], at[2] - at[0]);
    const double first = tin_.heights[t[0].index()];
    double above_first = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point from = at[(i + 1) % 3], to = at[(i + 2) % 3];
      const double part = cross(to - from, p - from) / whole;
      if (part < -at_corner) return 0;
      if (std::abs(p.x - at[i].x) < at_corner && std::abs(p.y - at[i].y) < at_corner) return 0;
      above_first += part * (tin_.heights[t[i].index()] - first);
    }
    const double height = grid_.height(static_cast<std::uint32_t>(p.x),
                                       grid_.row_of_line(static_cast<std::uint32_t>(p.y)));
    const double off = (height - first) - above_first;
    return std::isnan(off) ? 0 : std::abs(off);
  }

  const HeightGrid& grid_;
  const Tin& tin_;
  const Mesh& mesh_;
  const SurfaceClaims& claims_;
  const double rounding_;  // of errors
  std::map<HalfEdge, KeptBy> listed_;
  std::map<std::string, std::size_t> per_rule_;
  MeshReport report_;
};

}  // namespace

MeshReport validate_surface(const HeightGrid& grid, const Tin& tin, const SurfaceClaims& claims) {
  return Validator(grid, tin, claims).run();
}

}  // namespace lepp

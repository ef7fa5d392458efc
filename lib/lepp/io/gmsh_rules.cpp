#include "lepp/io/gmsh_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "lepp/geometry/error.hpp"

namespace lepp {
namespace {

class Rules {
 public:
  Rules(const GmshRecord& record, const GmshScript& script, const std::string& source)
      : record_(record), script_(script), source_(source) {
    for (const GmshPoint& point : record.points) points_[point.tag] = &point;
    for (const GmshCurve& curve : record.curves) curves_[curve.tag] = &curve;
  }

  void check() {
    check_surfaces_exist();
    check_plane();
    for (const GmshSurface& surface : record_.surfaces) {
      check_closed(surface);
      check_area(surface);
    }
  }

 private:
  Point position(int point) const {
    const auto found = points_.find(point);
    if (found == points_.end())
      throw InputError(source_ + fmt::format(", point {}", point), "does not exist",
                       "add it, or remove the curves that end there");
    return found->second->position;
  }

  const GmshCurve& curve(int tag, const GmshSurface& surface) const {
    const auto found = curves_.find(tag);
    if (found == curves_.end())
      throw InputError(source_ + fmt::format(", surface {}", surface.tag),
                       fmt::format("curve {} does not exist", tag), "add it to the file");
    return *found->second;
  }

  void check_surfaces_exist() const {
    if (!record_.surfaces.empty()) return;
    throw InputError(source_,
                     fmt::format("there is no surface to mesh ({} curves, {} points)",
                                 record_.curves.size(), record_.points.size()),
                     "add a Curve Loop and a Plane Surface");
  }

  double size() const {
    Point low, high;
    for (const GmshPoint& p : record_.points) {
      if (&p == &record_.points.front()) low = high = p.position;
      low = {std::min(low.x, p.position.x), std::min(low.y, p.position.y)};
      high = {std::max(high.x, p.position.x), std::max(high.y, p.position.y)};
    }
    for (const GmshCurve& c : record_.curves) high.x = std::max(high.x, low.x + c.length / 8);
    return std::max(high.x - low.x, high.y - low.y);
  }

  /// Entities that no surface has (the centre of an arc, say) may lie anywhere.
  void check_plane() const {
    PlaneCheck same_height(source_, size());
    for (const GmshSurface& surface : record_.surfaces) {
      std::vector<int> tags = surface.boundary;
      tags.insert(tags.end(), surface.embedded_curves.begin(), surface.embedded_curves.end());
      for (const int tag : tags) {
        const GmshCurve& c = curve(tag, surface);
        same_height(c.z_low, fmt::format("curve {}", tag));
        same_height(c.z_high, fmt::format("curve {}", tag));
      }
      for (const int tag : surface.embedded_points) {
        position(tag);
        same_height(points_.at(tag)->z, fmt::format("point {}", tag));
      }
      if (surface.boundary.empty()) continue;
      same_height(surface.z_low, fmt::format("surface {}", surface.tag));
      same_height(surface.z_high, fmt::format("surface {}", surface.tag));
    }
  }

  /// A boundary is closed if an even number of its curve ends meet at every place.
  void check_closed(const GmshSurface& surface) const {
    std::map<Point, std::vector<int>> ends;  // tags of the points at a place
    for (const int tag : surface.boundary)
      for (const int end : {curve(tag, surface).begin, curve(tag, surface).end})
        ends[position(end)].push_back(end);
    std::vector<int> loose;
    for (const auto& [place, tags] : ends)
      if (tags.size() % 2 != 0) loose.push_back(tags.front());
    if (surface.boundary.empty() || !loose.empty()) open_boundary(surface, std::move(loose));
  }

  [[noreturn]] void open_boundary(const GmshSurface& surface, std::vector<int> loose) const {
    std::sort(loose.begin(), loose.end());
    std::string places;
    for (const int tag : loose)
      places += fmt::format("{}{} ({}, {})", places.empty() ? "" : ", ", tag, position(tag).x,
                            position(tag).y);
    const auto loop = loop_with(surface, loose);
    throw InputError(
        source_ + (loop ? fmt::format(", curve loop {} of surface {}", *loop, surface.tag)
                        : fmt::format(", surface {}", surface.tag)),
        loose.empty() ? "it has no boundary"
                      : fmt::format("the boundary is not closed: loose ends at points {}", places),
        "add the missing curve to the loop, or remove what sticks out");
  }

  /// The curve loop of the script that has a curve with a loose end.
  std::optional<int> loop_with(const GmshSurface& surface, const std::vector<int>& loose) const {
    std::set<int> open;
    for (const int tag : surface.boundary)
      for (const int end : loose)
        if (curves_.at(tag)->begin == end || curves_.at(tag)->end == end) open.insert(tag);
    for (const CurveLoopText& loop : script_.loops)
      for (const int tag : loop.curves)
        if (open.contains(tag)) return loop.tag;
    return std::nullopt;
  }

  /// No area: all of the boundary on one line, to rounding.
  void check_area(const GmshSurface& surface) const {
    std::vector<Point> points;
    for (const int tag : surface.boundary) {
      const GmshCurve& c = curve(tag, surface);
      points.push_back(position(c.begin));
      points.push_back(position(c.end));
      if (is_straight(c.geometry)) continue;
      for (const double t : {0.25, 0.5, 0.75}) points.push_back(point_at(c.geometry, t));
    }
    const Point a = points.front();
    const Point b = *std::max_element(points.begin(), points.end(), [&](Point p, Point q) {
      return squared_distance(a, p) < squared_distance(a, q);
    });
    const double squared_length = squared_distance(a, b);
    double width = 0;
    for (const Point p : points) width = std::max(width, std::abs(cross(b - a, p - a)));
    if (width > 1e-12 * squared_length) return;
    throw InputError(source_ + fmt::format(", surface {}", surface.tag),
                     fmt::format("has zero area: its boundary lies on one line from ({}, {}) to "
                                 "({}, {})",
                                 a.x, a.y, b.x, b.y),
                     "correct the points of its curve loop, or remove the surface");
  }

  const GmshRecord& record_;
  const GmshScript& script_;
  const std::string& source_;
  std::map<int, const GmshPoint*> points_;
  std::map<int, const GmshCurve*> curves_;
};

}  // namespace

void PlaneCheck::operator()(double z, const std::string& who) {
  if (!any_) {
    any_ = true;
    z_ = z;
    first_ = who;
  }
  if (std::abs(z - z_) <= tolerance_) return;
  throw InputError(source_ + ", " + who,
                   fmt::format("the geometry is not in a plane z = constant: z = {} here, {} at {}",
                               z, z_, first_),
                   "project it on the plane z = 0: only plane geometry can be meshed");
}

void check_gmsh_geometry(const GmshRecord& record, const GmshScript& script,
                         const std::string& source) {
  Rules(record, script, source).check();
}

}  // namespace lepp

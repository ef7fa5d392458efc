#include "lepp/io/gmsh_pslg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "lepp/io/gmsh_chords.hpp"
#include "lepp/io/gmsh_groups.hpp"
#include "lepp/io/gmsh_rules.hpp"

namespace lepp {
namespace {

class Builder {
 public:
  Builder(const GmshRecord& record, const std::string& source, const GmshOptions& options)
      : record_(record), options_(options), groups_(record) {
    input_.pslg.source = source;
    input_.pslg.base = 1;
    for (const GmshPoint& point : record.points) {
      points_[point.tag] = &point;
      next_number_ = std::max(next_number_, std::int64_t{point.tag} + 1);
    }
  }

  GmshInput build() {
    find_used_curves();
    for (const GmshCurve& curve : record_.curves)
      if (used_curves_.contains(curve.tag)) add_polyline(curve);
    add_surfaces();
    add_curves();
    add_embedded_points();
    const auto colliding = separate_chords(polylines_, isolated_);
    add_segments(straight_in_between(colliding));
    add_named_points();
    groups_.finish(input_.pslg.entities);
    warn_of_leftovers();
    return std::move(input_);
  }

 private:
  void find_used_curves() {
    for (const GmshSurface& surface : record_.surfaces) {
      used_curves_.insert(surface.boundary.begin(), surface.boundary.end());
      used_curves_.insert(surface.embedded_curves.begin(), surface.embedded_curves.end());
    }
  }

  void warn(std::string sentence) { input_.warnings.push_back(std::move(sentence)); }

  /// The curve as chords: its ends, and in between Gmsh's points or the fewest pieces.
  void add_polyline(const GmshCurve& curve) {
    const Point begin = points_.at(curve.begin)->position, end = points_.at(curve.end)->position;
    const bool straight = is_straight(curve.geometry);
    if (straight && begin == end) {
      warn(fmt::format("curve {} has no length and is dropped", curve.tag));
      return;
    }
    Polyline line{curve.geometry, {{begin, 0}}};
    if (record_.own_points) {
      for (const CurvePoint& p : curve.inner)
        line.points.push_back({straight ? p.point : point_at(curve.geometry, p.t), p.t});
    } else if (!straight) {
      for (const double t : fewest_pieces(curve.geometry, options_.chord_tolerance))
        line.points.push_back({point_at(curve.geometry, t), t});
    }
    line.points.push_back({end, 1});
    curve_of_polyline_.push_back(&curve);
    polylines_.push_back(std::move(line));
  }

  void add_surfaces() {
    auto& surfaces = input_.pslg.entities.surfaces;
    for (const GmshSurface& surface : record_.surfaces) {
      for (const int curve : surface.boundary) bounds_[curve].push_back(SurfaceId(surfaces.size()));
      // A curve that is embedded and listed as boundary encloses nothing: once more undoes it.
      for (const int curve : surface.embedded_curves)
        if (std::count(surface.boundary.begin(), surface.boundary.end(), curve) % 2 != 0)
          bounds_[curve].push_back(SurfaceId(surfaces.size()));
      SurfaceEntity& entity = surfaces.emplace_back();
      entity.tag = surface.tag;
      entity.attribute = surface.tag;
      // As with sizes along the boundary, edges may be a quarter longer.
      if (record_.largest_size) entity.max_edge = 1.25 * *record_.largest_size;
      entity.groups = groups_.ids(2, surface.groups);
    }
  }

  void add_curves() {
    for (const GmshCurve* curve : curve_of_polyline_)
      input_.pslg.entities.curves.push_back(
          {curve->tag, groups_.ids(1, curve->groups), curve->geometry, bounds_[curve->tag]});
  }

  /// The vertex at a place. One that is no point of the file gets a number above all of those.
  VertexId vertex(Point p, std::optional<std::int64_t> number = {}) {
    const auto [found, is_new] = vertices_.try_emplace(p, VertexId(input_.pslg.points.size()));
    if (is_new) {
      input_.pslg.points.push_back(p);
      input_.pslg.point_numbers.push_back(number.value_or(next_number_++));
    }
    return found->second;
  }

  /// Vertices at the ends of curves come first, by point tag, then embedded points.
  void add_embedded_points() {
    std::set<int> ends, embedded;
    for (const GmshCurve* curve : curve_of_polyline_) ends.insert({curve->begin, curve->end});
    for (const GmshSurface& surface : record_.surfaces)
      embedded.insert(surface.embedded_points.begin(), surface.embedded_points.end());
    for (const int tag : ends) vertex(points_.at(tag)->position, tag);
    std::set<Point> on_curves;
    for (const Polyline& line : polylines_)
      for (const CurvePoint& p : line.points) on_curves.insert(p.point);
    for (const int tag : embedded) {
      const Point place = points_.at(tag)->position;
      vertex(place, tag);
      if (!on_curves.contains(place)) isolated_.push_back(place);
    }
    named_ = std::move(embedded);
    for (const int tag : ends)
      if (!points_.at(tag)->groups.empty()) named_.insert(tag);
  }

  /// Pieces that still collide get a straight curve of the same name, so that later vertices stay
  /// on the chord. By polyline and piece.
  std::map<std::pair<std::size_t, std::size_t>, CurveId> straight_in_between(
      const std::vector<ChordPlace>& colliding) {
    std::map<std::pair<std::size_t, std::size_t>, CurveId> result;
    std::map<std::size_t, CurveId> straight_twin;
    auto& curves = input_.pslg.entities.curves;
    for (const auto& [polyline, piece] : colliding) {
      const auto [twin, is_new] = straight_twin.try_emplace(polyline, CurveId(curves.size()));
      if (is_new) {
        CurveEntity copy = curves[polyline];
        copy.geometry = StraightCurve{};
        curves.push_back(std::move(copy));
        const Point at = polylines_[polyline].points[piece].point;
        warn(
            fmt::format("curve {} meets or touches another one near ({}, {}): its smallest pieces "
                        "there are straight",
                        curves[polyline].tag, at.x, at.y));
      }
      result[{polyline, piece}] = twin->second;
    }
    return result;
  }

  void add_segments(const std::map<std::pair<std::size_t, std::size_t>, CurveId>& straight_pieces) {
    for (std::size_t i = 0; i < polylines_.size(); ++i) {
      const auto& points = polylines_[i].points;
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const auto straight = straight_pieces.find({i, k});
        const CurveId curve = straight != straight_pieces.end() ? straight->second : CurveId(i);
        input_.pslg.segments.push_back({vertex(points[k].point), vertex(points[k + 1].point), curve,
                                        points[k].t, points[k + 1].t});
      }
    }
  }

  void add_named_points() {
    for (const int tag : named_)
      input_.pslg.entities.points.push_back(
          {tag, vertex(points_.at(tag)->position), groups_.ids(0, points_.at(tag)->groups)});
  }

  void warn_of_leftovers() {
    std::string dropped;
    for (const GmshCurve& curve : record_.curves)
      if (!used_curves_.contains(curve.tag))
        dropped += fmt::format("{}{}", dropped.empty() ? "" : ", ", curve.tag);
    if (!dropped.empty())
      warn(
          fmt::format("curves {} are on no surface and are dropped; embed them with Curve{{}} In "
                      "Surface{{}} to keep them",
                      dropped));
    for (std::string& sentence : groups_.warnings()) warn(std::move(sentence));
  }

  const GmshRecord& record_;
  const GmshOptions& options_;
  GmshGroups groups_;
  GmshInput input_;
  std::map<int, const GmshPoint*> points_;
  std::set<int> used_curves_, named_;
  std::vector<Polyline> polylines_;
  std::vector<const GmshCurve*> curve_of_polyline_;  // same index; also the CurveId
  std::map<int, std::vector<SurfaceId>> bounds_;
  std::vector<Point> isolated_;
  std::map<Point, VertexId> vertices_;
  std::int64_t next_number_ = 1;
};

}  // namespace

GmshInput pslg_from_gmsh(const GmshRecord& record, const GmshScript& script,
                         const std::string& source, const GmshOptions& options) {
  check_gmsh_geometry(record, script, source);
  return Builder(record, source, options).build();
}

}  // namespace lepp

#include "lepp/terrain/cut_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/terrain/hard_lines.hpp"
#include "lepp/terrain/snap_lines.hpp"

namespace lepp {

namespace {

using CurveSet = std::vector<CurveId>;  // ascending

// Which outlines and clip polygons each triangle is in.
class Insides {
 public:
  Insides(const Mesh& mesh, const Arrangement& arrangement)
      : mesh_(mesh), arrangement_(arrangement), set_of_(mesh.triangle_count(), unknown) {
    for (const LineKind kind : arrangement.kind) clips_ |= kind == LineKind::clip;
  }

  // From the outside, where no set has anything, across every edge.
  void run() {
    const std::uint32_t nothing = number({});
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        if (mesh_.is_boundary(e)) enter(e.triangle, beyond(nothing, e));
      }
    }
    while (!entered_.empty()) {
      const TriangleId t = entered_.back();
      entered_.pop_back();
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{t, i};
        if (const auto twin = mesh_.twin(e)) {
          if (set_of_[twin->triangle.index()] == unknown)
            enter(twin->triangle, beyond(set_of_[t.index()], e));
        }
      }
    }
  }

  bool is_in_domain(TriangleId t) const {
    const CurveSet& set = *sets_[set_of_[t.index()]];
    if (set.empty() || set.front() != CurveId(0U)) return false;
    return !clips_ || set.size() > 1;
  }
  bool is_in_polygon(TriangleId t) const {
    const CurveSet& set = *sets_[set_of_[t.index()]];
    return !set.empty() && set.back() != CurveId(0U);
  }

 private:
  static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t number(const CurveSet& set) {
    const auto [known, is_new] = number_of_.try_emplace(set, sets_.size());
    if (is_new) sets_.push_back(&known->first);
    return known->second;
  }

  void enter(TriangleId t, std::uint32_t set) {
    if (set_of_[t.index()] != unknown) return;
    set_of_[t.index()] = set;
    entered_.push_back(t);
  }

  std::uint32_t beyond(std::uint32_t set, HalfEdge e) {
    if (!mesh_.is_constrained(e)) return set;
    CurveSet result = *sets_[set];
    for (const SegmentId s : mesh_.segments_of(e)) {
      const auto& curve = mesh_.segments()[s.index()].curve;
      if (!curve || arrangement_.kind[curve->index()] == LineKind::breakline) continue;
      const auto place = std::ranges::lower_bound(result, *curve);
      if (place != result.end() && *place == *curve) result.erase(place);
      else result.insert(place, *curve);
    }
    return number(result);
  }

  const Mesh& mesh_;
  const Arrangement& arrangement_;
  bool clips_ = false;
  std::vector<std::uint32_t> set_of_;  // by triangle
  std::vector<TriangleId> entered_;
  std::map<CurveSet, std::uint32_t> number_of_;
  std::vector<const CurveSet*> sets_;  // by number
};

class DomainCutter {
 public:
  DomainCutter(const Arrangement& arrangement, const DomainOptions& options)
      : arrangement_(arrangement),
        options_(options),
        triangulation_(triangulate_lines(arrangement.pslg, arrangement.fixed_heights,
                                         arrangement.hard_segments)),
        mesh_(triangulation_.mesh),
        insides_(mesh_, arrangement),
        kept_(arrangement.kind.size()) {}

  TerrainDomain run() {
    insides_.run();
    number_of_.assign(mesh_.vertex_count(), unset);
    at_hard_.assign(mesh_.vertex_count(), false);
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) look_at({TriangleId(t), i});
    }
    if (segments_.empty()) {
      refuse_small_polygons();
      throw InputError(arrangement_.pslg.source,
                       "no part of the clip polygons is where the grid has data",
                       "check that both have the same coordinate system");
    }
    number_points();
    write_entities();
    warn();
    return std::move(domain_);
  }

 private:
  static constexpr std::uint32_t unset = std::numeric_limits<std::uint32_t>::max();

  void refuse_small_polygons() const {
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      if (insides_.is_in_polygon(TriangleId(t))) return;
    }
    throw InputError(arrangement_.pslg.source,
                     "nothing is left of the clip polygons: places nearer than " +
                         to_text(meeting_distance) + " cells are joined",
                     "give larger polygons, or check that they are in the grid's unit");
  }

  // Each edge is looked at from its side inside the domain, or from that with the lower id.
  void look_at(HalfEdge e) {
    if (!mesh_.is_constrained(e) || !insides_.is_in_domain(e.triangle)) return;
    const auto twin = mesh_.twin(e);
    const bool inner = twin && insides_.is_in_domain(twin->triangle);
    if (inner && *twin < e) return;
    std::optional<CurveId> curve;
    if (!inner) curve = CurveId(0U);
    for (const SegmentId s : mesh_.segments_of(e)) {
      const CurveId c = *mesh_.segments()[s.index()].curve;
      if (arrangement_.kind[c.index()] != LineKind::breakline) continue;
      ++kept_[c.index()];
      if (!curve || (inner && c < *curve)) curve = c;
    }
    if (!curve) return;  // inside the union of clip polygons
    const VertexId a = mesh_.origin(e), b = mesh_.destination(e);
    segments_.push_back({a, b, curve});
    number_of_[a.index()] = number_of_[b.index()] = 0;
    domain_.hard_segments.push_back(is_hard(e));
    if (domain_.hard_segments.back()) at_hard_[a.index()] = at_hard_[b.index()] = true;
  }

  bool is_hard(HalfEdge e) const {
    const auto& hard = triangulation_.hard_segments;
    return !hard.empty() &&
           std::ranges::any_of(mesh_.segments_of(e), [&](SegmentId s) { return hard[s.index()]; });
  }

  // A line that is left out asks for nothing where it ends on the outline.
  void number_points() {
    for (std::size_t v = 0; v < number_of_.size(); ++v) {
      if (number_of_[v] == unset) continue;
      number_of_[v] = static_cast<std::uint32_t>(domain_.pslg.points.size());
      domain_.pslg.points.push_back(mesh_.point(VertexId(v)));
      domain_.fixed_heights.push_back(at_hard_[v] ? triangulation_.heights[v]
                                                  : std::numeric_limits<double>::quiet_NaN());
    }
    for (Segment& s : segments_) {
      s.a = VertexId(number_of_[s.a.index()]);
      s.b = VertexId(number_of_[s.b.index()]);
    }
    domain_.pslg.segments = std::move(segments_);
  }

  // The curves of clip polygons come last, and are no longer needed.
  void write_entities() {
    domain_.pslg.source = arrangement_.pslg.source;
    domain_.pslg.entities = arrangement_.pslg.entities;
    auto& curves = domain_.pslg.entities.curves;
    curves.resize(1 + options_.breaklines.size());
  }

  void warn() {
    std::vector<std::size_t> pieces(arrangement_.kind.size());
    for (const Segment& s : arrangement_.pslg.segments) ++pieces[s.curve->index()];
    std::size_t outside = 0, partly = 0;
    for (std::size_t i = 0; i < options_.breaklines.size(); ++i) {
      outside += kept_[i + 1] == 0;
      partly += kept_[i + 1] != 0 && kept_[i + 1] < pieces[i + 1];
    }
    const std::string of = " of " + std::to_string(options_.breaklines.size()) + " breaklines ";
    if (arrangement_.places_joined != 0) {
      domain_.warnings.push_back("in " + std::to_string(arrangement_.places_joined) +
                                 " places, lines within 0.01 cells of each other, of a sample or "
                                 "of the outline were moved "
                                 "to meet there");
    }
    if (outside != 0) {
      domain_.warnings.push_back(std::to_string(outside) + of +
                                 "lie outside the domain and are left out");
    }
    if (partly != 0) {
      domain_.warnings.push_back(std::to_string(partly) + of +
                                 "lie partly outside the domain; those parts are left out");
    }
  }

  const Arrangement& arrangement_;
  const DomainOptions& options_;
  const HardTriangulation triangulation_;
  const Mesh& mesh_;
  Insides insides_;
  std::vector<std::size_t> kept_;         // pieces inside, by curve
  std::vector<Segment> segments_;         // between vertices of the mesh
  std::vector<std::uint32_t> number_of_;  // by vertex of the mesh
  std::vector<bool> at_hard_;             // likewise: an end of a hard segment inside
  TerrainDomain domain_;
};

}  // namespace

TerrainDomain cut_domain(const Arrangement& arrangement, const DomainOptions& options) {
  return DomainCutter(arrangement, options).run();
}

}  // namespace lepp

#include "lepp/triangulation/validate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/triangulation/half_edges_by_origin.hpp"

namespace lepp {

namespace {

constexpr std::size_t reported_per_rule = 20;

class Validator {
 public:
  Validator(const Mesh& mesh, const MeshClaims& claims) : mesh_(mesh), claims_(claims) {}

  MeshReport run() {
    check_ids();
    if (report_.count > 0) return std::move(report_);  // the rest would follow bad ids
    check_orientation();
    check_neighbours();
    if (report_.count > 0) return std::move(report_);
    check_constrained_flags();
    check_segments();
    if (!claims_.unfinished.empty()) input_.emplace(mesh_);
    if (claims_.delaunay) check_delaunay();
    if (claims_.min_angle_deg) check_angles(*claims_.min_angle_deg);
    if (claims_.nonobtuse) check_nonobtuse();
    if (claims_.max_angle_deg) check_large_angles(*claims_.max_angle_deg);
    return std::move(report_);
  }

 private:
  void broken(const std::string& rule, const std::string& where) {
    ++report_.count;
    if (++per_rule_[rule] <= reported_per_rule) report_.violations.push_back({rule, where});
  }

  template <class Visit>
  void for_each_half_edge(Visit visit) const {
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) visit(HalfEdge{TriangleId(t), i});
    }
  }

  std::string name(TriangleId t) const {
    return "triangle " + std::to_string(t.value) + " at " +
           to_text(mesh_.point(mesh_.vertex(t, 0)));
  }
  std::string name(HalfEdge e) const {
    const VertexId a = mesh_.origin(e), b = mesh_.destination(e);
    return "edge " + std::to_string(a.value) + "-" + std::to_string(b.value) + ", " +
           to_text(mesh_.point(a)) + " to " + to_text(mesh_.point(b));
  }

  void check_ids() {
    std::vector<bool> used(mesh_.vertex_count(), false);
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (const VertexId v : mesh_.vertices(TriangleId(t))) {
        if (v.index() < used.size()) used[v.index()] = true;
        else
          broken("M1", "triangle " + std::to_string(t) + " has vertex " + std::to_string(v.value));
      }
      if (mesh_.region(TriangleId(t)).index() >= mesh_.entities().surfaces.size()) {
        broken("M1", "triangle " + std::to_string(t) + " has no region");
      }
    }
    for (std::size_t v = 0; v < used.size(); ++v) {
      if (!used[v]) broken("M1", "vertex " + std::to_string(v) + " is in no triangle");
    }
    if (mesh_.triangle_count() == 0) broken("M1", "there is no triangle");
    for (std::size_t s = 0; s < mesh_.segments().size(); ++s) {
      const Segment& segment = mesh_.segments()[s];
      const bool ends = std::max(segment.a, segment.b).index() < mesh_.vertex_count();
      const bool curve = !segment.curve || segment.curve->index() < mesh_.entities().curves.size();
      if (!ends || !curve)
        broken("M1", "segment " + std::to_string(s) + " names what is not there");
    }
  }

  void check_orientation() {
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      const auto [a, b, c] = mesh_.corners(TriangleId(t));
      if (orient2d(a, b, c) <= 0) broken("M2", name(TriangleId(t)));
    }
  }

  void check_neighbours() {
    for_each_half_edge([&](HalfEdge e) {
      const auto f = mesh_.twin(e);
      if (!f) return;
      const bool in_range = f->triangle.index() < mesh_.triangle_count();
      if (!in_range || mesh_.twin(*f) != e || mesh_.origin(*f) != mesh_.destination(e) ||
          mesh_.destination(*f) != mesh_.origin(e)) {
        broken("M3", name(e));
      }
    });
    check_sides();
    check_fans();
  }

  // Every side of an edge once, and known to the triangle across.
  void check_sides() {
    const HalfEdgesByOrigin leaving(mesh_);
    for (const HalfEdge e : leaving.repeated()) {
      broken("M3", name(e) + " has two triangles on one side");
    }
    for_each_half_edge([&](HalfEdge e) {
      if (!mesh_.is_boundary(e)) return;
      if (leaving.has(mesh_.destination(e), mesh_.origin(e))) {
        broken("M3", name(e) + " has a triangle across that it does not know");
      }
    });
  }

  void check_fans() {
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      const HalfEdge e = mesh_.leaving(VertexId(v));
      if (e.triangle.index() >= mesh_.triangle_count() || mesh_.origin(e) != VertexId(v)) {
        broken("M3", "vertex " + std::to_string(v) + " does not know a half-edge that leaves it");
      }
    }
  }

  void check_constrained_flags() {
    for_each_half_edge([&](HalfEdge e) {
      const auto f = mesh_.twin(e);
      if (!f && !mesh_.is_constrained(e)) broken("M4", name(e) + " is boundary, not constrained");
      if (f && e < *f && mesh_.is_constrained(e) != mesh_.is_constrained(*f)) {
        broken("M4", name(e) + " is constrained on one side only");
      }
      if (f && e < *f && mesh_.region(e.triangle) != mesh_.region(f->triangle) &&
          !mesh_.is_constrained(e)) {
        broken("M4", name(e) + " separates regions, not constrained");
      }
    });
  }

  // The edges that name a segment as owner must form one path between its ends. Most segments are
  // one edge: those are settled on the spot, and only the edges of the others are collected.
  void check_segments() {
    const auto& segments = mesh_.segments();
    std::vector<std::uint8_t> is_one_edge(segments.size(), 0), has_others(segments.size(), 0);
    for_each_constrained_edge([&](HalfEdge e, const std::optional<ConstrainedEdge>& record) {
      if (!record) {
        broken("M5", name(e) + " has no record");
        return;
      }
      for (const SegmentId s : mesh_.segments_of(record->segments)) {
        const Segment& segment = segments[s.index()];
        const VertexId a = mesh_.origin(e), b = mesh_.destination(e);
        const bool whole = (a == segment.a && b == segment.b) || (a == segment.b && b == segment.a);
        (whole ? is_one_edge : has_others)[s.index()] = 1;
      }
    });
    std::vector<OwnedEdge> pieces;
    const auto cut = [&](SegmentId s) { return has_others[s.index()] != 0; };
    const auto collect = [&](HalfEdge e, const std::optional<ConstrainedEdge>& record) {
      if (!record) return;
      for (const SegmentId s : mesh_.segments_of(record->segments)) {
        if (cut(s)) pieces.push_back({s, mesh_.origin(e), mesh_.destination(e)});
      }
    };
    if (std::ranges::find(has_others, 1) != has_others.end()) for_each_constrained_edge(collect);
    std::ranges::sort(pieces, {}, &OwnedEdge::segment);
    auto first = pieces.begin();
    for (std::size_t s = 0; s < segments.size(); ++s) {
      auto last = first;
      while (last != pieces.end() && last->segment == SegmentId(s)) ++last;
      const bool whole = is_one_edge[s] != 0 && has_others[s] == 0;
      if (!whole && !is_chain({first, last}, segments[s].a, segments[s].b)) {
        broken("M5", "segment " + std::to_string(s) + " from " +
                         to_text(mesh_.point(segments[s].a)) + " to " +
                         to_text(mesh_.point(segments[s].b)));
      }
      first = last;
    }
  }

  // Each constrained edge once, with its record, if it has one.
  template <class Visit>
  void for_each_constrained_edge(Visit visit) const {
    for_each_half_edge([&](HalfEdge e) {
      if (!mesh_.is_constrained(e)) return;
      const auto f = mesh_.twin(e);
      if (f && *f < e) return;
      visit(e, mesh_.find_record(mesh_.origin(e), mesh_.destination(e)));
    });
  }

  struct OwnedEdge {
    SegmentId segment;
    VertexId a, b;
  };

  // Walks from `from` to `to` over all of `edges`, each once.
  static bool is_chain(std::span<const OwnedEdge> edges, VertexId from, VertexId to) {
    using Link = std::pair<VertexId, VertexId>;
    std::vector<Link> links;
    for (const OwnedEdge& e : edges) links.insert(links.end(), {{e.a, e.b}, {e.b, e.a}});
    std::ranges::sort(links);
    VertexId at = from, before = from;
    std::size_t steps = 0;
    while (steps < edges.size() && (at != to || steps == 0)) {
      auto next = std::ranges::lower_bound(links, at, {}, &Link::first);
      const auto leads_on = [&] { return next != links.end() && next->first == at; };
      if (leads_on() && next->second == before && steps > 0) ++next;
      if (!leads_on()) return false;
      before = at;
      at = next->second;
      ++steps;
    }
    return at == to && steps == edges.size() && steps > 0;
  }

  void check_delaunay() {
    for_each_half_edge([&](HalfEdge e) {
      const auto f = mesh_.twin(e);
      if (!f || *f < e || mesh_.is_constrained(e)) return;
      const auto [a, b, c] = mesh_.corners(e.triangle);
      if (incircle(a, b, c, mesh_.point(mesh_.apex(*f))) > 0) broken("M6", name(e));
    });
  }

  // The reason a triangle carries, checked anew where it blames the input.
  bool excused(TriangleId t, const std::string& rule) {
    const auto found = std::ranges::lower_bound(claims_.unfinished, t, {}, &Unfinished::triangle);
    if (found == claims_.unfinished.end() || found->triangle != t) return false;
    if (!is_forced_by_input(found->reason)) return true;
    const bool by_angle = found->reason == Reason::input_angle;
    const auto holds = [&] {
      if (!by_angle) return input_->by_feature(t);
      return rule == "M7" ? input_->by_angle(t) : is_obtuse_by_rounding(mesh_, t);
    };
    if (holds()) return true;
    broken(rule, name(t) + " claims " + to_string(found->reason));
    return true;
  }

  void check_angles(double bound_deg) {
    const double bound = (bound_deg - 1e-9) * std::numbers::pi / 180;
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        const Point apex = mesh_.point(mesh_.apex(e));
        const Point u = mesh_.point(mesh_.origin(e)) - apex;
        const Point w = mesh_.point(mesh_.destination(e)) - apex;
        if (std::atan2(cross(u, w), dot(u, w)) >= bound) continue;
        if (!excused(TriangleId(t), "M7")) broken("M7", name(TriangleId(t)));
      }
    }
  }

  void check_nonobtuse() {
    for_each_half_edge([&](HalfEdge e) {
      if (!mesh_.is_constrained(e)) return;
      if (is_obtuse(mesh_.point(mesh_.origin(e)), mesh_.point(mesh_.apex(e)),
                    mesh_.point(mesh_.destination(e))) &&
          !excused(e.triangle, "M8")) {
        broken("M8", name(e) + " faces an obtuse angle");
      }
    });
  }

  bool is_above(HalfEdge e, double bound_deg) const {
    const Point a = mesh_.point(mesh_.origin(e)), apex = mesh_.point(mesh_.apex(e)),
                b = mesh_.point(mesh_.destination(e));
    if (bound_deg == 90) return is_obtuse(a, apex, b);
    const Point u = a - apex, w = b - apex;
    return std::atan2(cross(u, w), dot(u, w)) > (bound_deg + 1e-9) * std::numbers::pi / 180;
  }

  void check_large_angles(double bound_deg) {
    for_each_half_edge([&](HalfEdge e) {
      if (is_above(e, bound_deg) && !excused(e.triangle, "M9")) {
        broken("M9", name(e) + " faces an angle above the bound");
      }
    });
  }

  const Mesh& mesh_;
  const MeshClaims& claims_;
  std::optional<InputReasons> input_;
  MeshReport report_;
  std::map<std::string, std::size_t> per_rule_;
};

}  // namespace

std::string MeshReport::summary() const {
  if (valid()) return "valid";
  std::string text = std::to_string(count) + " violations";
  for (std::size_t i = 0; i < std::min<std::size_t>(violations.size(), 5); ++i) {
    text += "; " + violations[i].rule + " " + violations[i].where;
  }
  return text;
}

MeshReport validate(const Mesh& mesh, const MeshClaims& claims) {
  return Validator(mesh, claims).run();
}

}  // namespace lepp

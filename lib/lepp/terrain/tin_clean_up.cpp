#include "lepp/terrain/tin_clean_up.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/remove_vertex.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"

namespace lepp {

TinCleanUp::TinCleanUp(TerrainMesh& terrain, double min_angle_deg, double error, std::size_t frozen,
                       std::function<bool()> go_on)
    : terrain_(terrain),
      mesh_(terrain.mesh()),
      angle_(min_angle_deg),
      error_(error),
      frozen_(frozen),
      go_on_(std::move(go_on)),
      any_sharp_(segments_meet_sharply(mesh_)),
      place_(std::max(min_angle_deg, 1.0)),
      needed_(mesh_.vertex_count(), 0),
      single_(mesh_.vertex_count(), 0) {}

// ---- one vertex ---------------------------------------------------------------------------------

std::size_t TinCleanUp::remove_needless() {
  const std::size_t before = mesh_.vertex_count();
  for (std::size_t i = before; i-- > frozen_;) {  // the last vertex takes a removed one's place
    if (i >= mesh_.vertex_count() || needed_[i] != 0) continue;
    if (!go_on_()) break;
    if (can_do_without(VertexId(i))) note_changes(remove(VertexId(i)).changed);
    else needed_[i] = 1;
  }
  return before - mesh_.vertex_count();
}

bool TinCleanUp::can_do_without(VertexId v) {
  return !mesh_.is_input(v) && collect_link(v) && filling_.fill(angle_) &&
         is_filling_within_bounds(v) && is_removable(removability(mesh_, v));
}

// The corners around v, from one neighbour on its side of the mesh to the other if it is on one.
// False if v is on a line inside.
bool TinCleanUp::collect_link(VertexId v) {
  auto& corners = filling_.corners();
  corners.clear();
  const auto add = [&](VertexId c, HalfEdge to_next) {
    corners.push_back({mesh_.point(c), terrain_.corner(c), terrain_.is_hard(to_next)});
  };
  bool simple = true;
  for_each_in_fan(mesh_, v, [&](TriangleId t, std::uint32_t corner) {
    const HalfEdge out{t, previous_corner(corner)}, in{t, next_corner(corner)};
    simple = !mesh_.is_constrained(out) || mesh_.is_boundary(out);
    add(mesh_.destination(out), {t, corner});
    if (mesh_.is_boundary(in)) add(mesh_.origin(in), in);  // in its place the side will be whole
    return simple && corners.size() <= FreeStars::most_triangles;
  });
  if (!simple || corners.size() < 3 || corners.size() > FreeStars::most_triangles) return false;
  const bool is_inside = mesh_.origin_of(v).kind == VertexOrigin::Kind::interior;
  return is_inside || !any_sharp_ || !is_side_encroached();
}

// True if a corner would see the side that v cuts under more than 90 degrees.
bool TinCleanUp::is_side_encroached() const {
  const auto& corners = filling_.corners();
  const Point a = corners.front().place, b = corners.back().place;
  return std::any_of(corners.begin() + 1, corners.end() - 1,
                     [&](const StarFilling::Corner& c) { return is_obtuse(a, c.place, b); });
}

// Without v the place where it was is the most likely one to be off.
bool TinCleanUp::is_filling_within_bounds(VertexId v) const {
  const auto& corners = filling_.corners();
  const TriangleScan& scan = terrain_.scan();
  const auto all = [&](const auto& is_within) {
    return std::ranges::all_of(filling_.triangles(), [&](const std::array<std::size_t, 3>& t) {
      const std::array<TerrainCorner, 3> triangle{corners[t[0]].terrain, corners[t[1]].terrain,
                                                  corners[t[2]].terrain};
      return is_within(triangle, filling_.hard_sides(t));
    });
  };
  const TerrainCorner suspect = terrain_.corner(v);
  return all([&](const auto& t, Sides) { return scan.is_within_at(t, suspect, error_); }) &&
         all([&](const auto& t, Sides hard) { return scan.is_within(t, error_, hard); });
}

Removal TinCleanUp::remove(VertexId v) {
  for (auto* of_vertices : {&needed_, &single_}) {
    (*of_vertices)[v.index()] = of_vertices->back();
    of_vertices->pop_back();
  }
  return terrain_.remove(v, error_);
}

void TinCleanUp::note_changes(const std::vector<TriangleId>& changed) {
  for (const TriangleId t : changed) {
    for (const VertexId v : mesh_.vertices(t)) needed_[v.index()] = single_[v.index()] = 0;
  }
}

// ---- two vertices -------------------------------------------------------------------------------

std::size_t TinCleanUp::merge() {
  const std::size_t before = mesh_.vertex_count();
  for (std::size_t i = before; i-- > frozen_;) {
    if (i >= mesh_.vertex_count() || single_[i] != 0) continue;
    if (!go_on_()) break;
    if (!is_free(mesh_, VertexId(i), frozen_) || !merge_with_neighbour(VertexId(i))) single_[i] = 1;
  }
  return before - mesh_.vertex_count();
}

// Pairs are tried by the later vertex, and by the other one if that has changed since.
bool TinCleanUp::merge_with_neighbour(VertexId v) {
  const HalfEdge out = mesh_.leaving(v);
  if (!find_star(mesh_, out.triangle, next_corner(out.edge), whole_, FreeStars::most_triangles))
    return false;
  for (std::size_t i = 0; i < whole_.size(); ++i) {
    const VertexId w = mesh_.origin(whole_.link[i].edge);
    if (!is_free(mesh_, w, frozen_) || (v < w && single_[w.index()] != 0) || !join_stars(i))
      continue;
    suspects_ = {terrain_.corner(v), terrain_.corner(w)};
    if (const auto p = place_for_both(midpoint(mesh_.point(v), mesh_.point(w)))) {
      replace_both(v, w, *p);
      return true;
    }
  }
  return false;
}

//         x          Without the edges at v and w, the link of v leads from x to y and that of w
//       / | \        back to x. That of v starts at w with edge i; find_star() lists that of w
//      v--e--w       from the edge beside w -> v on.
//       \ | /
//         y
bool TinCleanUp::join_stars(std::size_t i) {
  const HalfEdge f = *mesh_.twin(previous_edge(whole_.link[i].edge));
  if (!find_star(mesh_, f.triangle, next_corner(f.edge), part_, FreeStars::most_triangles))
    return false;
  star_.link.clear();
  const std::size_t n = whole_.size();
  for (std::size_t k = i + 1; k + 1 < i + n; ++k) {
    star_.link.push_back(whole_.link[k < n ? k : k - n]);
  }
  for (std::size_t k = 1; k + 1 < part_.size(); ++k) star_.link.push_back(part_.link[k]);
  return true;
}

std::optional<Point> TinCleanUp::place_for_both(Point near) {
  const auto place = place_.find(star_, near);
  if (!place) return std::nullopt;
  const Point at_sample = terrain_.snapped(*place);
  if (has_good_angles(at_sample) && is_star_within_bounds(at_sample)) return at_sample;
  if (at_sample != *place && has_good_angles(*place) && is_star_within_bounds(*place)) return place;
  return std::nullopt;
}

// Of a center at p; and it is no corner of another triangle's circle.
bool TinCleanUp::has_good_angles(Point p) const {
  if (!sees_link(star_, p)) return false;
  for (std::size_t i = 0; i < star_.size(); ++i) {
    const auto& [edge, from, constrained] = star_.link[i];
    if (angle_.is_below(p, from, star_.to(i))) return false;
    if (constrained) {
      if (would_encroach(mesh_, edge, p)) return false;
    } else {
      const auto [a, b, c] = mesh_.corners(mesh_.twin(edge)->triangle);
      if (incircle(a, b, c, p) > 0) return false;
    }
  }
  return true;
}

//      a---c         Where the spoke p b is not Delaunay there will be an ear a b c: all such
//     / \ /|         spokes go first. The ears are Delaunay, so that no angle of theirs is below
//    p---b |  ...    the smallest of the star.
bool TinCleanUp::is_star_within_bounds(Point p) {
  auto& rim = filling_.corners();
  rim.clear();
  for (const auto& side : star_.link) {
    const bool hard = terrain_.is_hard(side.edge);
    rim.push_back({side.from, terrain_.corner(mesh_.origin(side.edge)), hard});
  }
  std::size_t delaunay = 0;  // so many spokes in a row are
  for (std::size_t i = 0; delaunay < rim.size() && rim.size() > 3;) {
    const std::size_t before = i == 0 ? rim.size() - 1 : i - 1;
    const std::size_t after = i + 1 == rim.size() ? 0 : i + 1;
    const auto &a = rim[before], &b = rim[i], &c = rim[after];
    if (orient2d(a.place, b.place, c.place) <= 0 || incircle(a.place, b.place, c.place, p) > 0) {
      ++delaunay;
      i = after;
      continue;
    }
    const auto hard = static_cast<Sides>((b.hard ? 1U : 0U) | (a.hard ? 4U : 0U));
    if (!terrain_.scan().is_within({a.terrain, b.terrain, c.terrain}, error_, hard)) return false;
    rim[before].hard = false;
    rim.erase(rim.begin() + static_cast<std::ptrdiff_t>(i));
    i = i == 0 ? rim.size() - 1 : i - 1;
    delaunay = 0;
  }
  return is_center_within_bounds(p);
}

bool TinCleanUp::is_center_within_bounds(Point p) const {
  const TerrainCorner center = terrain_.space().corner(p, terrain_.height_of(p));
  const TriangleScan& scan = terrain_.scan();
  const auto& rim = filling_.corners();
  const auto all = [&](const auto& is_within) {
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const auto& next = rim[i + 1 == rim.size() ? 0 : i + 1];
      const auto hard = static_cast<Sides>(rim[i].hard ? 1U : 0U);
      if (!is_within({center, rim[i].terrain, next.terrain}, hard)) return false;
    }
    return true;
  };
  using Corners = std::array<TerrainCorner, 3>;
  return all([&](const Corners& t, Sides) {
           return scan.is_within_at(t, suspects_[0], error_) &&
                  scan.is_within_at(t, suspects_[1], error_);
         }) &&
         all([&](const Corners& t, Sides hard) { return scan.is_within(t, error_, hard); });
}

void TinCleanUp::replace_both(VertexId v, VertexId w, Point p) {
  remove(std::max(v, w));
  const Removal removal = remove(std::min(v, w));
  changed_.clear();
  const auto at = locate(mesh_, p, removal.changed.front());
  assert(at);  // it sees the whole link of both
  [[maybe_unused]] const bool inserted = terrain_.insert_inside(at->triangle, p, changed_);
  assert(inserted);
  needed_.push_back(0);
  single_.push_back(0);
  terrain_.rescan(changed_);
  terrain_.choose_diagonals(changed_, error_);
  note_changes(changed_);
}

}  // namespace lepp

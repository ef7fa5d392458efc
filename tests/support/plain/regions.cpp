#include "support/plain/regions.hpp"

#include <algorithm>
#include <iterator>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp::plain {

namespace {

using SurfaceSet = std::vector<SurfaceId>;  // ascending

// a and b differ in exactly these.
SurfaceSet toggle(const SurfaceSet& a, const SurfaceSet& b) {
  SurfaceSet result;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(result));
  return result;
}

// The triangles joined across unconstrained edges, numbered by their first triangle.
struct Components {
  std::vector<std::uint32_t> of_triangle;
  std::uint32_t count = 0;
};

Components components_of(const Mesh& mesh) {
  constexpr std::uint32_t unknown = 0xFFFFFFFFU;
  Components components{std::vector<std::uint32_t>(mesh.triangle_count(), unknown)};
  std::vector<TriangleId> open;
  for (std::size_t first = 0; first < mesh.triangle_count(); ++first) {
    if (components.of_triangle[first] != unknown) continue;
    open.emplace_back(first);
    while (!open.empty()) {  // each triangle gets its number once
      const TriangleId t = open.back();
      open.pop_back();
      components.of_triangle[t.index()] = components.count;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{t, i};
        const auto across = mesh.twin(e);
        if (!across || mesh.is_constrained(e)) continue;
        if (components.of_triangle[across->triangle.index()] == unknown) {
          open.push_back(across->triangle);
        }
      }
    }
    ++components.count;
  }
  return components;
}

class RegionFinder {
 public:
  RegionFinder(Mesh& mesh, const Pslg& pslg, TriangulationReport& report)
      : mesh_(mesh),
        pslg_(pslg),
        report_(report),
        components_(components_of(mesh)),
        outside_(components_.count, false),
        surface_(components_.count) {
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        if (mesh_.is_boundary(e) && !mesh_.is_constrained(e)) outside_[component(e)] = true;
      }
    }
  }

  void find_by_bounds() {
    std::vector<std::optional<SurfaceSet>> sets(components_.count);
    start_from_outside(sets);
    spread(sets);
    for (std::uint32_t c = 0; c < components_.count; ++c) {
      if (!sets[c] || sets[c]->empty()) continue;
      if (sets[c]->size() > 1) throw overlap_error(c, *sets[c]);
      surface_[c] = sets[c]->front();
    }
    check_every_surface_has_area();
  }

  void find_by_seeds() {
    report_.convex_hull = std::ranges::find(outside_, false) == outside_.end();
    if (report_.convex_hull) outside_.assign(outside_.size(), false);
    carve_holes();
    place_seeds();
    std::optional<SurfaceId> rest;
    for (std::uint32_t c = 0; c < components_.count; ++c) {
      if (outside_[c]) surface_[c].reset();
      else if (!surface_[c]) surface_[c] = rest ? rest : rest = add_default_surface();
    }
  }

  std::vector<std::optional<SurfaceId>> of_triangles() const {
    std::vector<std::optional<SurfaceId>> regions;
    regions.reserve(mesh_.triangle_count());
    for (const std::uint32_t c : components_.of_triangle) regions.push_back(surface_[c]);
    return regions;
  }

 private:
  std::uint32_t component(HalfEdge e) const { return components_.of_triangle[e.triangle.index()]; }

  // The surfaces that are entered or left where edge e is crossed.
  SurfaceSet toggled_by(HalfEdge e) const {
    SurfaceSet set;
    if (!mesh_.is_constrained(e)) return set;
    for (const SegmentId s : mesh_.segments_of(e)) {
      const auto& curve = mesh_.segments()[s.index()].curve;
      if (!curve) continue;
      for (const SurfaceId surface : mesh_.entities()[*curve].bounds) set = toggle(set, {surface});
    }
    return set;
  }

  void start_from_outside(std::vector<std::optional<SurfaceSet>>& sets) {
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        if (mesh_.is_boundary(e)) enter(e, toggled_by(e), sets);
      }
    }
  }

  void spread(std::vector<std::optional<SurfaceSet>>& sets) {
    // Constrained edges by the component they are seen from, so that each is crossed once.
    std::vector<std::vector<HalfEdge>> walls(components_.count);
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        if (mesh_.is_constrained(e) && !mesh_.is_boundary(e)) walls[component(e)].push_back(e);
      }
    }
    while (!entered_.empty()) {
      const std::uint32_t c = entered_.back();
      entered_.pop_back();
      for (const HalfEdge e : walls[c]) {
        enter(*mesh_.twin(e), toggle(*sets[c], toggled_by(e)), sets);
      }
    }
  }

  void enter(HalfEdge e, const SurfaceSet& set, std::vector<std::optional<SurfaceSet>>& sets) {
    auto& known = sets[component(e)];
    if (!known) {
      known = set;
      entered_.push_back(component(e));
    } else if (*known != set) {
      const SurfaceId surface = toggle(*known, set).front();
      throw InputError(pslg_.source + ", surface " + std::to_string(tag(surface)),
                       "its boundary is not closed near " + to_text(mesh_.point(mesh_.origin(e))),
                       "close the loop, or remove curves that occur twice");
    }
  }

  int tag(SurfaceId s) const { return mesh_.entities()[s].tag; }

  Point somewhere_in(std::uint32_t c) const {
    const auto first = std::ranges::find(components_.of_triangle, c);
    const auto [p, q, r] = mesh_.corners(
        TriangleId(static_cast<std::size_t>(first - components_.of_triangle.begin())));
    return {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3};
  }

  InputError overlap_error(std::uint32_t c, const SurfaceSet& set) const {
    return {pslg_.source + ", surfaces " + std::to_string(tag(set[0])) + " and " +
                std::to_string(tag(set[1])),
            "they overlap, for example at " + to_text(somewhere_in(c)),
            "make the inner one a hole of the outer one, or cut them apart"};
  }

  void check_every_surface_has_area() const {
    std::vector<bool> found(mesh_.entities().surfaces.size(), false);
    for (const auto& surface : surface_) {
      if (surface) found[surface->index()] = true;
    }
    const auto empty = std::ranges::find(found, false);
    if (empty == found.end()) return;
    const SurfaceId surface(static_cast<std::size_t>(empty - found.begin()));
    throw InputError(pslg_.source + ", surface " + std::to_string(tag(surface)),
                     "its boundary encloses no area",
                     "correct the boundary, or remove the surface");
  }

  bool is_in(TriangleId t, Point p) const {
    const auto [a, b, c] = mesh_.corners(t);
    return orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0;
  }

  // \pre is_in(t, p)
  bool is_on_segment(TriangleId t, Point p) const {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{t, i};
      const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
      if (mesh_.is_constrained(e) && orient2d(a, b, p) == 0) return true;
    }
    return false;
  }

  // The component around a hole or seed; nothing, with a warning, if it is outside.
  std::optional<std::uint32_t> component_at(Point p, const std::string& what) {
    std::optional<std::uint32_t> found;
    bool on_segment = false;
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      const std::uint32_t c = components_.of_triangle[t];
      if (outside_[c] || !is_in(TriangleId(t), p)) continue;
      if (!found) found = c;
      on_segment = on_segment || is_on_segment(TriangleId(t), p);
    }
    if (!found) report_.warnings.push_back(what + " at " + to_text(p) + " is outside the domain");
    if (on_segment) {
      throw InputError(pslg_.source + ", " + what, "lies on a segment at " + to_text(p),
                       "move it into the area it is meant for");
    }
    return found;
  }

  void carve_holes() {
    std::vector<std::uint32_t> carved;
    for (std::size_t i = 0; i < pslg_.holes.size(); ++i) {
      const auto number = std::to_string(pslg_.base + static_cast<std::int64_t>(i));
      const auto c = component_at(pslg_.holes[i], "hole " + number);
      if (c) carved.push_back(*c);
    }
    for (const std::uint32_t c : carved) outside_[c] = true;
    if (std::ranges::find(outside_, false) != outside_.end()) return;
    throw InputError(pslg_.source + ", hole " + std::to_string(pslg_.base),
                     "is not enclosed: it removes the whole domain",
                     "close the ring of segments around the hole");
  }

  void place_seeds() {
    for (std::size_t i = 0; i < pslg_.seeds.size(); ++i) {
      const auto number = std::to_string(pslg_.base + static_cast<std::int64_t>(i));
      const auto c = component_at(pslg_.seeds[i].at, "region " + number);
      if (!c) continue;
      if (surface_[*c] && *surface_[*c] != pslg_.seeds[i].surface) {
        report_.warnings.push_back("region " + number +
                                   " lies in the same area as an earlier one: ignored");
        continue;
      }
      surface_[*c] = pslg_.seeds[i].surface;
    }
  }

  SurfaceId add_default_surface() {
    Entities entities = mesh_.entities();
    entities.surfaces.emplace_back();
    mesh_.set_entities(std::move(entities));
    return SurfaceId(mesh_.entities().surfaces.size() - 1);
  }

  Mesh& mesh_;
  const Pslg& pslg_;
  TriangulationReport& report_;
  Components components_;
  std::vector<bool> outside_;
  std::vector<std::optional<SurfaceId>> surface_;
  std::vector<std::uint32_t> entered_;
};

}  // namespace

std::vector<std::optional<SurfaceId>> find_regions(Mesh& mesh, const Pslg& pslg,
                                                   TriangulationReport& report) {
  RegionFinder finder(mesh, pslg, report);
  if (pslg.has_bounded_surfaces()) finder.find_by_bounds();
  else finder.find_by_seeds();
  return finder.of_triangles();
}

}  // namespace lepp::plain

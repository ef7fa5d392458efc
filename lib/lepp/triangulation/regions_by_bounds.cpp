#include "lepp/triangulation/regions_by_bounds.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

using Code = RawTriangulation::Code;
using SurfaceSet = std::vector<SurfaceId>;  // ascending

// a and b differ in exactly these.
SurfaceSet toggle(const SurfaceSet& a, const SurfaceSet& b) {
  SurfaceSet result;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(result));
  return result;
}

class BoundedRegions {
 public:
  BoundedRegions(const RawTriangulation& raw, const Pslg& pslg, std::uint32_t count)
      : raw_(raw), pslg_(pslg), sets_(count + 1), walls_(count + 1) {}

  std::vector<std::optional<SurfaceId>> run(const SegmentPieces& pieces) {
    find_walls(pieces);
    sets_[0] = SurfaceSet{};  // the outside
    entered_.push_back(0);
    for (std::uint32_t t = 0; t < raw_.triangles.size(); ++t) {
      if (raw_.is_ghost(t) && !raw_.is_constrained(RawTriangulation::code(t, 2))) {
        enter(raw_.twin(RawTriangulation::code(t, 2)), {});
      }
    }
    while (!entered_.empty()) {
      const std::uint32_t label = entered_.back();
      entered_.pop_back();
      for (const auto& [beyond, toggled] : walls_[label]) {
        enter(beyond, toggle(*sets_[label], toggled));
      }
    }
    return surfaces();
  }

 private:
  // A constrained edge as seen from one component.
  struct Wall {
    Code beyond;         // its other side
    SurfaceSet toggled;  // the surfaces that are entered or left there
  };

  std::uint32_t label(Code e) const { return raw_.label(RawTriangulation::triangle_of(e)); }

  void find_walls(const SegmentPieces& pieces) {
    std::vector<SegmentPiece> all = pieces.first;
    all.insert(all.end(), pieces.further.begin(), pieces.further.end());
    const auto ends = [](const SegmentPiece& p) {
      return std::pair(std::min(p.a, p.b), std::max(p.a, p.b));
    };
    std::ranges::stable_sort(all, {}, ends);
    for (std::size_t i = 0; i < all.size();) {
      SurfaceSet toggled;
      const std::size_t edge = i;
      for (; i < all.size() && ends(all[i]) == ends(all[edge]); ++i) {
        const auto& curve = pslg_.segments[all[i].segment.index()].curve;
        if (!curve) continue;
        for (const SurfaceId s : pslg_.entities[*curve].bounds) toggled = toggle(toggled, {s});
      }
      const Code e = raw_.edge_between(all[edge].a, all[edge].b), f = raw_.twin(e);
      walls_[label(e)].push_back({f, toggled});
      walls_[label(f)].push_back({e, std::move(toggled)});
    }
  }

  void enter(Code e, const SurfaceSet& set) {
    auto& known = sets_[label(e)];
    if (!known) {
      known = set;
      entered_.push_back(label(e));
    } else if (*known != set) {
      const SurfaceId surface = toggle(*known, set).front();
      const VertexId at = raw_.origin(e);
      throw InputError(pslg_.source + ", surface " + std::to_string(tag(surface)),
                       "its boundary is not closed near " + to_text(raw_.point(at)),
                       "close the loop, or remove curves that occur twice");
    }
  }

  std::vector<std::optional<SurfaceId>> surfaces() const {
    std::vector<std::optional<SurfaceId>> surface(sets_.size());
    for (std::uint32_t label = 1; label < sets_.size(); ++label) {
      const auto& set = sets_[label];
      if (!set || set->empty()) continue;
      if (set->size() > 1) throw overlap_error(label, *set);
      surface[label] = set->front();
    }
    check_every_surface_has_area(surface);
    return surface;
  }

  int tag(SurfaceId s) const { return pslg_.entities[s].tag; }

  Point somewhere_in(std::uint32_t label) const {
    std::uint32_t t = 0;
    while (raw_.label(t) != label) ++t;
    const auto& v = raw_.triangles[t].vertices;
    const Point p = raw_.point(v[0]), q = raw_.point(v[1]), r = raw_.point(v[2]);
    return {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3};
  }

  InputError overlap_error(std::uint32_t label, const SurfaceSet& set) const {
    return {pslg_.source + ", surfaces " + std::to_string(tag(set[0])) + " and " +
                std::to_string(tag(set[1])),
            "they overlap, for example at " + to_text(somewhere_in(label)),
            "make the inner one a hole of the outer one, or cut them apart"};
  }

  void check_every_surface_has_area(const std::vector<std::optional<SurfaceId>>& surfaces) const {
    std::vector<bool> found(pslg_.entities.surfaces.size(), false);
    for (const auto& surface : surfaces) {
      if (surface) found[surface->index()] = true;
    }
    const auto empty = std::ranges::find(found, false);
    if (empty == found.end()) return;
    const SurfaceId surface(static_cast<std::size_t>(empty - found.begin()));
    throw InputError(pslg_.source + ", surface " + std::to_string(tag(surface)),
                     "its boundary encloses no area",
                     "correct the boundary, or remove the surface");
  }

  const RawTriangulation& raw_;
  const Pslg& pslg_;
  std::vector<std::optional<SurfaceSet>> sets_;  // by label; 0 is the outside
  std::vector<std::vector<Wall>> walls_;         // by the label they are seen from
  std::vector<std::uint32_t> entered_;
};

}  // namespace

std::vector<std::optional<SurfaceId>> regions_by_bounds(const RawTriangulation& raw,
                                                        const Pslg& pslg,
                                                        const SegmentPieces& pieces,
                                                        std::uint32_t count) {
  return BoundedRegions(raw, pslg, count).run(pieces);
}

}  // namespace lepp

#include "lepp/triangulation/regions.hpp"

#include <algorithm>

#include "lepp/geometry/text.hpp"
#include "lepp/geometry/two_threads.hpp"
#include "lepp/triangulation/components.hpp"
#include "lepp/triangulation/regions_by_bounds.hpp"
#include "lepp/triangulation/spatial_order.hpp"

namespace lepp {

namespace {

constexpr std::uint32_t nowhere = 0;     // the label of ghosts
constexpr std::size_t few_seeds = 1000;  // not worth a thread

class SeedRegions {
 public:
  SeedRegions(const RawTriangulation& raw, const Pslg& pslg, TriangulationReport& report,
              const Components& components, unsigned threads)
      : raw_(raw), pslg_(pslg), report_(report), threads_(threads), outside_(components.is_open) {
    regions_.entities = pslg.entities;
    regions_.of_label.resize(components.count + 1);
  }

  Regions run() {
    report_.convex_hull = std::ranges::find(outside_, false) == outside_.end();
    if (report_.convex_hull) outside_.assign(outside_.size(), false);
    carve_holes();
    place_seeds();
    std::optional<SurfaceId> rest;
    for (std::size_t c = 0; c < outside_.size(); ++c) {
      auto& surface = regions_.of_label[c + 1];
      if (outside_[c]) surface.reset();
      else if (!surface) surface = rest ? rest : rest = add_default_surface();
    }
    return std::move(regions_);
  }

 private:
  // The label around each point; each walk starts where the one before it ended, nearby.
  std::vector<RawTriangulation::Place> locate_all(const std::vector<Point>& points) const {
    std::vector<RawTriangulation::Place> places(points.size());
    const std::vector<std::uint32_t> order = spatial_order(points);
    const auto locate = [&](std::size_t begin, std::size_t end) {
      std::uint32_t at = 0;
      for (std::size_t k = begin; k < end; ++k) {
        places[order[k]] = raw_.locate(points[order[k]], at);
        at = places[order[k]].triangle;
      }
    };
    const std::size_t middle = order.size() / 2;
    in_parallel(
        order.size() < few_seeds ? 1 : threads_, [&] { locate(0, middle); },
        [&] { locate(middle, order.size()); });
    return places;
  }

  // The label of a hole or seed; nothing, with a warning, if it is outside.
  std::optional<std::uint32_t> label_at(const RawTriangulation::Place& place, Point p,
                                        const std::string& what) {
    if (place.on_constrained) {
      throw InputError(pslg_.source + ", " + what, "lies on a segment at " + to_text(p),
                       "move it into the area it is meant for");
    }
    const std::uint32_t label = raw_.label(place.triangle);
    if (label == nowhere || outside_[label - 1]) {
      report_.warnings.push_back(what + " at " + to_text(p) + " is outside the domain: ignored");
      return std::nullopt;
    }
    return label;
  }

  std::string number(std::size_t i) const {
    return std::to_string(pslg_.base + static_cast<std::int64_t>(i));
  }

  void carve_holes() {
    const auto places = locate_all(pslg_.holes);
    std::vector<std::uint32_t> carved;
    std::size_t last = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto label = label_at(places[i], pslg_.holes[i], "hole " + number(i));
      if (!label) continue;
      carved.push_back(*label);
      last = i;
    }
    for (const std::uint32_t label : carved) outside_[label - 1] = true;
    if (std::ranges::find(outside_, false) != outside_.end()) return;
    throw InputError(pslg_.source + ", hole " + number(last),
                     report_.convex_hull ? "is not enclosed: it removes the whole domain"
                                         : "removes what is left of the domain",
                     report_.convex_hull
                         ? "close the ring of segments around the hole, or the outer boundary"
                         : "move it out of the area that is to be meshed, or remove it");
  }

  void place_seeds() {
    std::vector<Point> points;
    for (const RegionSeed& seed : pslg_.seeds) points.push_back(seed.at);
    const auto places = locate_all(points);
    std::vector<std::size_t> seed_of(regions_.of_label.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto label = label_at(places[i], points[i], "region " + number(i));
      if (!label) continue;
      auto& surface = regions_.of_label[*label];
      if (!surface) {
        surface = pslg_.seeds[i].surface;
        seed_of[*label] = i;
      } else if (*surface != pslg_.seeds[i].surface) {
        throw same_area(seed_of[*label], i);
      }
    }
  }

  InputError same_area(std::size_t first, std::size_t second) const {
    const auto name = [&](std::size_t i) {
      return number(i) + " at " + to_text(pslg_.seeds[i].at);
    };
    return {pslg_.source + ", region " + name(second),
            "lies in the same area as region " + name(first) + ", which has another attribute",
            "close the segments between them, or remove one"};
  }

  SurfaceId add_default_surface() {
    regions_.entities.surfaces.emplace_back();
    return SurfaceId(regions_.entities.surfaces.size() - 1);
  }

  const RawTriangulation& raw_;
  const Pslg& pslg_;
  TriangulationReport& report_;
  unsigned threads_;
  std::vector<bool> outside_;  // by label - 1
  Regions regions_;
};

}  // namespace

Regions find_regions(RawTriangulation& raw, const Pslg& pslg, const SegmentPieces& pieces,
                     TriangulationReport& report, unsigned threads) {
  const Components components = label_components(raw, threads);
  if (pslg.has_bounded_surfaces()) {
    return {regions_by_bounds(raw, pslg, pieces, components.count), pslg.entities};
  }
  return SeedRegions(raw, pslg, report, components, threads).run();
}

}  // namespace lepp

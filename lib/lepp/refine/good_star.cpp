#include "lepp/refine/good_star.hpp"

#include <algorithm>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/split.hpp"

namespace lepp {

namespace {

// One move may undo another, so that only a limit makes an end certain; few get near it.
constexpr std::uint8_t most_moves = 20;

// A star of n triangles has an angle of at most 360 / n at its center. When that is less than a
// third above the bound, hardly any has a good place, and only Effort::best looks for one.
std::size_t most_triangles(const RefineOptions& options) {
  const double bound = options.min_angle_deg, wanted = options.effort == Effort::best ? 1 : 4.0 / 3;
  return bound < 1 ? 360 : static_cast<std::size_t>(360 / (wanted * bound));
}

}  // namespace

GoodStar::GoodStar(Mesh& mesh, const RefineOptions& options, double floor)
    : mesh_(mesh),
      floor_(floor),
      encroaching_allowed_(options.obtuse == ObtuseRule::ignore),
      angle_(options.min_angle_deg, options.max_angle_deg),
      size_(mesh, options),
      most_triangles_(most_triangles(options)),
      place_(options.min_angle_deg, options.max_angle_deg) {}

bool GoodStar::move_corner(TriangleId t, std::uint32_t corner, std::vector<TriangleId>& changed) {
  const VertexId v = mesh_.vertex(t, corner);
  if (moves_.size() <= v.index()) moves_.resize(2 * mesh_.vertex_count(), 0);
  if (moves_[v.index()] == most_moves || !is_interior_star(t, corner, star_)) return false;
  const auto place = place_.find(star_, mesh_.point(v));
  if (!place) return false;
  const Point p = in_supported_range(*place);
  if (!is_good(p) || encroaches_beyond_link(p)) return false;
  const auto first = static_cast<std::ptrdiff_t>(changed.size());
  move_vertex(mesh_, v, star_, p, changed);
  const auto star_end = first + static_cast<std::ptrdiff_t>(star_.size());
  changed.erase(changed.begin() + first, changed.begin() + star_end);  // they are good
  ++moves_[v.index()];
  return true;
}

bool GoodStar::move_corner_to(TriangleId t, std::uint32_t corner, Point p,
                              std::vector<TriangleId>& changed) {
  if (!is_interior_star(t, corner, star_)) return false;
  const Point q = in_supported_range(p);
  if (!is_good(q) || encroaches_beyond_link(q)) return false;
  move_vertex(mesh_, mesh_.vertex(t, corner), star_, q, changed);
  return true;
}

bool GoodStar::insert(Cavity& cavity, Point p, std::vector<TriangleId>& changed) {
  star_.link.clear();
  for (const auto& rim : cavity.rim()) {
    star_.link.push_back({rim.inside, rim.from, rim.constrained});
  }
  if (has_good_triangles(p) && !encroaches_link(p)) {
    cavity.fill(mesh_, p, {VertexOrigin::Kind::interior, 0});
    return true;
  }
  if (star_.size() > most_triangles_) return false;
  const auto place = place_.find(star_, p);
  if (!place) return false;
  const Point q = in_supported_range(*place);
  if (!is_good(q) || encroaches_beyond_link(q)) return false;
  cavity.fill(mesh_, q, {VertexOrigin::Kind::interior, 0});
  stack_.clear();
  for (const TriangleId t : cavity.triangles()) {
    stack_.push_back({t, 0});
    stack_.push_back({t, 1});  // one spoke of each triangle
  }
  restore_delaunay(mesh_, stack_, &changed);
  return true;
}

bool GoodStar::is_interior_star(TriangleId t, std::uint32_t corner, Star& star) const {
  return mesh_.origin_of(mesh_.vertex(t, corner)).kind == VertexOrigin::Kind::interior &&
         find_star(mesh_, t, corner, star, most_triangles_);
}

//         x          Without the edges at v and w, the link of v leads from x to y and that of w
//       / | \        back to x. That of v starts at w with edge i; find_star() lists that of w
//      v--e--w       from the edge beside w -> v on.
//       \ | /
//         y
std::optional<Point> GoodStar::place_for_both(std::size_t i) {
  const HalfEdge e = previous_edge(whole_.link[i].edge);  // v -> w
  const HalfEdge f = *mesh_.twin(e);
  if (!is_interior_star(f.triangle, next_corner(f.edge), part_)) return std::nullopt;
  star_.link.clear();
  const std::size_t n = whole_.size();
  for (std::size_t k = i + 1; k + 1 < i + n; ++k) {
    star_.link.push_back(whole_.link[k < n ? k : k - n]);
  }
  for (std::size_t k = 1; k + 1 < part_.size(); ++k) star_.link.push_back(part_.link[k]);
  const Point v = mesh_.point(mesh_.origin(e)), w = mesh_.point(mesh_.destination(e));
  const auto place = place_.find(star_, midpoint(v, w));
  if (!place) return std::nullopt;
  const Point p = in_supported_range(*place);
  if (!is_good(p) || encroaches_beyond_link(p)) return std::nullopt;
  return p;
}

bool GoodStar::is_good(Point p) const { return sees_link(star_, p) && has_good_triangles(p); }

bool GoodStar::has_good_triangles(Point p) const {
  const SurfaceId region = mesh_.region(star_.link.front().edge.triangle);
  const double least = floor_ * floor_;
  Point a = star_.link.back().from;
  double to_a = squared_distance(p, a);
  for (const auto& side : star_.link) {
    const Point b = side.from;
    const double to_b = squared_distance(p, b);
    if (angle_.is_below(to_a, squared_distance(a, b), to_b) || to_b < least) return false;
    if (angle_.has_largest() && angle_.is_above(p, a, b)) return false;
    if (size_.is_too_large(p, a, b, region)) return false;
    a = b;
    to_a = to_b;
  }
  return true;
}

bool GoodStar::encroaches_link(Point p) const {
  return !encroaching_allowed_ && std::ranges::any_of(star_.link, [&](const Star::LinkEdge& e) {
    return e.constrained && would_encroach(mesh_, e.edge, p);
  });
}

bool GoodStar::encroaches_beyond_link(Point p) {
  return !encroaching_allowed_ && lepp::encroaches_beyond_link(mesh_, star_, p, stack_);
}

}  // namespace lepp

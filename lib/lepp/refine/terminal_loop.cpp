#include "lepp/refine/terminal_loop.hpp"

#include <algorithm>

#include "lepp/triangulation/lepp.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"

namespace lepp {

TerminalLoop::TerminalLoop(Mesh& mesh, const RefineOptions& options, std::size_t budget,
                           Judge judge)
    : mesh_(mesh),
      options_(options),
      floor_(default_size_floor(mesh)),
      allowance_(mesh, options, budget),
      bad_(std::move(judge)) {}

void TerminalLoop::run() {
  std::optional<EncroachedEdges> encroached;
  if (options_.obtuse == ObtuseRule::split_first) encroached.emplace(mesh_);
  while (allowance_.may_go_on()) {
    changed_.clear();
    if (const auto e = encroached ? encroached->next(mesh_) : std::nullopt) {
      // Features of the input below the size floor stay as they are: cutting only spreads them.
      if (!at_input_feature(mesh_, e->triangle, 2 * floor_)) cut(*e);
    } else if (const auto t = bad_.worst(mesh_)) {
      improve(*t);
    } else {
      break;
    }
    if (encroached) encroached->update(mesh_, changed_);
    for (const TriangleId t : changed_) bad_.add(mesh_, t);
  }
}

// Cuts a constrained edge; false if that is not possible.
bool TerminalLoop::cut(HalfEdge e) {
  const ConstrainedSplit split = split_constrained_edge(mesh_, e, floor_);
  changed_.insert(changed_.end(), split.changed.begin(), split.changed.end());
  return !split.vertices.empty();
}

void TerminalLoop::improve(TriangleId t) {
  const auto vertices = mesh_.vertices(t);
  const auto point = steiner_point(mesh_, terminal_edge(mesh_, t), options_.placement);
  if (!point || !insert(*point)) return;  // the size floor: dropped until a neighbour changes
  if (mesh_.vertices(t) == vertices) bad_.add(mesh_, t);
}

bool TerminalLoop::insert(const SteinerPoint& s) {
  if (s.where == SteinerPoint::Where::constrained_edge) return cut(s.edge);
  if (options_.obtuse == ObtuseRule::split_first) {
    const auto encroached = edges_encroached_by(mesh_, s.triangle, s.point);
    if (!encroached.empty()) return cut_first_possible(encroached);
  }
  if (is_too_close(s)) return false;
  const VertexOrigin origin{VertexOrigin::Kind::interior, 0};
  const Insertion done = s.where == SteinerPoint::Where::edge
                             ? insert_on_edge(mesh_, s.edge, s.point, origin)
                             : insert_in_triangle(mesh_, s.triangle, s.point, origin);
  changed_.insert(changed_.end(), done.changed.begin(), done.changed.end());
  return true;
}

// A cut moves the others to other triangles, so one at a time; the rest come up again.
bool TerminalLoop::cut_first_possible(const std::vector<HalfEdge>& edges) {
  return std::ranges::any_of(edges, [&](HalfEdge e) { return cut(e); });
}

bool TerminalLoop::is_too_close(const SteinerPoint& s) const {
  const auto near = [&](TriangleId t) {
    const auto corners = mesh_.corners(t);
    return std::ranges::any_of(
        corners, [&](Point c) { return squared_distance(c, s.point) < floor_ * floor_; });
  };
  const auto across = mesh_.twin(s.edge);
  return near(s.triangle) || (across && near(across->triangle));
}

}  // namespace lepp

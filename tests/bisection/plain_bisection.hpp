#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp::test {

/// Pure longest-edge refinement as it was before LEPPs: cut the target at the middle of its longest
/// edge, then every triangle that has a vertex inside an edge, until none has. Works on a list of
/// triangles of points, ties broken as edge_key() breaks them.
class PlainBisection {
 public:
  using Corners = std::array<Point, 3>;

  explicit PlainBisection(const Mesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) add(mesh.corners(TriangleId(t)));
  }

  /// Cuts triangle `corners`, if it is still there.
  void refine(const Corners& corners) {
    const auto found = by_corners_.find(canonical(corners));
    if (found == by_corners_.end()) return;
    cut(found->second);
    while (!pending_.empty()) {
      const std::size_t t = pending_.back();
      pending_.pop_back();
      if (is_there_[t] && has_vertex_inside_edge(t)) cut(t);
    }
  }

  /// All triangles there are, each from its least corner on, in order.
  std::vector<Corners> triangles() const {
    std::vector<Corners> all;
    for (const auto& [corners, t] : by_corners_) all.push_back(corners);
    return all;
  }

  static Corners canonical(Corners corners) {
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    return corners;
  }

 private:
  using Edge = std::pair<Point, Point>;

  static Edge edge(const Corners& corners, std::size_t i) {
    return std::minmax(Point(corners[(i + 1) % 3]), Point(corners[(i + 2) % 3]));
  }

  void add(const Corners& corners) {
    const std::size_t t = triangles_.size();
    triangles_.push_back(corners);
    is_there_.push_back(true);
    by_corners_[canonical(corners)] = t;
    for (std::size_t i = 0; i < 3; ++i) owners_[edge(corners, i)].push_back(t);
    pending_.push_back(t);
  }

  bool has_vertex_inside_edge(std::size_t t) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (cut_edges_.contains(edge(triangles_[t], i))) return true;
    }
    return false;
  }

  void cut(std::size_t t) {
    const Corners c = triangles_[t];
    std::size_t k = 0;
    for (const std::size_t i : {1U, 2U}) {
      const auto [p, q] = edge(c, i);
      const auto [r, s] = edge(c, k);
      const double length = squared_distance(p, q), most = squared_distance(r, s);
      if (length > most || (length == most && std::pair(p, q) > std::pair(r, s))) k = i;
    }
    const Point a = c[(k + 1) % 3], b = c[(k + 2) % 3], apex = c[k], middle = midpoint(a, b);
    is_there_[t] = false;
    by_corners_.erase(canonical(c));
    cut_edges_.insert(edge(c, k));
    for (const std::size_t owner : owners_[edge(c, k)]) pending_.push_back(owner);
    add({apex, a, middle});
    add({apex, middle, b});
  }

  std::vector<Corners> triangles_;
  std::vector<bool> is_there_;
  std::map<Corners, std::size_t> by_corners_;
  std::map<Edge, std::vector<std::size_t>> owners_;
  std::set<Edge> cut_edges_;
  std::vector<std::size_t> pending_;
};

}  // namespace lepp::test

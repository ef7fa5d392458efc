#include "support/oracle_cdt.hpp"

#include <algorithm>
#include <map>

#include "support/oracle.hpp"

namespace lepp::test {

namespace {

using Corners = OracleCdt::Corners;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

class BruteForce {
 public:
  BruteForce(const Arrangement& arrangement, const std::vector<Point>& holes)
      : all_(arrangement), holes_(holes), n_(static_cast<std::uint32_t>(all_.points.size())) {}

  OracleCdt run() {
    find_visible_pairs();
    for (std::uint32_t a = 0; a < n_; ++a) {
      for (std::uint32_t b = a + 1; b < n_; ++b) {
        for (std::uint32_t c = a + 1; c < n_; ++c) {
          if (b != c && sees(a, b) && sees(b, c) && sees(c, a)) consider({a, b, c});
        }
      }
    }
    std::sort(result_.triangles.begin(), result_.triangles.end());
    if (result_.unique) find_domain();
    return std::move(result_);
  }

 private:
  int side(std::uint32_t a, std::uint32_t b, Point p) const {
    return oracle_orient2d(all_.points[a], all_.points[b], p);
  }
  bool sees(std::uint32_t a, std::uint32_t b) const { return visible_[a * n_ + b]; }

  // Two points see each other if no piece crosses the line between them and no point lies on it.
  void find_visible_pairs() {
    visible_.assign(std::size_t{n_} * n_, false);
    for (std::uint32_t a = 0; a < n_; ++a) {
      for (std::uint32_t b = a + 1; b < n_; ++b) {
        visible_[a * n_ + b] = visible_[b * n_ + a] = !is_blocked(a, b);
      }
    }
  }

  bool is_blocked(std::uint32_t a, std::uint32_t b) const {
    const Point p = all_.points[a], q = all_.points[b];
    for (const auto& [c, d] : all_.pieces) {
      if (cross_inside(p, q, all_.points[c], all_.points[d])) return true;
    }
    for (std::uint32_t c = 0; c < n_; ++c) {
      if (c == a || c == b || side(a, b, all_.points[c]) != 0) continue;
      if (oracle_dot_sign(p, all_.points[c], q) < 0) return true;
    }
    return false;
  }

  bool is_inside(const Corners& t, Point p) const {
    return side(t[0], t[1], p) >= 0 && side(t[1], t[2], p) >= 0 && side(t[2], t[0], p) >= 0;
  }

  void consider(const Corners& t) {
    const auto& [a, b, c] = t;
    if (side(a, b, all_.points[c]) <= 0) return;
    bool on_circle = false;
    for (std::uint32_t d = 0; d < n_; ++d) {
      if (d == a || d == b || d == c) continue;
      if (is_inside(t, all_.points[d])) return;
      if (!sees(a, d) || !sees(b, d) || !sees(c, d)) continue;
      const int inside =
          oracle_incircle(all_.points[a], all_.points[b], all_.points[c], all_.points[d]);
      if (inside > 0) return;
      on_circle = on_circle || inside == 0;
    }
    result_.triangles.push_back(t);
    if (on_circle) result_.unique = false;
  }

  void find_domain() {
    for (std::size_t t = 0; t < result_.triangles.size(); ++t) {
      for (const Edge& e : edges_of(t)) triangle_of_[e] = t;
    }
    removed_.assign(result_.triangles.size(), false);
    const bool closed = all_.closed_faces() > 0;
    for (std::size_t t = 0; t < result_.triangles.size(); ++t) {
      for (const auto& [a, b] : edges_of(t)) {
        if (closed && !triangle_of_.contains({b, a}) && !all_.has_piece(a, b)) remove_from(t);
      }
      for (const Point hole : holes_) {
        if (is_inside(result_.triangles[t], hole)) remove_from(t);
      }
    }
    for (std::size_t t = 0; t < removed_.size(); ++t) {
      if (!removed_[t]) result_.domain.push_back(result_.triangles[t]);
    }
  }

  std::array<Edge, 3> edges_of(std::size_t t) const {
    const auto& [a, b, c] = result_.triangles[t];
    return {Edge(a, b), Edge(b, c), Edge(c, a)};
  }

  void remove_from(std::size_t first) {
    std::vector<std::size_t> open{first};
    while (!open.empty()) {  // each triangle is removed once
      const std::size_t t = open.back();
      open.pop_back();
      if (removed_[t]) continue;
      removed_[t] = true;
      for (const auto& [a, b] : edges_of(t)) {
        const auto across = triangle_of_.find({b, a});
        if (across != triangle_of_.end() && !all_.has_piece(a, b)) open.push_back(across->second);
      }
    }
  }

  const Arrangement& all_;
  const std::vector<Point>& holes_;
  std::uint32_t n_;
  std::vector<bool> visible_, removed_;
  std::map<Edge, std::size_t> triangle_of_;
  OracleCdt result_;
};

}  // namespace

OracleCdt brute_force_cdt(const Arrangement& arrangement, const std::vector<Point>& holes) {
  return BruteForce(arrangement, holes).run();
}

}  // namespace lepp::test

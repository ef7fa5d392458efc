#include "support/oracle_arrangement.hpp"

#include <algorithm>
#include <numeric>

#include "support/oracle.hpp"

namespace lepp::test {

namespace {

std::vector<std::uint32_t> sorted_by_place(const std::vector<Point>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(points[i], i) < std::pair(points[j], j);
  });
  return order;
}

void merge_copies(const Pslg& pslg, Arrangement& result) {
  const std::vector<std::uint32_t> order = sorted_by_place(pslg.points);
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool copy = k > 0 && pslg.points[order[k - 1]] == pslg.points[order[k]];
    first[order[k]] = copy ? first[order[k - 1]] : order[k];
  }
  result.point_of.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (first[i] == i) {
      result.point_of[i] = static_cast<std::uint32_t>(result.points.size());
      result.points.push_back(pslg.points[i]);
    } else {
      result.point_of[i] = result.point_of[first[i]];
    }
  }
}

// The points on ab, from a to b. `order` holds all points from left to right.
std::vector<std::uint32_t> points_on(const Arrangement& all,
                                     const std::vector<std::uint32_t>& order, std::uint32_t a,
                                     std::uint32_t b) {
  if (a == b) return {a};
  const Point p = all.points[a], q = all.points[b];
  const auto [low, high] = std::minmax(p, q);
  const auto [down, up] = std::minmax(p.y, q.y);
  std::vector<std::uint32_t> chain;
  auto at = std::lower_bound(order.begin(), order.end(), low,
                             [&](std::uint32_t i, Point limit) { return all.points[i] < limit; });
  for (; at != order.end() && all.points[*at] <= high; ++at) {
    const Point r = all.points[*at];
    if (r.y < down || r.y > up || oracle_orient2d(p, q, r) != 0) continue;
    chain.push_back(*at);
  }
  if (q < p) std::reverse(chain.begin(), chain.end());
  return chain;
}

void find_crossings(Arrangement& result) {
  struct Box {
    double left, right, down, up;
    std::uint32_t piece;
  };
  std::vector<Box> boxes;
  for (const auto& [a, b] : result.pieces) {
    const Point p = result.points[a], q = result.points[b];
    boxes.push_back({std::min(p.x, q.x), std::max(p.x, q.x), std::min(p.y, q.y), std::max(p.y, q.y),
                     static_cast<std::uint32_t>(boxes.size())});
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& r, const Box& s) {
    return std::pair(r.left, r.piece) < std::pair(s.left, s.piece);
  });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto& [a, b] = result.pieces[boxes[i].piece];
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].left <= boxes[i].right; ++j) {
      if (boxes[j].down > boxes[i].up || boxes[j].up < boxes[i].down) continue;
      const auto& [c, d] = result.pieces[boxes[j].piece];
      if (!cross_inside(result.points[a], result.points[b], result.points[c], result.points[d])) {
        continue;
      }
      result.crossings.push_back(std::minmax(boxes[i].piece, boxes[j].piece));
    }
  }
}

}  // namespace

bool cross_inside(Point a, Point b, Point c, Point d) {
  return oracle_orient2d(a, b, c) * oracle_orient2d(a, b, d) < 0 &&
         oracle_orient2d(c, d, a) * oracle_orient2d(c, d, b) < 0;
}

bool Arrangement::has_piece(std::uint32_t a, std::uint32_t b) const {
  return std::binary_search(pieces.begin(), pieces.end(), Piece(std::minmax(a, b)));
}

std::vector<std::uint32_t> Arrangement::hull() const {
  std::vector<std::uint32_t> order = sorted_by_place(points), chain;
  for (const bool upper : {false, true}) {
    const std::size_t start = chain.size();
    for (const std::uint32_t i : order) {
      while (chain.size() >= start + 2 && oracle_orient2d(points[chain[chain.size() - 2]],
                                                          points[chain.back()], points[i]) < 0) {
        chain.pop_back();
      }
      chain.push_back(i);
    }
    chain.pop_back();  // the other half begins with it
    if (!upper) std::reverse(order.begin(), order.end());
  }
  return chain;
}

std::size_t Arrangement::closed_faces(const std::vector<Piece>& more) const {
  std::vector<std::uint32_t> root(points.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&](std::uint32_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  std::size_t faces = 0;
  for (const auto* edges : {&pieces, &more}) {
    for (const Piece& edge : *edges) {
      const std::uint32_t u = find(edge.first), w = find(edge.second);
      if (u == w) ++faces;  // joined already: the edge closes one more cycle
      else root[u] = w;
    }
  }
  return faces;
}

Arrangement arrange(const Pslg& pslg) {
  Arrangement result;
  merge_copies(pslg, result);
  const std::vector<std::uint32_t> order = sorted_by_place(result.points);
  for (const Segment& s : pslg.segments) {
    result.chains.push_back(
        points_on(result, order, result.point_of[s.a.index()], result.point_of[s.b.index()]));
    const auto& chain = result.chains.back();
    for (std::size_t i = 1; i < chain.size(); ++i) {
      result.pieces.emplace_back(std::minmax(chain[i - 1], chain[i]));
    }
  }
  std::sort(result.pieces.begin(), result.pieces.end());
  result.pieces.erase(std::unique(result.pieces.begin(), result.pieces.end()), result.pieces.end());
  find_crossings(result);
  for (std::size_t i = 2; i < result.points.size() && result.collinear; ++i) {
    result.collinear = oracle_orient2d(result.points[0], result.points[1], result.points[i]) == 0;
  }
  return result;
}

}  // namespace lepp::test

#include "lepp/terrain/fill_notches.hpp"

#include <numeric>

namespace lepp {

namespace {

struct Step {
  std::int64_t x = 0, y = 0;
};

Step operator-(LatticePoint b, LatticePoint a) {
  return {std::int64_t{b.column} - a.column, std::int64_t{b.line} - a.line};
}

std::int64_t cross(Step a, Step b) { return a.x * b.y - a.y * b.x; }

// Pieces between neighbouring samples on it.
std::int64_t pieces(Step s) { return std::gcd(s.x, s.y); }

// How many samples the triangle abc has, apart from those on ab and bc: by the theorem of Pick,
// twice the area is twice the points inside plus those on the boundary less 2.
std::int64_t samples_beyond(Step ab, Step bc, std::int64_t twice_area) {
  const std::int64_t third = pieces({ab.x + bc.x, ab.y + bc.y});
  const std::int64_t boundary = pieces(ab) + pieces(bc) + third;
  return (twice_area - boundary + 2) / 2 + third - 1;
}

class Filler {
 public:
  Filler(const std::vector<OutlineEdge>& edges, std::vector<std::uint32_t>& next)
      : edges_(edges), next_(next), previous_(next.size()) {
    for (std::uint32_t e = 0; e < next.size(); ++e) previous_[next[e]] = e;
  }

  void run() {
    std::vector<std::uint32_t> waiting(next_.size());
    std::iota(waiting.rbegin(), waiting.rend(), 0U);
    while (!waiting.empty()) {  // ends: what is put back follows a removal
      const std::uint32_t b = waiting.back();
      waiting.pop_back();
      if (next_[b] == removed || !can_go(b)) continue;
      const std::uint32_t a = previous_[b], c = next_[b];
      next_[a] = c;
      previous_[c] = a;
      next_[b] = removed;
      waiting.push_back(c);
      waiting.push_back(a);
    }
  }

 private:
  LatticePoint at(std::uint32_t e) const { return edges_[e].start(); }

  // Of two rings, or twice of one.
  bool is_shared(std::uint32_t b) const {
    return (b > 0 && at(b - 1) == at(b)) || (b + 1 < edges_.size() && at(b + 1) == at(b));
  }

  bool can_go(std::uint32_t b) const {
    const std::uint32_t a = previous_[b], c = next_[b];
    if (previous_[a] == c || is_shared(b)) return false;
    const Step ab = at(b) - at(a), bc = at(c) - at(b);
    const std::int64_t turn = cross(ab, bc);
    if (turn == 0) return true;
    return turn < 0 && samples_beyond(ab, bc, -turn) == 0;
  }

  const std::vector<OutlineEdge>& edges_;
  std::vector<std::uint32_t>& next_;
  std::vector<std::uint32_t> previous_;
};

}  // namespace

void fill_notches(const std::vector<OutlineEdge>& edges, std::vector<std::uint32_t>& next) {
  Filler(edges, next).run();
}

}  // namespace lepp

#include "lepp/geometry/near_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

namespace lepp {

namespace {

constexpr std::size_t small = 16;        // so many pieces are compared pair by pair
constexpr std::size_t sample_size = 31;  // boxes looked at to choose where to cut
constexpr std::size_t fan_rest = 16;     // a fan may have so many pieces beside it
constexpr int max_stuck = 8;             // so many cuts in a row that part next to nothing
constexpr std::size_t medium = 64;       // up to here comparing each with each is no disaster
constexpr double credit = 4;             // so many times that may be spent on cuts
constexpr double rounding = 0x1p-49;  // of clipped coordinates, relative to the ends of the piece

// The part of a strip inside the cell at hand.
struct Entry {
  Point low, high;
  std::uint32_t id;
};

// Cells lie one after the other on a stack of entries; the last cell is the next to be done.
struct Cell {
  std::size_t begin;
  int stuck;
  double credit_left;  // comparisons it may cost, over those of each with each
};

enum class Axis { x, y };

double low(const Entry& e, Axis axis) { return axis == Axis::x ? e.low.x : e.low.y; }
double high(const Entry& e, Axis axis) { return axis == Axis::x ? e.high.x : e.high.y; }

bool overlap(const Entry& e, const Entry& f) {
  return e.low.x <= f.high.x && f.low.x <= e.high.x && e.low.y <= f.high.y && f.low.y <= e.high.y;
}

// Where to cut a cell, how many entries of the sample would go to both sides, and how long the
// entries are that way.
struct Cut {
  Axis axis = Axis::x;
  double at = 0;
  std::size_t on_both_sides = 0;
  double length = 0;
};

bool is_better(const Cut& c, const Cut& d) {
  return c.on_both_sides < d.on_both_sides ||
         (c.on_both_sides == d.on_both_sides && c.length > d.length);
}

class NearPairs {
 public:
  NearPairs(std::span<const Strip> strips,
            const std::function<bool(std::uint32_t, std::uint32_t)>& visit)
      : strips_(strips), visit_(visit) {}

  void run() {
    for (std::size_t i = 0; i < strips_.size(); ++i) stack_.push_back(whole(i));
    cells_.push_back({0, 0, credit});
    while (!cells_.empty() && !stopped_) {  // ends: parts get smaller, or max_stuck is reached
      const Cell cell = cells_.back();
      cells_.pop_back();
      entries_.assign(stack_.begin() + static_cast<std::ptrdiff_t>(cell.begin), stack_.end());
      stack_.resize(cell.begin);
      if (has_segment()) handle(cell);
    }
  }

 private:
  bool is_point(std::uint32_t id) const { return strips_[id].a == strips_[id].b; }

  bool has_segment() const {
    return std::ranges::any_of(entries_, [&](const Entry& e) { return !is_point(e.id); });
  }

  Entry whole(std::size_t i) const {
    const auto& [a, b, reach] = strips_[i];
    const Point low{std::min(a.x, b.x), std::min(a.y, b.y)};
    const Point high{std::max(a.x, b.x), std::max(a.y, b.y)};
    return {low - reach, high + reach, static_cast<std::uint32_t>(i)};
  }

  void handle(const Cell& cell) {
    if (entries_.size() <= small) return compare_all();
    const Cut cut = best_cut();
    part(cut);
    const std::size_t n = entries_.size();
    const std::size_t most = std::max(below_.size(), above_.size());
    if (4 * (below_.size() + above_.size()) > 5 * n) {
      if (compare_fan()) return;
      if (compare_along_direction(8 * n)) return;
      if (n > medium && part_along_a_piece()) return push_halves({0, 0, credit});
      part(cut);
    }
    const double left = std::min(
        credit, cell.credit_left * pairs(n) / (pairs(below_.size()) + pairs(above_.size())));
    const int stuck = 10 * most > 9 * n ? cell.stuck + weight_of_cut() : 0;
    if (stuck > max_stuck || (n <= medium && left < 1)) {
      compare_along_direction({});
      return;
    }
    push_halves({0, stuck, left});
  }

  // Of pieces that overlap along a line, a cut only makes copies, and of their pairs as well: one
  // such cut may be bad luck, a second one is not tried.
  int weight_of_cut() const {
    return 5 * (below_.size() + above_.size()) > 9 * entries_.size() ? max_stuck : 1;
  }

  static double pairs(std::size_t n) { return static_cast<double>(n) * static_cast<double>(n); }

  void push_halves(Cell cell) {
    for (const auto* half : {&above_, &below_}) {
      cell.begin = stack_.size();
      cells_.push_back(cell);
      stack_.insert(stack_.end(), half->begin(), half->end());
    }
  }

  void compare(const Entry& e, const Entry& f) {
    if (stopped_ || !overlap(e, f) || (is_point(e.id) && is_point(f.id))) return;
    stopped_ = !visit_(std::min(e.id, f.id), std::max(e.id, f.id));
  }

  void compare_all() {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      for (std::size_t j = i + 1; j < entries_.size(); ++j) compare(entries_[i], entries_[j]);
    }
  }

  const Entry& sample(std::size_t k) const {
    return entries_[k * (entries_.size() - 1) / (sample_size - 1)];
  }

  // At the median of a sample, across x or y, whichever cuts fewer pieces in two.
  Cut best_cut() const {
    std::optional<Cut> best;
    for (const Axis axis : {Axis::x, Axis::y}) {
      std::array<double, sample_size> middles;
      for (std::size_t k = 0; k < sample_size; ++k) {
        middles[k] = 0.5 * (low(sample(k), axis) + high(sample(k), axis));
      }
      std::ranges::nth_element(middles, middles.begin() + sample_size / 2);
      Cut cut{axis, middles[sample_size / 2], 0, 0};
      for (std::size_t k = 0; k < sample_size; ++k) {
        const Entry& e = sample(k);
        if (low(e, axis) <= cut.at && cut.at <= high(e, axis)) ++cut.on_both_sides;
        cut.length += high(e, axis) - low(e, axis);
      }
      if (!best || is_better(cut, *best)) best = cut;
    }
    return *best;
  }

  void part(const Cut& cut) {
    below_.clear();
    above_.clear();
    for (const Entry& e : entries_) {
      const bool is_below = low(e, cut.axis) <= cut.at, is_above = high(e, cut.axis) >= cut.at;
      if (is_below && is_above) {
        below_.push_back(clipped(e, cut, false));
        above_.push_back(clipped(e, cut, true));
      } else {
        (is_below ? below_ : above_).push_back(e);
      }
    }
  }

  // The part of e on one side of the cut. Both coordinates of a piece grow together, or one falls
  // as the other grows: that tells which of the four sides of the box moves.
  Entry clipped(Entry e, const Cut& cut, bool above) const {
    const auto& [a, b, reach] = strips_[e.id];
    const bool across_x = cut.axis == Axis::x;
    const double u_a = across_x ? a.x : a.y, u_b = across_x ? b.x : b.y;
    const double v_a = across_x ? a.y : a.x, v_b = across_x ? b.y : b.x;
    const double u_reach = across_x ? reach.x : reach.y, v_reach = across_x ? reach.y : reach.x;
    double& u_end = across_x ? (above ? e.low.x : e.high.x) : (above ? e.low.y : e.high.y);
    u_end = cut.at;
    if (u_a == u_b) return e;
    // From the nearer end, so that pieces over many scales are as sharp as the scale at hand.
    const double at = cut.at + (above ? -u_reach : u_reach);
    const bool near_a = std::abs(at - u_a) < std::abs(at - u_b);
    const double u_0 = near_a ? u_a : u_b, v_0 = near_a ? v_a : v_b;
    const double slope = (v_b - v_a) / (u_b - u_a), rise = (at - u_0) * slope;
    const double v = std::clamp(v_0 + rise, std::min(v_a, v_b), std::max(v_a, v_b));
    double room = v_reach + rounding * (std::abs(v_0) + std::abs(rise));
    if (u_reach > 0) room += rounding * std::abs(slope) * (std::abs(cut.at) + u_reach);
    double& v_low = across_x ? e.low.y : e.low.x;
    double& v_high = across_x ? e.high.y : e.high.x;
    const bool v_grows = (u_a < u_b) == (v_a < v_b);
    if (above == v_grows) v_low = std::max(v_low, v - room);
    else v_high = std::min(v_high, v + room);
    return e;
  }

  // Rays around a small circle are in each other's way in every box, but the line through one of
  // them has half of the others on each side. Leaves below_ and above_ so, or returns false.
  bool part_along_a_piece() {
    std::size_t fewest = sample_size;
    Point best{0, 0};
    double best_at = 0;
    for (std::size_t k = 0; k < sample_size; ++k) {
      if (is_point(sample(k).id)) continue;
      const Point normal = across(sample(k));
      const auto [low, high] = projection(sample(k), normal);
      const double at = 0.5 * (low + high);
      std::size_t below = 0, above = 0;
      for (std::size_t j = 0; j < sample_size; ++j) {
        const auto [from, to] = projection(sample(j), normal);
        below += from <= at ? 1U : 0U;
        above += to >= at ? 1U : 0U;
      }
      if (std::max(below, above) < fewest) {
        fewest = std::max(below, above);
        best = normal;
        best_at = at;
      }
    }
    if (4 * fewest > 3 * sample_size) return false;
    below_.clear();
    above_.clear();
    for (const Entry& e : entries_) {
      const auto [from, to] = projection(e, best);
      if (from <= best_at) below_.push_back(e);
      if (to >= best_at) above_.push_back(e);
    }
    const std::size_t n = entries_.size();
    return 5 * std::max(below_.size(), above_.size()) <= 4 * n &&
           8 * (below_.size() + above_.size()) <= 9 * n;
  }

  // Pieces with a common end cannot be cut apart there, and need not be: only neighbours in the
  // order of their directions can overlap. Succeeds if nearly all pieces have one end in common.
  bool compare_fan() {
    const auto hub = common_end();
    if (!hub) return false;
    std::vector<Entry> fan, rest;
    for (const Entry& e : entries_) (has_end(e, *hub) ? fan : rest).push_back(e);
    if (rest.size() > fan_rest) return false;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      for (std::size_t j = i + 1; j < rest.size(); ++j) compare(rest[i], rest[j]);
      for (const Entry& e : fan) compare(rest[i], e);
    }
    compare_neighbours(fan, *hub);
    return true;
  }

  bool has_end(const Entry& e, Point p) const {
    return !is_point(e.id) && strips_[e.id].reach == Point{0, 0} &&
           (strips_[e.id].a == p || strips_[e.id].b == p);
  }

  // The end that more than half of the pieces have, if there is one: a vote of majority.
  std::optional<Point> common_end() const {
    std::optional<Point> leader;
    std::size_t lead = 0;
    for (const Entry& e : entries_) {
      for (const Point p : {strips_[e.id].a, strips_[e.id].b}) {
        if (lead == 0) leader = p, lead = 1;
        else if (p == *leader) ++lead;
        else if (!has_end(e, *leader)) --lead;
      }
    }
    return leader;
  }

  // Pieces of one direction have, to rounding, one quotient of the smaller by the larger
  // coordinate difference; those are compared, the rest of the fan is not.
  void compare_neighbours(const std::vector<Entry>& fan, Point hub) {
    struct Spoke {
      int octant;
      double slope;
      std::size_t entry;
    };
    std::vector<Spoke> spokes;
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const Strip& strip = strips_[fan[i].id];
      const Point d = (strip.a == hub ? strip.b : strip.a) - hub;
      const bool flat = std::abs(d.x) >= std::abs(d.y);
      const double sign = (flat ? d.x : d.y) > 0 ? 1 : -1;
      const double slope = flat ? d.y / d.x : d.x / d.y;
      spokes.push_back({(flat ? 0 : 2) + (sign > 0 ? 0 : 1), slope, i});
      if (std::abs(slope) < 1 - rounding) continue;  // on a border: in the next octant as well
      const double other_sign = (flat ? d.y : d.x) > 0 ? 1 : -1;
      spokes.push_back({(flat ? 2 : 0) + (other_sign > 0 ? 0 : 1), 1 / slope, i});
    }
    std::ranges::sort(spokes, [](const Spoke& s, const Spoke& t) {
      return std::tie(s.octant, s.slope, s.entry) < std::tie(t.octant, t.slope, t.entry);
    });
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      for (std::size_t j = i + 1; j < spokes.size(); ++j) {
        if (spokes[j].octant != spokes[i].octant) break;
        if (spokes[j].slope - spokes[i].slope > rounding) break;
        compare(fan[spokes[i].entry], fan[spokes[j].entry]);
      }
    }
  }

  // Long pieces that run side by side: sorts them by where they lie across their common direction
  // and compares those whose intervals overlap. Gives up above `limit` pairs.
  bool compare_along_direction(std::optional<std::size_t> limit) {
    const Point normal = across_common_direction();
    struct Interval {
      double low, high;
      std::size_t entry;
    };
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const auto [low, high] = projection(entries_[i], normal);
      intervals.push_back({low, high, i});
    }
    std::ranges::sort(intervals, [](const Interval& a, const Interval& b) {
      return std::tie(a.low, a.entry) < std::tie(b.low, b.entry);
    });
    const auto overlapping = [&](auto use) {
      for (std::size_t i = 0; i < intervals.size(); ++i) {
        for (std::size_t j = i + 1; j < intervals.size(); ++j) {
          if (intervals[j].low > intervals[i].high) break;
          if (!use(entries_[intervals[i].entry], entries_[intervals[j].entry])) return false;
        }
      }
      return true;
    };
    std::size_t pairs = 0;
    if (limit && !overlapping([&](const Entry&, const Entry&) { return ++pairs < *limit; })) {
      return false;
    }
    overlapping([&](const Entry& e, const Entry& f) { return compare(e, f), !stopped_; });
    return true;
  }

  Point direction(const Entry& e) const {
    const auto& [a, b, reach] = strips_[e.id];
    if (is_point(e.id)) return {0, 0};
    const bool grows = (a.x < b.x) == (a.y < b.y);
    return {e.high.x - e.low.x, grows ? e.high.y - e.low.y : e.low.y - e.high.y};
  }

  Point across(const Entry& e) const {
    const Point d = direction(e);
    const double length = std::hypot(d.x, d.y);
    return length > 0 ? Point{-d.y / length, d.x / length} : Point{1, 0};
  }

  // The mean direction, each piece weighted by its squared length, opposite directions alike.
  Point across_common_direction() const {
    Point twice{0, 0};
    for (const Entry& e : entries_) {
      const Point d = direction(e);
      twice = twice + Point{d.x * d.x - d.y * d.y, 2 * d.x * d.y};
    }
    const double angle = 0.5 * std::atan2(twice.y, twice.x);
    return {-std::sin(angle), std::cos(angle)};
  }

  std::pair<double, double> projection(const Entry& e, Point normal) const {
    const auto& [a, b, reach] = strips_[e.id];
    const bool grows = (a.x < b.x) == (a.y < b.y);
    const double p = dot(normal, {e.low.x, grows ? e.low.y : e.high.y});
    const double q = dot(normal, {e.high.x, grows ? e.high.y : e.low.y});
    const double room_x = 2 * reach.x + 4 * rounding * (std::abs(a.x) + std::abs(b.x));
    const double room_y = 2 * reach.y + 4 * rounding * (std::abs(a.y) + std::abs(b.y));
    const double room = std::abs(normal.x) * room_x + std::abs(normal.y) * room_y;
    return {std::min(p, q) - room, std::max(p, q) + room};
  }

  std::span<const Strip> strips_;
  const std::function<bool(std::uint32_t, std::uint32_t)>& visit_;
  std::vector<Entry> stack_, entries_, below_, above_;
  std::vector<Cell> cells_;
  bool stopped_ = false;
};

}  // namespace

void for_each_near_pair(std::span<const Strip> strips,
                        const std::function<bool(std::uint32_t, std::uint32_t)>& visit) {
  NearPairs(strips, visit).run();
}

}  // namespace lepp

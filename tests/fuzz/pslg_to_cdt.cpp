#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "fuzz/target.hpp"
#include "support/random.hpp"
#include "support/trial.hpp"

namespace lepp::test {

namespace {

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool empty() const { return at_ == bytes_.size(); }
  unsigned next() { return empty() ? 0U : bytes_[at_++]; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

constexpr std::size_t max_points = 40, max_segments = 40, max_marks = 4;

// A lattice coordinate 0 to 15 with -8 to 7 ulp beside it: one byte.
double coordinate(unsigned byte, double unit, double offset) {
  const double lattice = unit * (byte & 15U) + offset;
  const int ulps = static_cast<int>(byte >> 4) - 8;
  const bool jitter = (byte >> 4) != 0 && lattice != 0;  // a high half of 0 means the lattice point
  return jitter ? move_by_ulps(lattice, ulps) : lattice;
}

// The first byte chooses the lattice; then come groups of a kind and two bytes: a point, a segment
// between points so far, a hole or a region in the middle of a lattice square.
Pslg pslg_from(Bytes bytes) {
  static constexpr double units[] = {1, 0.1, 0x1p-100, 0x1p+100};
  static constexpr double offsets[] = {0, 1, 1e7, -0x1p+49};
  Pslg pslg;
  pslg.source = "fuzz";
  const unsigned lattice = bytes.next();
  const double unit = units[lattice & 3U], offset = unit * offsets[lattice >> 2 & 3U];
  while (!bytes.empty()) {
    const unsigned kind = bytes.next(), p = bytes.next(), q = bytes.next();
    const std::size_t n = pslg.points.size();
    const Point middle{unit * (0.5 + (p & 15U)) + offset, unit * (0.25 + (q & 15U)) + offset};
    if (kind % 16 == 15 && pslg.holes.size() < max_marks) {
      pslg.holes.push_back(middle);
    } else if (kind % 16 == 14 && pslg.seeds.size() < max_marks) {
      pslg.seeds.push_back({middle, SurfaceId(pslg.entities.surfaces.size())});
      pslg.entities.surfaces.emplace_back();
    } else if (kind % 2 == 0 && n < max_points) {
      const double x = coordinate(p, unit, offset);
      pslg.points.push_back({x, coordinate(q, unit, offset)});
    } else if (n > 0 && pslg.segments.size() < max_segments) {
      const CurveId curve(pslg.entities.curves.size());
      pslg.entities.curves.push_back({static_cast<int>(curve.value) + 1, {}, StraightCurve{}, {}});
      pslg.segments.push_back({VertexId(p % n), VertexId(q % n), curve, 0, 1});
    }
  }
  return pslg;
}

}  // namespace

void fail(const char* what) {
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

void fuzz_pslg_to_cdt(std::span<const std::uint8_t> bytes) {
  const Pslg pslg = pslg_from(Bytes(bytes));
  const Arrangement arrangement = arrange(pslg);
  const Trial refuse = try_pslg(pslg, arrangement, Crossings::refuse);
  if (refuse.failure) fail(refuse.failure->c_str());
  if (refuse.result) {
    const auto difference = difference_from_plain(*refuse.result, pslg);
    if (difference) fail(difference->c_str());
  }
  if (arrangement.crossings.empty()) return;
  const Trial split = try_pslg(pslg, arrangement, Crossings::split);
  if (split.failure) fail(split.failure->c_str());
}

}  // namespace lepp::test

#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include "lepp/geometry/pslg.hpp"
#include "lepp/geometry/text.hpp"
#include "support/oracle_arrangement.hpp"
#include "support/random.hpp"
#include "support/sanitized.hpp"

namespace lepp::test {

/// A lattice point, perhaps a few ulp beside it.
struct LatticePoint {
  int x = 0, y = 0;
  int ulps_x = 0, ulps_y = 0;

  Point place() const { return {moved(x, ulps_x), moved(y, ulps_y)}; }

 private:
  // Beside zero there is nothing in the supported range.
  static double moved(double c, int ulps) { return c == 0 ? 0 : move_by_ulps(c, ulps); }
};

/// A PSLG that RapidCheck can make smaller: fewer points and segments, coordinates closer to zero.
/// Three corners stay, so that there is an area.
struct SmallPslg {
  std::vector<LatticePoint> points;
  std::vector<std::pair<unsigned, unsigned>>
      segments;  ///< of the corners and points, modulo their number

  Pslg pslg() const {
    Pslg result;
    result.source = "property";
    result.points = {{0, 0}, {9, 0}, {0, 9}};
    for (const LatticePoint& p : points) result.points.push_back(p.place());
    const std::size_t n = result.points.size();
    for (const auto& [a, b] : segments) add_segment(result, a % n, b % n);
    return result;
  }

  /// Without the segments that cross an earlier one.
  Pslg pslg_without_crossings() const {
    const Pslg all = pslg();
    Pslg result = all;
    result.segments.clear();
    result.entities.curves.clear();
    const auto at = [&](VertexId v) { return all.points[v.index()]; };
    for (const Segment& s : all.segments) {
      const bool crosses =
          std::any_of(result.segments.begin(), result.segments.end(), [&](const Segment& other) {
            return cross_inside(at(s.a), at(s.b), at(other.a), at(other.b));
          });
      if (!crosses) add_segment(result, s.a.index(), s.b.index());
    }
    return result;
  }

 private:
  static void add_segment(Pslg& pslg, std::size_t a, std::size_t b) {
    const CurveId curve(pslg.entities.curves.size());
    pslg.entities.curves.push_back({static_cast<int>(curve.value) + 1, {}, StraightCurve{}, {}});
    pslg.segments.push_back({VertexId(a), VertexId(b), curve, 0, 1});
  }
};

inline std::ostream& operator<<(std::ostream& out, const SmallPslg& small) {
  const Pslg pslg = small.pslg();
  out << "points";
  for (const Point p : pslg.points) out << " " << to_text(p);
  out << "; segments";
  for (const Segment& s : pslg.segments) out << " " << s.a.value << "-" << s.b.value;
  return out;
}

/// Asks `property` of random arguments and prints the seed. The seed is fixed, so that a failure
/// in one run is one in the next; RC_PARAMS="seed=7 max_success=100000" asks for others.
template <class Property>
bool holds(const std::string& name, Property property) {
  static const bool once = [] {
    const std::string parameters = "seed=20263 max_success=" + std::to_string(cases(1000));
    return setenv("RC_PARAMS", parameters.c_str(), 0) == 0;
  }();
  return once && rc::check(name, std::move(property));
}

}  // namespace lepp::test

namespace rc {

template <>
struct Arbitrary<lepp::test::LatticePoint> {
  static Gen<lepp::test::LatticePoint> arbitrary() {
    using lepp::test::LatticePoint;
    const auto ulps = gen::weightedOneOf<int>({{9, gen::just(0)}, {1, gen::inRange(-2, 3)}});
    return gen::build<LatticePoint>(gen::set(&LatticePoint::x, gen::inRange(0, 9)),
                                    gen::set(&LatticePoint::y, gen::inRange(0, 9)),
                                    gen::set(&LatticePoint::ulps_x, ulps),
                                    gen::set(&LatticePoint::ulps_y, ulps));
  }
};

template <>
struct Arbitrary<lepp::test::SmallPslg> {
  static Gen<lepp::test::SmallPslg> arbitrary() {
    using lepp::test::LatticePoint;
    using lepp::test::SmallPslg;
    const auto index = gen::inRange(0U, 64U);
    return gen::build<SmallPslg>(
        gen::set(&SmallPslg::points, gen::scale(0.3, gen::container<std::vector<LatticePoint>>(
                                                         gen::arbitrary<LatticePoint>()))),
        gen::set(&SmallPslg::segments,
                 gen::scale(0.15, gen::container<std::vector<std::pair<unsigned, unsigned>>>(
                                      gen::pair(index, index)))));
  }
};

}  // namespace rc

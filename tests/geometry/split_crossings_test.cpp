#include "lepp/geometry/split_crossings.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <random>

#include "support/hard_pslgs.hpp"
#include "support/plain_meetings.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

// The pieces of each segment form a chain between its ends: every place but those two is an end of
// an even number of them.
bool are_chains(const Pslg& input, const SplitPslg& split) {
  std::map<std::tuple<SegmentId, double, double>, int> ends;
  const auto count = [&](SegmentId of, Point p) { ++ends[{of, p.x + 0.0, p.y + 0.0}]; };
  for (std::size_t i = 0; i < split.pslg.segments.size(); ++i) {
    const Segment& s = split.pslg.segments[i];
    for (const VertexId v : {s.a, s.b}) count(split.segment_of[i], split.pslg.points[v.index()]);
  }
  for (std::size_t i = 0; i < input.segments.size(); ++i) {
    const Segment& s = input.segments[i];
    for (const VertexId v : {s.a, s.b}) count(SegmentId(i), input.points[v.index()]);
  }
  return std::ranges::all_of(ends, [](const auto& end) { return end.second % 2 == 0; });
}

bool starts_with(const std::vector<Point>& points, const std::vector<Point>& first) {
  return points.size() >= first.size() && std::equal(first.begin(), first.end(), points.begin());
}

bool is_clean(const Pslg& pslg) {
  const SegmentMeetings found = test::plain_meetings(pslg);
  return found.pairs.empty() && found.points_on_segments.empty();
}

}  // namespace

TEST_CASE("nearly degenerate segments are split so that none meet elsewhere than at common ends") {
  const unsigned seed = 20265;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::size_t made = 0;
  for (int i = 0; i < 5'000; ++i) {
    CAPTURE(i);
    const Pslg pslg = test::hard_pslg(random);
    const SplitPslg split = split_crossings(pslg);
    REQUIRE(is_clean(split.pslg));
    REQUIRE(are_chains(pslg, split));
    REQUIRE(starts_with(split.pslg.points, pslg.points));
    REQUIRE(split.pslg.points.size() == pslg.points.size() + split.crossings_split);
    check_ids_and_range(split.pslg);
    made += split.crossings_split;
  }
  CHECK(made > 10'000);
}

TEST_CASE("two segments through the same four neighbouring points are split") {
  // Found among a million; the first four need a detour, the last crosses beside the gap at 0.
  const std::pair<std::uint64_t, std::uint64_t> found[] = {
      {77, 466746}, {77, 661369}, {77, 710595}, {77, 957707}, {11, 80114}};
  for (const auto& [seed, number] : found) {
    CAPTURE(number);
    std::mt19937_64 random(seed * 1000000007U + number);
    const Pslg pslg = test::hard_pslg(random);
    const SplitPslg split = split_crossings(pslg);
    CHECK(is_clean(split.pslg));
    CHECK(are_chains(pslg, split));
    CHECK(split.rounds <= 6);
  }
}

TEST_CASE("a clean PSLG comes back as it was") {
  const Pslg pslg = test::example_1();
  const SplitPslg split = split_crossings(pslg);
  CHECK(split.rounds == 0);
  CHECK(split.crossings_split == 0);
  CHECK(split.pslg.points == pslg.points);
  CHECK(split.pslg.segments.size() == pslg.segments.size());
  CHECK(split.pslg.segment_numbers.empty());
}

TEST_CASE("pieces keep curve, parameters and the number of their segment") {
  Pslg pslg = test::polygon({0, 0, 4, 0, 4, 4, 0, 4});
  pslg.base = 1;
  pslg.entities.curves.push_back({7, {}, StraightCurve{}, {}});
  test::add_chain(pslg, {{1, -1}, {1, 3}}, false);  // crosses segment 1 at a quarter of both
  pslg.segments[0].curve = CurveId(0U);
  pslg.segments[0].t_a = 0.5;
  const SplitPslg split = split_crossings(pslg);
  REQUIRE(split.crossings_split == 1);
  REQUIRE(split.pslg.segments.size() == 7);
  CHECK(split.pslg.points.back() == Point{1, 0});
  for (const std::size_t i : {0U, 1U}) {
    CHECK(split.pslg.segments[i].curve == CurveId(0U));
    CHECK(split.pslg.segment_number(SegmentId(i)) == 1);
  }
  CHECK(split.pslg.segments[0].t_a == 0.5);
  CHECK(split.pslg.segments[0].t_b == 0.625);
  CHECK(split.pslg.segments[1].t_a == 0.625);
  CHECK(split.pslg.segments[1].t_b == 1);
  CHECK(split.pslg.segment_number(SegmentId(6U)) == 5);
  CHECK(split.segment_of[6] == SegmentId(4U));
}

TEST_CASE("points on segments cut them without moving anything") {
  Pslg pslg = test::polygon({0, 0, 4, 0, 4, 4, 0, 4});
  pslg.points.push_back({3, 0});
  test::add_chain(pslg, {{1, 0}, {2, 0}}, false);  // an overlap
  const SplitPslg split = split_crossings(pslg);
  CHECK(split.crossings_split == 0);
  CHECK(split.points_on_segments == 3);
  CHECK(split.pslg.points == pslg.points);
  CHECK(split.pslg.segments.size() == 8);  // the piece from 1 to 2 is there twice
  CHECK(is_clean(split.pslg));
}

TEST_CASE("lines nearly through one point, and parallel lines an ulp apart, are split") {
  Pslg pencil;
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.07 * i;
    const Point d{3 * std::cos(angle), 3 * std::sin(angle)};
    test::add_chain(pencil, {Point{0.1, 0.7} - d, Point{0.1, 0.7} + d}, false);
  }
  Pslg parallel;
  double up = 1;
  for (int i = 0; i < 20; ++i, up = std::nextafter(up, 2)) {
    test::add_chain(parallel, {{0, up}, {10, up + 1}}, false);
    test::add_chain(parallel, {{0.37 * i, 0}, {0.37 * i + 0.1, 3}}, false);
  }
  for (const Pslg& pslg : {pencil, parallel}) {
    const SplitPslg split = split_crossings(pslg);
    CHECK(is_clean(split.pslg));
    CHECK(are_chains(pslg, split));
    CHECK(split.rounds <= 6);
  }
}

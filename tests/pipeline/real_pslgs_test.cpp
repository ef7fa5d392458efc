// Drawings, maps and hard cases of other projects, in process; see support/foreign_pslg.hpp.

#include <doctest/doctest.h>

#include <set>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/geometry/segment_meetings.hpp"
#include "lepp/geometry/split_crossings.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/foreign_pslg.hpp"
#include "support/table.hpp"

using namespace lepp;
using test::Row;

namespace {

std::size_t count_in(const Row& row, const char* column) {
  return static_cast<std::size_t>(std::stoul(row.at(column)));
}

std::size_t count_of(const SegmentMeetings& found, SegmentMeeting kind) {
  return static_cast<std::size_t>(std::ranges::count(found.pairs, kind, &SegmentPair::meeting));
}

// Places inside segments: each place counts once per segment.
std::size_t points_inside(const Pslg& pslg, const SegmentMeetings& found) {
  std::set<std::pair<Point, SegmentId>> inside;
  const auto at = [&](VertexId v) { return pslg.points[v.index()]; };
  for (const auto& [v, s] : found.points_on_segments) inside.emplace(at(v), s);
  const auto add_ends = [&](SegmentId of, SegmentId on) {
    const Segment &r = pslg.segments[of.index()], &s = pslg.segments[on.index()];
    for (const Point p : {at(r.a), at(r.b)}) {
      if (p == at(s.a) || p == at(s.b) || !is_on_segment(p, at(s.a), at(s.b))) continue;
      inside.emplace(p, on);
    }
  };
  for (const SegmentPair& pair : found.pairs) {
    if (pair.meeting == SegmentMeeting::crossing) continue;
    add_ends(pair.first, pair.second);
    add_ends(pair.second, pair.first);
  }
  return inside.size();
}

// Nothing if the file is not there, or has coordinates outside the supported range, which the
// reader refuses.
std::optional<Pslg> real_pslg(const Row& row) {
  const auto file = test::real_input(row.at("file"));
  if (!file) return std::nullopt;
  try {
    return test::read_foreign_pslg(*file);
  } catch (const InputError& error) {
    CHECK(error.problem().find("outside the supported range") != std::string::npos);
    return std::nullopt;
  }
}

bool names_a_place_or_number(const Error& error) {
  const std::string text = error.where() + error.problem();
  return text.find_first_of("0123456789") != std::string::npos;
}

}  // namespace

TEST_CASE("real PSLGs: duplicates, crossings and overlaps are counted as others count them") {
  const auto rows = test::table("pslg_properties.csv");
  CHECK((rows.size() > 200 || !test::has_real_inputs()));
  for (const Row& row : rows) {
    CAPTURE(row.at("file"));
    const auto read = real_pslg(row);
    if (!read) continue;
    const Pslg& pslg = *read;
    const SegmentMeetings found = find_segment_meetings(pslg);
    CHECK(pslg.points.size() == count_in(row, "vertices"));
    CHECK(pslg.segments.size() == count_in(row, "edges"));
    CHECK(found.duplicate_points.size() == count_in(row, "duplicate_vertices"));
    CHECK(found.zero_length.size() == count_in(row, "zero_length_edges"));
    CHECK(found.repeated_segments.size() == count_in(row, "repeated_edges"));
    CHECK(count_of(found, SegmentMeeting::crossing) == count_in(row, "crossing_pairs"));
    CHECK(count_of(found, SegmentMeeting::overlapping) == count_in(row, "collinear_overlaps"));
    CHECK(points_inside(pslg, found) == count_in(row, "vertices_inside_edges"));
    if (row.at("class") == "clean PSLG") CHECK(found.none());
  }
}

TEST_CASE("real PSLGs: a valid mesh once crossings are split, else an error that says where") {
  std::size_t meshed = 0;
  for (const Row& row : test::table("pslg_properties.csv")) {
    CAPTURE(row.at("file"));
    const auto read = real_pslg(row);
    if (!read) continue;
    const Pslg& pslg = *read;
    const bool crosses = row.at("crossing_pairs") != "0";
    for (const Crossings crossings : {Crossings::refuse, Crossings::split}) {
      try {
        const Triangulation made = constrained_delaunay(pslg, {crossings});
        CHECK(validate(made.mesh).summary() == "valid");
        ++meshed;
      } catch (const Error& error) {
        CAPTURE(std::string(error.what()));
        CHECK(row.at("class") != "clean PSLG");
        CHECK(names_a_place_or_number(error));
        const bool no_area = error.problem().find("point") != std::string::npos ||
                             error.problem().find("not enclosed") != std::string::npos ||
                             error.problem().find("removes what is left") != std::string::npos;
        CHECK((no_area || (crosses && crossings == Crossings::refuse)));
      }
    }
  }
  CHECK((meshed > 400 || !test::has_real_inputs()));
}

TEST_CASE("real PSLGs: splitting leaves nothing to split, and no point moves") {
  for (const Row& row : test::table("pslg_properties.csv")) {
    CAPTURE(row.at("file"));
    const auto read = real_pslg(row);
    if (!read) continue;
    const Pslg& pslg = *read;
    const SplitPslg split = split_crossings(pslg);
    const SegmentMeetings left = find_segment_meetings(split.pslg);
    CHECK(left.pairs.empty());
    CHECK(left.points_on_segments.empty());
    CHECK(std::equal(pslg.points.begin(), pslg.points.end(), split.pslg.points.begin()));
    CHECK(split.rounds <= 4);
  }
}

// Rings of other projects: holes that touch, islands in holes, rings that cross themselves.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/geometry/segment_intersection.hpp"
#include "lepp/geometry/segment_meetings.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/foreign_pslg.hpp"
#include "support/table.hpp"

using namespace lepp;

namespace {

using Paths = std::vector<std::filesystem::path>;

Paths files_in(const std::string& name) {
  Paths files;
  const auto folder = test::real_input(name);
  if (!folder) return files;
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

// Those that are in no table.
Paths overlay_files() {
  Paths files;
  for (const char* folder : {"pslg/ioverlay_json", "pslg/jts_xml", "pslg/clipper2_txt"}) {
    const Paths more = files_in(folder);
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

Paths ring_files() {
  Paths files = files_in("pslg/ioverlay_json");
  for (const test::Row& row : test::table("pslg_properties.csv")) {
    const std::string& name = row.at("file");
    const auto is_in = [&](const char* folder) { return name.find(folder) != std::string::npos; };
    if (!is_in("earcut_json") && !is_in("geojson/") && !is_in("poly2tri_dat")) continue;
    if (const auto file = test::real_input(name)) files.push_back(*file);
  }
  return files;
}

// Every segment is a side of a ring, and crossing it enters or leaves the one surface.
Pslg even_odd(Pslg pslg) {
  pslg.entities = {};
  pslg.entities.surfaces.emplace_back();
  for (Segment& s : pslg.segments) {
    s.curve = CurveId(pslg.entities.curves.size());
    pslg.entities.curves.push_back({0, {}, StraightCurve{}, {SurfaceId(0U)}});
  }
  return pslg;
}

// The area that an odd number of rings go around, slab by slab: between two neighbouring heights of
// ends and crossings the segments do not change places.
double scan_line_area(const Pslg& pslg) {
  struct Side {
    Point low, high;
  };
  std::vector<Side> sides;
  std::vector<double> heights;
  for (const Segment& s : pslg.segments) {
    const Point a = pslg.points[s.a.index()] - pslg.points[0];
    const Point b = pslg.points[s.b.index()] - pslg.points[0];
    heights.insert(heights.end(), {a.y, b.y});
    if (a.y != b.y) sides.push_back(a.y < b.y ? Side{a, b} : Side{b, a});
  }
  const auto x_at = [](const Side& s, double y) {
    return s.low.x + (s.high.x - s.low.x) * ((y - s.low.y) / (s.high.y - s.low.y));
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double low = std::max(sides[i].low.y, sides[j].low.y);
      const double high = std::min(sides[i].high.y, sides[j].high.y);
      if (low >= high) continue;
      const double before = x_at(sides[i], low) - x_at(sides[j], low);
      const double after = x_at(sides[i], high) - x_at(sides[j], high);
      if (before * after < 0) heights.push_back(low + (high - low) * before / (before - after));
    }
  }
  std::ranges::sort(heights);
  CompensatedSum area;
  std::vector<double> xs;
  for (std::size_t k = 1; k < heights.size(); ++k) {
    const double middle = 0.5 * (heights[k - 1] + heights[k]);
    xs.clear();
    for (const Side& s : sides) {
      if (s.low.y < middle && middle < s.high.y) xs.push_back(x_at(s, middle));
    }
    std::ranges::sort(xs);
    for (std::size_t i = 1; i < xs.size(); i += 2) {
      area.add((heights[k] - heights[k - 1]) * (xs[i] - xs[i - 1]));
    }
  }
  return area.value();
}

double area_of(const Mesh& mesh) {
  CompensatedSum area;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    area.add(0.5 * cross(b - a, c - a));
  }
  return area.value();
}

// Rounded crossings move sides by an ulp of their coordinates.
double rounding_of(const Pslg& pslg) {
  const auto [left, right] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(pslg.points, {}, &Point::y);
  const double width = right.x - left.x, height = high.y - low.y;
  const double largest =
      std::max({std::abs(left.x), std::abs(right.x), std::abs(low.y), std::abs(high.y)});
  return 1e-12 * width * height + 0x1p-50 * largest * (width + height);
}

}  // namespace

TEST_CASE("real rings: the mesh covers what an odd number of rings go around") {
  const Paths files = ring_files();
  CHECK((files.size() > 140 || !test::has_real_inputs()));
  std::size_t meshed = 0;
  for (const auto& file : files) {
    CAPTURE(file.string());
    const Pslg pslg = even_odd(test::read_foreign_pslg(file));
    if (pslg.segments.empty()) continue;
    const double area = scan_line_area(pslg), rounding = rounding_of(pslg);
    try {
      const Mesh mesh = constrained_delaunay(pslg, {Crossings::split}).mesh;
      CHECK(validate(mesh).summary() == "valid");
      CHECK(std::abs(area_of(mesh) - area) <= rounding);
      ++meshed;
    } catch (const InputError& error) {
      CAPTURE(std::string(error.what()));
      CHECK(area <= rounding);
    }
  }
  CHECK((meshed > 120 || !test::has_real_inputs()));
}

TEST_CASE("real overlays: a valid mesh once crossings are split, and refused if there are any") {
  std::size_t crossing = 0;
  for (const auto& file : overlay_files()) {
    CAPTURE(file.string());
    const Pslg pslg = test::read_foreign_pslg(file);
    if (pslg.segments.empty()) continue;
    const auto crosses = [](const SegmentPair& pair) {
      return pair.meeting == SegmentMeeting::crossing;
    };
    const bool any = std::ranges::any_of(find_segment_meetings(pslg).pairs, crosses);
    crossing += any ? 1U : 0U;
    CHECK(validate(constrained_delaunay(pslg, {Crossings::split}).mesh).summary() == "valid");
    if (any) CHECK_THROWS_AS(constrained_delaunay(pslg), InputError);
    else CHECK(validate(constrained_delaunay(pslg).mesh).summary() == "valid");
  }
  CHECK((crossing > 20 || !test::has_real_inputs()));
}

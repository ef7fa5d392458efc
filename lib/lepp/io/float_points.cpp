#include "lepp/io/float_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

// The largest power of ten that is no larger than 1 and than `extent`, but for its inverse, which
// is exact: dividing by that gives the double nearest to a decimal number.
double inverse_of_unit(double extent) {
  constexpr double most = 1e15;
  double inverse = 1;
  while (inverse < most && inverse * extent < 1) inverse *= 10;
  return inverse;
}

double offset_along(double low, double high, double extent, OffsetDigits digits) {
  const bool is_far = std::max(std::abs(low), std::abs(high)) > 2 * extent;
  if (!is_far) return 0;
  const double inverse = digits == OffsetDigits::whole ? 1 : inverse_of_unit(extent);
  return std::floor(low * inverse) / inverse;
}

// They are kept: gcc 12 at -O3 leaves the rounding out where a double becomes a float and a double
// again in one go.
std::vector<FloatPoint> rounded(const WorldTin& tin, Point offset) {
  std::vector<FloatPoint> points;
  points.reserve(tin.mesh.vertex_count());
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    const Point p = tin.mesh.point(VertexId(i)) - offset;
    points.push_back({float(p.x), float(p.y), float(tin.heights[i])});
  }
  return points;
}

Point place(const FloatPoint& p) { return {p[0], p[1]}; }

}  // namespace

Point offset_of_float_files(const WorldTin& tin, OffsetDigits digits) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity}, high{-infinity, -infinity};
  for (const Point p : tin.mesh.points()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double extent = std::max(high.x - low.x, high.y - low.y);
  return {offset_along(low.x, high.x, extent, digits), offset_along(low.y, high.y, extent, digits)};
}

double rounding_of_float_file(const WorldTin& tin, OffsetDigits digits) {
  const Point offset = offset_of_float_files(tin, digits);
  const std::vector<FloatPoint> points = rounded(tin, offset);
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point off = place(points[i]) - (tin.mesh.point(VertexId(i)) - offset);
    largest = std::max({largest, std::abs(off.x), std::abs(off.y)});
  }
  return largest;
}

std::vector<FloatPoint> float_points(const WorldTin& tin, Point offset,
                                     const std::filesystem::path& path) {
  std::vector<FloatPoint> points = rounded(tin, offset);
  for (std::size_t i = 0; i < tin.mesh.triangle_count(); ++i) {
    const auto& [u, v, w] = tin.mesh.vertices(TriangleId(i));
    if (orient2d(place(points[u.index()]), place(points[v.index()]), place(points[w.index()])) > 0)
      continue;
    throw InputError(path.string() + ", triangle at " + to_text(tin.mesh.point(u)),
                     "loses its area in the 32-bit coordinates of this format",
                     "write another format: .ply and .obj keep all digits");
  }
  return points;
}

}  // namespace lepp

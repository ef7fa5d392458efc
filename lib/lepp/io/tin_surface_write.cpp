// Formats for display: OBJ, PLY, STL.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/binary_numbers.hpp"
#include "lepp/io/tin_files.hpp"

namespace lepp {

namespace {

using FloatPoint = std::array<float, 3>;

// A vector of length 1, or 0 for a triangle without area.
FloatPoint normal(const std::array<FloatPoint, 3>& corners) {
  std::array<double, 3> u{}, v{};
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = double(corners[1][i]) - double(corners[0][i]);
    v[i] = double(corners[2][i]) - double(corners[0][i]);
  }
  const std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0)) return {0, 0, 0};
  return {float(n[0] / length), float(n[1] / length), float(n[2] / length)};
}

// All digits of a whole number as far as doubles are all the whole numbers of its size.
std::string whole(double number) {
  return std::abs(number) < 0x1p53 ? std::to_string(static_cast<long long>(number))
                                   : to_text(number);
}

// 80 characters; must not begin with "solid", which says that a file is text.
std::string stl_header(const WorldTin& tin, Point offset) {
  std::string header = "lepp TIN";
  if (offset != Point{0, 0}) {
    header += "; add " + whole(offset.x) + " to x, " + whole(offset.y) + " to y";
  }
  header += "; " + tin.title;
  header.resize(80, ' ');
  return header;
}

// The vertices as the file holds them. They are kept: gcc 12 at -O3 leaves the rounding out where
// a double becomes a float and a double again in one go.
std::vector<FloatPoint> float_points(const WorldTin& tin, Point offset) {
  std::vector<FloatPoint> points;
  points.reserve(tin.mesh.vertex_count());
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    const Point p = tin.mesh.point(VertexId(i)) - offset;
    points.push_back({float(p.x), float(p.y), float(tin.heights[i])});
  }
  return points;
}

bool is_counterclockwise(const std::array<FloatPoint, 3>& c) {
  const auto place = [](const FloatPoint& p) { return Point{p[0], p[1]}; };
  return orient2d(place(c[0]), place(c[1]), place(c[2])) > 0;
}

}  // namespace

void write_obj(const WorldTin& tin, const std::filesystem::path& path) {
  AtomicFiles files;
  OutputFile& out = files.add(path);
  out << "# " << tin.title << '\n';
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    const Point p = tin.mesh.point(VertexId(i));
    out << "v " << p.x << ' ' << p.y << ' ' << tin.heights[i] << '\n';
  }
  for (const Triangle& t : tin.mesh.triangles()) {
    out << 'f';
    for (const VertexId v : t.vertices) out << ' ' << v.index() + 1;
    out << '\n';
  }
  files.commit();
}

void write_ply(const WorldTin& tin, const std::filesystem::path& path) {
  AtomicFiles files;
  OutputFile& out = files.add(path);
  out << "ply\nformat binary_little_endian 1.0\ncomment " << tin.title << "\nelement vertex "
      << tin.mesh.vertex_count() << "\nproperty double x\nproperty double y\nproperty double z\n"
      << "element face " << tin.mesh.triangle_count()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  BinaryFile<std::endian::little> binary(out);
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    const Point p = tin.mesh.point(VertexId(i));
    for (const double number : {p.x, p.y, tin.heights[i]}) binary.put(number);
  }
  for (const Triangle& t : tin.mesh.triangles()) {
    binary.put(std::uint8_t{3});
    for (const VertexId v : t.vertices) binary.put(static_cast<std::int32_t>(v.value));
  }
  files.commit();
}

Point offset_of_float_files(const WorldTin& tin) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity}, high{-infinity, -infinity};
  for (const Point p : tin.mesh.points()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto offset = [](double from, double to, double extent) {
    const bool is_far = std::max(std::abs(from), std::abs(to)) > 8 * extent;
    return is_far ? std::floor(from) : 0.0;
  };
  const double extent = std::max(high.x - low.x, high.y - low.y);
  return {offset(low.x, high.x, extent), offset(low.y, high.y, extent)};
}

void write_stl(const WorldTin& tin, const std::filesystem::path& path) {
  const Point offset = offset_of_float_files(tin);
  const std::vector<FloatPoint> points = float_points(tin, offset);
  AtomicFiles files;
  BinaryFile<std::endian::little> binary(files.add(path));
  binary.text(stl_header(tin, offset));
  binary.put(static_cast<std::uint32_t>(tin.mesh.triangle_count()));
  for (std::size_t i = 0; i < tin.mesh.triangle_count(); ++i) {
    const auto& [u, v, w] = tin.mesh.vertices(TriangleId(i));
    const std::array<FloatPoint, 3> c{points[u.index()], points[v.index()], points[w.index()]};
    if (!is_counterclockwise(c)) {
      throw InputError(
          path.string() + ", triangle at " + to_text(tin.mesh.corners(TriangleId(i))[0]),
          "loses its area in the 32-bit coordinates of STL",
          "write another format: .ply and .obj keep all digits");
    }
    for (const FloatPoint& p : {normal(c), c[0], c[1], c[2]}) {
      for (const float number : p) binary.put(number);
    }
    binary.put(std::uint16_t{0});
  }
  files.commit();
}

}  // namespace lepp

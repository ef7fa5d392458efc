// Formats for display: OBJ, PLY, STL.

#include <array>
#include <cmath>
#include <vector>

#include "lepp/geometry/text.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/binary_numbers.hpp"
#include "lepp/io/float_points.hpp"
#include "lepp/io/tin_files.hpp"

namespace lepp {

namespace {

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

// Without an exponent, as far as there is room for it.
std::string offset_text(double offset) {
  constexpr std::size_t most = 20;
  const std::string text = to_decimal_text(offset);
  return text.size() <= most ? text : to_text(offset);
}

// 80 characters; must not begin with "solid", which says that a file is text.
std::string stl_header(const WorldTin& tin, Point offset) {
  std::string header = "lepp TIN";
  if (offset != Point{0, 0}) {
    header += "; add " + offset_text(offset.x) + " to x, " + offset_text(offset.y) + " to y";
  }
  header += "; " + tin.title;
  header.resize(80, ' ');
  return header;
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

void write_stl(const WorldTin& tin, const std::filesystem::path& path) {
  const Point offset = offset_of_float_files(tin);
  const std::vector<FloatPoint> points = float_points(tin, offset, path);
  AtomicFiles files;
  BinaryFile<std::endian::little> binary(files.add(path));
  binary.text(stl_header(tin, offset));
  binary.put(static_cast<std::uint32_t>(tin.mesh.triangle_count()));
  for (std::size_t i = 0; i < tin.mesh.triangle_count(); ++i) {
    const auto& [u, v, w] = tin.mesh.vertices(TriangleId(i));
    const std::array<FloatPoint, 3> c{points[u.index()], points[v.index()], points[w.index()]};
    for (const FloatPoint& p : {normal(c), c[0], c[1], c[2]}) {
      for (const float number : p) binary.put(number);
    }
    binary.put(std::uint16_t{0});
  }
  files.commit();
}

}  // namespace lepp

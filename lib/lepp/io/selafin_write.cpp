// TELEMAC Selafin: Fortran records, each between two counts of its bytes, all big-endian.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/binary_numbers.hpp"
#include "lepp/io/boundary_loops.hpp"
#include "lepp/io/float_points.hpp"
#include "lepp/io/tin_files.hpp"

namespace lepp {

namespace {

std::string padded(std::string text, std::size_t length) {
  text.resize(length, ' ');
  return text;
}

class Records {
 public:
  Records(OutputFile& out, const std::filesystem::path& path) : out_(out), path_(path) {}

  void text(const std::string& text) {
    record(text.size(), [&] { out_.text(text); });
  }
  // value(i) for i = 0 .. n - 1
  template <class Number>
  void numbers(std::size_t n, auto value) {
    record(n * sizeof(Number), [&] {
      for (std::size_t i = 0; i < n; ++i) out_.put(static_cast<Number>(value(i)));
    });
  }
  template <std::size_t n>
  void integers(const std::array<std::int32_t, n>& list) {
    numbers<std::int32_t>(n, [&](std::size_t i) { return list[i]; });
  }

 private:
  void record(std::size_t bytes, auto write) {
    if (bytes > std::size_t{std::numeric_limits<std::int32_t>::max()}) {
      throw RefusedError(path_.string(), "is too large for Selafin: a record beyond 2^31 bytes",
                         "ask for a coarser mesh, or write UGRID (.nc)");
    }
    out_.put(static_cast<std::int32_t>(bytes));
    write();
    out_.put(static_cast<std::int32_t>(bytes));
  }

  BinaryFile<std::endian::big> out_;
  const std::filesystem::path& path_;
};

// The number of each boundary vertex along the loops, from 1; 0 inside.
std::vector<std::int32_t> boundary_numbers(const Mesh& mesh) {
  std::vector<std::int32_t> numbers(mesh.vertex_count(), 0);
  std::int32_t last = 0;
  for (const BoundaryLoop& loop : simple_boundary_loops(mesh)) {
    for (const HalfEdge e : loop.sides) {
      std::int32_t& number = numbers[mesh.origin(e).index()];
      if (number == 0) number = ++last;  // else two loops touch here
    }
  }
  return numbers;
}

template <class Real>
void write_records(Records& records, const WorldTin& tin, Point origin) {
  const auto vertices = static_cast<std::int32_t>(tin.mesh.vertex_count());
  const auto triangles = static_cast<std::int32_t>(tin.mesh.triangle_count());
  const bool doubles = sizeof(Real) == 8;
  records.text(padded(tin.title, 72) + (doubles ? "SERAFIND" : "SERAFIN "));
  records.integers<2>({1, 0});  // variables
  records.text(padded("BOTTOM", 16) + padded("M", 16));
  records.integers<10>({1, 0, static_cast<std::int32_t>(origin.x),
                        static_cast<std::int32_t>(origin.y), 0, 0, 0, 0, 0, 0});
  records.integers<4>({triangles, vertices, 3, 1});
  records.numbers<std::int32_t>(3 * tin.mesh.triangle_count(), [&](std::size_t i) {
    return tin.mesh.vertices(TriangleId(i / 3))[i % 3].value + 1;
  });
  const std::vector<std::int32_t> numbers = boundary_numbers(tin.mesh);
  records.numbers<std::int32_t>(numbers.size(), [&](std::size_t i) { return numbers[i]; });
  const auto points = tin.mesh.points();
  records.numbers<Real>(points.size(), [&](std::size_t i) { return points[i].x - origin.x; });
  records.numbers<Real>(points.size(), [&](std::size_t i) { return points[i].y - origin.y; });
  records.numbers<Real>(1, [](std::size_t) { return 0; });  // the time
  records.numbers<Real>(points.size(), [&](std::size_t i) { return tin.heights[i]; });
}

Point origin_of_floats(const WorldTin& tin, const std::filesystem::path& path) {
  const Point origin = offset_of_float_files(tin, OffsetDigits::whole);
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  if (std::max(std::abs(origin.x), std::abs(origin.y)) <= most) return origin;
  throw RefusedError(path.string(),
                     "has coordinates around " + to_text(origin) +
                         ", beyond the 32 bits that single-precision Selafin has for an origin",
                     "write doubles (--format serafind), or count from a place nearby (--origin)");
}

}  // namespace

void write_selafin(const WorldTin& tin, const std::filesystem::path& path,
                   SelafinPrecision precision) {
  AtomicFiles files;
  Records records(files.add(path), path);
  if (precision == SelafinPrecision::doubles) {
    write_records<double>(records, tin, {0, 0});
  } else {
    const Point origin = origin_of_floats(tin, path);
    float_points(tin, origin, path);  // all triangles keep an area
    write_records<float>(records, tin, origin);
  }
  files.commit();
}

}  // namespace lepp

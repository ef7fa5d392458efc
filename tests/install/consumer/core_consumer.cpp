// From arrays to a two-point-flux matrix, with lepp::core alone. Exit status 0 if all facts hold.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/pslg.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/edges_by_group.hpp"
#include "lepp/version.hpp"
#include "lepp/voronoi/admissible.hpp"

using namespace lepp;

// Solvers hand the coordinates on as they are: x0 y0 x1 y1 ...
static_assert(sizeof(Point) == 2 * sizeof(double) && std::is_standard_layout_v<Point>);

namespace {

bool all_hold = true;

void expect(bool holds, const char* fact) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", fact);
  all_hold = false;
}

///   3 +-----------------+ 2    5 x 3, less the unit square from (1, 1) to (2, 2);
///     |  7 +--+ 6   |   |      an interface (tag 3) from (3, 0) to (3, 3) cuts it in two
///     |  4 +--+ 5   |   |
///   0 +-----------------+ 1
Pslg plate() {
  const std::vector<double> coordinates{0, 0, 5, 0, 5, 3, 0, 3, 1, 1, 2,
                                        1, 2, 2, 1, 2, 3, 0, 3, 3, 4, 1.5};
  const std::vector<std::uint32_t> segments{0, 8, 8, 1, 1, 2, 2, 9, 9, 3, 3,
                                            0, 4, 5, 5, 6, 6, 7, 7, 4, 8, 9};
  const std::vector<int> tags{1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 3};
  Pslg pslg = pslg_from_arrays(coordinates, segments, tags);
  pslg.holes = {{1.5, 1.5}};
  for (std::size_t i = 0; i < pslg.entities.curves.size(); ++i) {
    CurveEntity& curve = pslg.entities.curves[i];
    pslg.entities.groups.push_back({1, curve.tag, "curve " + std::to_string(curve.tag)});
    curve.groups = {GroupId(i)};
  }
  return pslg;
}

double area_of_triangles(const Mesh& mesh) {
  const std::span<const Point> points = mesh.points();
  double twice = 0;
  for (const Triangle& t : mesh.triangles()) {
    const auto [a, b, c] = t.vertices;
    twice += cross(points[b.index()] - points[a.index()], points[c.index()] - points[a.index()]);
  }
  return twice / 2;
}

double length(const Mesh& mesh, std::span<const HalfEdge> edges) {
  double sum = 0;
  for (const HalfEdge e : edges) {
    const Point along = mesh.point(mesh.destination(e)) - mesh.point(mesh.origin(e));
    sum += std::sqrt(dot(along, along));
  }
  return sum;
}

std::vector<bool> on_boundary(const Mesh& mesh) {
  std::vector<bool> marks(mesh.vertex_count(), false);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!mesh.is_boundary(e)) continue;
      marks[mesh.origin(e).index()] = marks[mesh.destination(e).index()] = true;
    }
  }
  return marks;
}

struct Entry {
  VertexId row, column;
  double value;
};

// sum over l of sigma_kl / h_kl (u_k - u_l), one row per vertex k
std::vector<Entry> two_point_flux_matrix(const VoronoiBoxes& boxes) {
  std::vector<Entry> matrix;
  for (const VoronoiFace& f : boxes.faces) {
    const double t = f.length / f.distance;
    matrix.insert(matrix.end(), {{f.k, f.k, t}, {f.k, f.l, -t}, {f.l, f.l, t}, {f.l, f.k, -t}});
  }
  return matrix;
}

// The scheme is exact for linear functions: at interior vertices no residual but rounding is left.
double largest_residual(const Mesh& mesh, const std::vector<Entry>& matrix) {
  const auto linear = [&](VertexId v) { return 2 + 3 * mesh.point(v).x - 4 * mesh.point(v).y; };
  std::vector<double> residual(mesh.vertex_count(), 0), magnitude(mesh.vertex_count(), 0);
  for (const auto& [row, column, value] : matrix) {
    residual[row.index()] += value * linear(column);
    magnitude[row.index()] += std::abs(value * linear(column));
  }
  const std::vector<bool> skip = on_boundary(mesh);
  double largest = 0;
  for (std::size_t v = 0; v < residual.size(); ++v) {
    if (!skip[v]) largest = std::max(largest, std::abs(residual[v]) / magnitude[v]);
  }
  return largest;
}

void mesh_and_assemble() {
  Mesh mesh = constrained_delaunay(plate()).mesh;
  const RefineReport refined = refine(mesh, {.min_angle_deg = 30, .max_edge = 0.25});
  expect(refined.goal_reached && refined.steiner_points > 100, "refinement reaches its goal");
  const Certificate certificate = certify(mesh);
  expect(certificate.admissible, certificate.summary().c_str());

  expect(std::abs(area_of_triangles(mesh) - 14) < 1e-11, "triangles cover the domain");
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  double area = 0;
  for (const double a : box_areas(mesh, boxes)) area += a;
  expect(std::abs(area - 14) < 1e-11, "boxes cover the domain");

  const GroupedEdges edges = edges_by_group(mesh);
  for (std::size_t g = 0; g < mesh.entities().groups.size(); ++g) {
    const std::vector<double> lengths{16, 4, 3};  // by tag, from 1
    const int tag = mesh.entities().groups[g].tag;
    expect(std::abs(length(mesh, edges.of(GroupId(g))) - lengths.at(tag - 1U)) < 1e-11,
           "the edges of a group are as long as its curves");
  }
  const double residual = largest_residual(mesh, two_point_flux_matrix(boxes));
  expect(residual < 1e-12, "the two-point flux is exact for a linear function");
  std::printf("%zu vertices, %zu faces, largest residual %.1e\n", mesh.vertex_count(),
              boxes.faces.size(), residual);
}

}  // namespace

int main() {
  try {
    expect(std::string(version) == std::to_string(LEPP_VERSION_MAJOR) + '.' +
                                       std::to_string(LEPP_VERSION_MINOR) + '.' +
                                       std::to_string(LEPP_VERSION_PATCH),
           "version.hpp agrees with itself");
    mesh_and_assemble();
  } catch (const Error& error) {
    expect(false, error.what());
  }
  return all_hold ? 0 : 1;
}

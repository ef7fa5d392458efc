#include "lepp/io/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "lepp/io/atomic_files.hpp"
#include "lepp/io/picture_frame.hpp"
#include "lepp/io/svg_drawing.hpp"

namespace lepp {

namespace {

// Light fills that stay apart in print and for most colour-blind readers; regions take turns.
constexpr std::array<std::string_view, 8> fills = {"#cfe3f2", "#fbe3c0", "#d5ecd0", "#f3d1d6",
                                                   "#e3d9ef", "#f7f2c4", "#cdebe9", "#e6dfd3"};
constexpr std::string_view edge_color = "#7d8b99", inside_color = "#b3541e",
                           boundary_color = "#1d2b3a", box_color = "#2a7f62";
constexpr double margin = 10;

// The triangles of each region; one path each.
void draw_triangles(SvgDrawing& drawing, const Mesh& mesh, double stroke) {
  std::vector<std::vector<TriangleId>> of_region;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const std::size_t region = mesh.region(TriangleId(i)).index();
    if (region >= of_region.size()) of_region.resize(region + 1);
    of_region[region].emplace_back(i);
  }
  for (std::size_t region = 0; region < of_region.size(); ++region) {
    if (of_region[region].empty()) continue;
    drawing.open_path(fills[region % fills.size()], edge_color, stroke);
    for (const TriangleId t : of_region[region]) {
      const auto [a, b, c] = mesh.corners(t);
      drawing.move(a);
      drawing.line(b);
      drawing.line(c);
      drawing.close_ring();
    }
    drawing.close_path();
  }
}

// True if pq runs along a side of the triangle, as far as rounding lets one tell.
bool runs_along_a_side(const std::array<Point, 3>& triangle, Point p, Point q) {
  constexpr double tolerance = 1e-9;  // of the side's length
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = triangle[i], side = triangle[(i + 1) % 3] - a;
    const double allowed = tolerance * dot(side, side);
    if (std::abs(cross(side, p - a)) <= allowed && std::abs(cross(side, q - a)) <= allowed) {
      return true;
    }
  }
  return false;
}

// The faces between boxes: sides of pieces that do not run along a side of their triangle. Where
// they do, the same box goes on beyond (in a Delaunay triangulation), or the edge is constrained
// and drawn already. Two boxes see a face in opposite directions; a slanted direction, which no
// face of a regular mesh is normal to, tells which of them draws it.
void draw_boxes(SvgDrawing& drawing, const Mesh& mesh, const VoronoiBoxes& boxes, double stroke) {
  constexpr Point slanted{0.618, 0.786};
  drawing.open_path("none", box_color, stroke);
  for (std::uint32_t i = 0; i < boxes.piece_triangle.size(); ++i) {
    const auto corners = boxes.piece(i);
    const auto triangle = mesh.corners(boxes.piece_triangle[i]);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point p = corners[k], q = corners[(k + 1) % corners.size()];
      if (dot(q - p, slanted) < 0 || runs_along_a_side(triangle, p, q)) continue;
      drawing.move(p);
      drawing.line(q);
    }
  }
  drawing.close_path();
}

}  // namespace

void write_picture(const Mesh& mesh, const std::filesystem::path& path,
                   const PictureOptions& options) {
  const PictureFrame frame(mesh.points(), options.width, margin);
  const double stroke = options.width / 1000;  // thinner lines in a smaller drawing
  AtomicFiles files;
  SvgDrawing drawing(files.add(path), frame);
  draw_triangles(drawing, mesh, 0.6 * stroke);
  if (options.boxes != nullptr) draw_boxes(drawing, mesh, *options.boxes, 0.9 * stroke);
  drawing.edges(mesh, inside_color, 1.8 * stroke,
                [&](HalfEdge e) { return mesh.is_constrained(e) && !mesh.is_boundary(e); });
  drawing.edges(mesh, boundary_color, 2.6 * stroke,
                [&](HalfEdge e) { return mesh.is_boundary(e); });
  drawing.end();
  files.commit();
}

}  // namespace lepp

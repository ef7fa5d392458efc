#include "lepp/io/hillshade.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lepp/io/atomic_files.hpp"
#include "lepp/io/file_kind.hpp"
#include "lepp/io/picture_frame.hpp"
#include "lepp/io/png.hpp"
#include "lepp/io/svg_drawing.hpp"
#include "lepp/triangulation/for_each_edge.hpp"

namespace lepp {

namespace {

// Tints of heights, lowest to highest.
constexpr std::array<std::array<double, 3>, 6> tints = {{{122, 166, 116},
                                                         {170, 199, 140},
                                                         {228, 217, 164},
                                                         {208, 171, 126},
                                                         {186, 148, 128},
                                                         {245, 243, 240}}};
constexpr double usual_slope = 0.4;    // flatter land is stretched to it
constexpr double seen_edge_area = 40;  // of a triangle, in pixels

std::array<double, 3> tint(double part) {
  const double at = std::clamp(part, 0.0, 1.0) * (tints.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), tints.size() - 2);
  const double t = at - static_cast<double>(i);
  std::array<double, 3> mixed{};
  for (std::size_t k = 0; k < 3; ++k) mixed[k] = (1 - t) * tints[i][k] + t * tints[i + 1][k];
  return mixed;
}

bool draws_edges(const Tin& tin, const PictureFrame& frame, const HillshadeOptions& options) {
  if (options.edges) return *options.edges;
  const double area = frame.width() * frame.height();
  return area > seen_edge_area * static_cast<double>(tin.mesh.triangle_count());
}

// ---- SVG ---------------------------------------------------------------------------------------

std::string hexadecimal(const Color& color) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : color) {
    text += digits[part / 16];
    text += digits[part % 16];
  }
  return text;
}

void write_svg(const Tin& tin, const std::filesystem::path& path, const Hillshade& shade,
               const HillshadeOptions& options) {
  const Mesh& mesh = tin.mesh;
  const PictureFrame frame(mesh.points(), options.width, 10);
  const double stroke = options.width / 1000;
  AtomicFiles files;
  SvgDrawing drawing(files.add(path), frame);
  drawing.open_polygons(0.6);
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    drawing.polygon(mesh.corners(TriangleId(i)), hexadecimal(shade(TriangleId(i))));
  }
  drawing.close_polygons();
  if (draws_edges(tin, frame, options)) {
    drawing.edges(mesh, "#33404d", 0.35 * stroke, [](HalfEdge) { return true; });
  }
  drawing.edges(mesh, "#1b4f9c", 1.6 * stroke,
                [&](HalfEdge e) { return mesh.is_constrained(e) && !mesh.is_boundary(e); });
  drawing.edges(mesh, "#1d2b3a", 1.2 * stroke, [&](HalfEdge e) { return mesh.is_boundary(e); });
  drawing.end();
  files.commit();
}

// ---- PNG ---------------------------------------------------------------------------------------

constexpr std::size_t finer = 2;  // a pixel is the mean of finer * finer

class Raster {
 public:
  Raster(std::size_t width, std::size_t height)
      : width_(width), height_(height), colors_(3 * width * height, 255) {}

  void fill(std::array<Point, 3> p, const Color& color) {
    std::ranges::sort(p, {}, &Point::y);
    const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(p[0].y - 0.5)));
    for (std::size_t row = first; row < height_; ++row) {
      const double y = static_cast<double>(row) + 0.5;
      if (y > p[2].y) break;
      const double u = crossing(p[0], p[2], y);
      const double v = y < p[1].y ? crossing(p[0], p[1], y) : crossing(p[1], p[2], y);
      fill_row(row, std::min(u, v), std::max(u, v), color);
    }
  }

  void darken(Point a, Point b, double part) {
    const auto steps = static_cast<std::size_t>(
        std::ceil(std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), 1.0})));
    for (std::size_t i = 0; i < steps; ++i) {
      const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(steps);
      const Point p = a + t * (b - a);
      if (!(p.x >= 0 && p.y >= 0)) continue;
      const auto x = static_cast<std::size_t>(p.x), y = static_cast<std::size_t>(p.y);
      if (x >= width_ || y >= height_) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint8_t& c = colors_[3 * (y * width_ + x) + k];
        c = static_cast<std::uint8_t>(part * c);
      }
    }
  }

  // The mean of each finer * finer squares.
  std::vector<std::uint8_t> reduced() const {
    std::vector<std::uint8_t> result;
    result.reserve(colors_.size() / (finer * finer));
    for (std::size_t y = 0; y < height_; y += finer) {
      for (std::size_t x = 0; x < width_; x += finer) {
        for (std::size_t k = 0; k < 3; ++k) result.push_back(mean(x, y, k));
      }
    }
    return result;
  }

 private:
  static double crossing(Point a, Point b, double y) {
    return a.y < b.y ? a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)) : a.x;
  }

  void fill_row(std::size_t row, double left, double right, const Color& color) {
    const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(left - 0.5)));
    for (std::size_t x = first; x < width_ && static_cast<double>(x) + 0.5 <= right; ++x) {
      std::ranges::copy(color,
                        colors_.begin() + static_cast<std::ptrdiff_t>(3 * (row * width_ + x)));
    }
  }

  std::uint8_t mean(std::size_t x, std::size_t y, std::size_t k) const {
    std::size_t sum = 0;
    for (std::size_t j = 0; j < finer; ++j) {
      for (std::size_t i = 0; i < finer; ++i) sum += colors_[3 * ((y + j) * width_ + x + i) + k];
    }
    return static_cast<std::uint8_t>((sum + finer * finer / 2) / (finer * finer));
  }

  std::size_t width_, height_;
  std::vector<std::uint8_t> colors_;
};

void draw_png(const Tin& tin, const std::filesystem::path& path, const Hillshade& shade,
              const HillshadeOptions& options) {
  const PictureFrame frame(tin.mesh.points(), options.width, 0);
  const auto pixels = [](double length) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length - 1e-6)));
  };
  const std::size_t width = pixels(frame.width()), height = pixels(frame.height());
  Raster raster(finer * width, finer * height);
  const auto place = [&](Point p) { return double(finer) * frame.place(p); };
  const Mesh& mesh = tin.mesh;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const auto [a, b, c] = mesh.corners(TriangleId(i));
    raster.fill({place(a), place(b), place(c)}, shade(TriangleId(i)));
  }
  const bool with_edges = draws_edges(tin, frame, options);
  for_each_edge(mesh, [&](HalfEdge e) {
    if (!with_edges && !mesh.is_constrained(e)) return;
    raster.darken(place(mesh.point(mesh.origin(e))), place(mesh.point(mesh.destination(e))),
                  mesh.is_constrained(e) ? 0.3 : 0.65);
  });
  write_png(path, width, height, raster.reduced());
}

}  // namespace

Hillshade::Hillshade(const Tin& tin, double cell_width,
                     const std::optional<std::array<double, 2>>& heights)
    : tin_(tin), cell_width_(cell_width) {
  if (tin.heights.empty()) return;
  const auto [low, high] = std::ranges::minmax(tin.heights);
  low_ = heights ? heights->front() : low;
  high_ = heights ? heights->back() : high;
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < tin.mesh.triangle_count(); ++i) {
    const auto [a, b, c] = tin.mesh.corners(TriangleId(i));
    const auto [gx, gy] = gradient(TriangleId(i));
    const double weight = cross(b - a, c - a);
    sum += weight * (gx * gx + gy * gy);
    area += weight;
  }
  const double slope = area > 0 ? std::sqrt(sum / area) : 0;
  if (slope > 0 && slope < usual_slope) exaggeration_ = usual_slope / slope;
}

// Of the plane through a triangle: a rise per length, to the east and to the north.
std::array<double, 2> Hillshade::gradient(TriangleId t) const {
  const auto [a, b, c] = tin_.mesh.corners(t);
  const auto& [u, v, w] = tin_.mesh.vertices(t);
  const double h = tin_.heights[u.index()];
  const double rise_b = tin_.heights[v.index()] - h, rise_c = tin_.heights[w.index()] - h;
  const Point ab = b - a, ac = c - a;
  const double area = cross(ab, ac) * cell_width_;
  if (!(area > 0)) return {0, 0};
  return {(rise_b * ac.y - rise_c * ab.y) / area, (rise_c * ab.x - rise_b * ac.x) / area};
}

Color Hillshade::operator()(TriangleId t) const {
  const auto [gx, gy] = gradient(t);
  const double x = -exaggeration_ * gx, y = -exaggeration_ * gy;
  const double cosine = (-0.5 * x + 0.5 * y + std::sqrt(0.5)) / std::sqrt(x * x + y * y + 1);
  const double light = 0.25 + 0.8 * std::max(0.0, cosine);
  double height = 0;
  for (const VertexId v : tin_.mesh.vertices(t)) height += tin_.heights[v.index()] / 3;
  const auto mixed = tint(high_ > low_ ? (height - low_) / (high_ - low_) : 0.5);
  Color color{};
  for (std::size_t k = 0; k < 3; ++k) {
    color[k] = static_cast<std::uint8_t>(std::clamp(light * mixed[k] + 0.5, 0.0, 255.0));
  }
  return color;
}

void write_hillshade(const Tin& tin, const std::filesystem::path& path,
                     const HillshadeOptions& options) {
  const Hillshade shade(tin, options.cell_width, options.heights);
  if (file_kind(path) == ".png") draw_png(tin, path, shade, options);
  else write_svg(tin, path, shade, options);
}

}  // namespace lepp

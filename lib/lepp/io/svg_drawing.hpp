#pragma once

#include <span>
#include <string_view>

#include "lepp/io/atomic_files.hpp"
#include "lepp/io/picture_frame.hpp"
#include "lepp/triangulation/for_each_edge.hpp"

namespace lepp {

/// An SVG file made of paths, on white. Points are those of the mesh; the frame places them.
class SvgDrawing {
 public:
  /// Writes the head. Both must live as long as the drawing.
  SvgDrawing(OutputFile& out, const PictureFrame& frame);

  /// A path begins, is moved along, and ends. Colours as SVG has them, "none" for no filling.
  void open_path(std::string_view fill, std::string_view stroke, double stroke_width);
  void move(Point p) { place('M', p); }
  void line(Point p) { place('L', p); }
  void close_ring() { out_ << "Z\n"; }
  void close_path() { out_ << "\"/>\n"; }

  /// Polygons of one colour each, drawn with a thin line of it, which closes the hair between
  /// neighbours.
  void open_polygons(double stroke_width);
  void polygon(std::span<const Point> corners, std::string_view color);
  void close_polygons() { out_ << "</g>\n"; }

  /// The edges that `is_drawn` says, as one path; each edge once where it says so of either side.
  void edges(const Mesh& mesh, std::string_view color, double stroke_width, auto is_drawn) {
    open_path("none", color, stroke_width);
    for_each_edge(mesh, [&](HalfEdge e) {
      if (!is_drawn(e)) return;
      move(mesh.point(mesh.origin(e)));
      line(mesh.point(mesh.destination(e)));
    });
    close_path();
  }

  void end() { out_ << "</svg>\n"; }

 private:
  void place(char command, Point p);

  OutputFile& out_;
  const PictureFrame& frame_;
};

}  // namespace lepp

#include "lepp/io/svg_drawing.hpp"

namespace lepp {

SvgDrawing::SvgDrawing(OutputFile& out, const PictureFrame& frame) : out_(out), frame_(frame) {
  out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
  out_.fixed(frame.width(), 1) << "\" height=\"";
  out_.fixed(frame.height(), 1) << "\" viewBox=\"0 0 ";
  out_.fixed(frame.width(), 1) << ' ';
  out_.fixed(frame.height(), 1) << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

void SvgDrawing::open_path(std::string_view fill, std::string_view stroke, double stroke_width) {
  out_ << "<path fill=\"" << fill << "\" stroke=\"" << stroke << "\" stroke-width=\"";
  out_.fixed(stroke_width, 2) << "\" stroke-linejoin=\"round\" stroke-linecap=\"round\" d=\"";
}

void SvgDrawing::open_polygons(double stroke_width) {
  out_ << "<g stroke-width=\"";
  out_.fixed(stroke_width, 1) << "\" stroke-linejoin=\"round\">\n";
}

void SvgDrawing::polygon(std::span<const Point> corners, std::string_view color) {
  out_ << "<path fill=\"" << color << "\" stroke=\"" << color << "\" d=\"";
  for (std::size_t k = 0; k < corners.size(); ++k) place(k == 0 ? 'M' : 'L', corners[k]);
  out_ << "Z\"/>\n";
}

void SvgDrawing::place(char command, Point p) {
  const Point at = frame_.place(p);
  out_ << command;
  out_.fixed(at.x, 2) << ' ';
  out_.fixed(at.y, 2);
}

}  // namespace lepp

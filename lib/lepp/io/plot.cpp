#include "lepp/io/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/point.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/xml_text.hpp"

namespace lepp {

namespace {

constexpr std::array<std::string_view, 6> colors = {"#1b6ca8", "#c8553d", "#3a7d44",
                                                    "#7b5ea7", "#b8860b", "#4a4a4a"};
constexpr double width = 720, height = 520;
constexpr double left = 80, right = 530, top = 50, bottom = 460;  // of the axes' box

// A range of powers of ten.
struct Decades {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;

  void add(double log10) {
    low = std::min(low, log10);
    high = std::max(high, log10);
  }
  // A tenth of room at both ends, and never a range of nothing.
  void widen() {
    const double room = std::max(0.1 * (high - low), 0.15);
    low -= room;
    high += room;
  }
  double part(double log10) const { return (log10 - low) / (high - low); }
};

bool is_drawn(double x, double y) { return x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y); }

// The points of a series that a logarithm exists for, as logarithms.
std::vector<Point> log_points(const PlotSeries& series) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (!is_drawn(series.x[i], series.y[i])) continue;
    points.push_back({std::log10(series.x[i]), std::log10(series.y[i])});
  }
  return points;
}

class Chart {
 public:
  Chart(OutputFile& out, Decades x, Decades y) : out_(out), x_(x), y_(y) {
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\""
         << height << "\" viewBox=\"0 0 " << width << ' ' << height
         << "\" font-family=\"sans-serif\" font-size=\"13\">\n"
         << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  }

  Point place(Point log) const {
    return {left + (right - left) * x_.part(log.x), bottom - (bottom - top) * y_.part(log.y)};
  }

  void line(Point a, Point b, std::string_view style) {
    out_ << "<line x1=\"";
    out_.fixed(a.x, 1) << "\" y1=\"";
    out_.fixed(a.y, 1) << "\" x2=\"";
    out_.fixed(b.x, 1) << "\" y2=\"";
    out_.fixed(b.y, 1) << "\" " << style << "/>\n";
  }

  void text(Point at, std::string_view style, std::string_view text) {
    out_ << "<text x=\"";
    out_.fixed(at.x, 1) << "\" y=\"";
    out_.fixed(at.y, 1) << "\" " << style << '>' << xml_text(text) << "</text>\n";
  }

  void dot(Point at, std::string_view color) {
    out_ << "<circle cx=\"";
    out_.fixed(at.x, 1) << "\" cy=\"";
    out_.fixed(at.y, 1) << "\" r=\"3.5\" fill=\"" << color << "\"/>\n";
  }

  void axes(const LogLogPlot& plot);
  void series(const std::vector<Point>& points, std::size_t number, std::string_view label);
  void slope(const ReferenceSlope& reference, Point through, Decades across);
  void end() { out_ << "</svg>\n"; }

 private:
  void ticks_x();
  void ticks_y();
  Point next_legend_place() { return {right + 20, top + 10 + 22 * legend_lines_++}; }

  OutputFile& out_;
  Decades x_, y_;
  int legend_lines_ = 0;
};

constexpr std::string_view axis_style = "stroke=\"#333333\" stroke-width=\"1\"";
constexpr std::string_view grid_style = "stroke=\"#dddddd\" stroke-width=\"1\"";

std::string tick_label(int digit, int exponent) {
  if (exponent < 0 || exponent > 4) return std::to_string(digit) + "e" + std::to_string(exponent);
  return std::to_string(digit) + std::string(static_cast<std::size_t>(exponent), '0');
}

// The multiples of each power of ten that a range of so many decades has room for.
std::span<const int> tick_digits(double decades) {
  static constexpr std::array<int, 9> all = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  static constexpr std::array<int, 3> some = {1, 2, 5};
  if (decades < 1) return all;
  return decades > 3 ? std::span(some).first(1) : std::span(some);
}

// Calls tick(log10, label) for each tick in the range.
void for_each_tick(Decades range, auto tick) {
  for (int e = static_cast<int>(std::floor(range.low)); e <= range.high; ++e) {
    for (const int digit : tick_digits(range.high - range.low)) {
      const double log = e + std::log10(digit);
      if (log < range.low || log > range.high) continue;
      tick(log, tick_label(digit, e));
    }
  }
}

void Chart::ticks_x() {
  for_each_tick(x_, [&](double log, const std::string& label) {
    const double x = place({log, 0}).x;
    line({x, top}, {x, bottom}, grid_style);
    text({x, bottom + 18}, "text-anchor=\"middle\"", label);
  });
}

void Chart::ticks_y() {
  for_each_tick(y_, [&](double log, const std::string& label) {
    const double y = place({0, log}).y;
    line({left, y}, {right, y}, grid_style);
    text({left - 8, y + 4}, "text-anchor=\"end\"", label);
  });
}

void Chart::axes(const LogLogPlot& plot) {
  ticks_x();
  ticks_y();
  line({left, bottom}, {right, bottom}, axis_style);
  line({left, top}, {left, bottom}, axis_style);
  text({(left + right) / 2, top - 20}, "text-anchor=\"middle\" font-size=\"16\"", plot.title);
  text({(left + right) / 2, bottom + 42}, "text-anchor=\"middle\"", plot.x_label);
  // Beside the axis and turned about the origin: above it, it would run into a long title.
  text({-(top + bottom) / 2, left - 62}, "text-anchor=\"middle\" transform=\"rotate(-90)\"",
       plot.y_label);
}

void Chart::series(const std::vector<Point>& points, std::size_t number, std::string_view label) {
  const std::string_view color = colors[number % colors.size()];
  const std::string style = "stroke=\"" + std::string(color) + "\" stroke-width=\"2\"";
  for (std::size_t i = 1; i < points.size(); ++i) {
    line(place(points[i - 1]), place(points[i]), style);
  }
  for (const Point p : points) dot(place(p), color);
  const Point at = next_legend_place();
  dot({at.x, at.y - 4}, color);
  text({at.x + 12, at.y}, "", label);
}

// Through a point, from the left end of the data to the right one.
void Chart::slope(const ReferenceSlope& reference, Point through, Decades across) {
  constexpr std::string_view style =
      "stroke=\"#888888\" stroke-width=\"1.5\" stroke-dasharray=\"6 4\"";
  const auto at = [&](double x) { return Point{x, through.y + reference.slope * (x - through.x)}; };
  line(place(at(across.low)), place(at(across.high)), style);
  const Point legend = next_legend_place();
  line({legend.x - 6, legend.y - 4}, {legend.x + 8, legend.y - 4}, style);
  text({legend.x + 12, legend.y}, "", reference.label);
}

// Where a reference line goes through: a little below the series that rises most like it.
Point place_of(const ReferenceSlope& reference, const std::vector<std::vector<Point>>& series) {
  Point best;
  double best_difference = std::numeric_limits<double>::infinity();
  for (const std::vector<Point>& points : series) {
    const auto [low, high] = std::ranges::minmax(points, {}, &Point::x);
    const double rise = high.x > low.x ? (high.y - low.y) / (high.x - low.x) : 0;
    if (std::abs(rise - reference.slope) >= best_difference) continue;
    best_difference = std::abs(rise - reference.slope);
    best = {low.x, low.y - 0.2};
  }
  return best;
}

}  // namespace

void write_plot(const LogLogPlot& plot, const std::filesystem::path& path) {
  std::vector<std::vector<Point>> series;
  Decades x, y;
  for (const PlotSeries& s : plot.series) {
    auto points = log_points(s);
    for (const Point p : points) {
      x.add(p.x);
      y.add(p.y);
    }
    if (!points.empty()) series.push_back(std::move(points));
  }
  if (series.empty()) {
    throw InputError(path.string(), "no point with positive coordinates to draw",
                     "give values above 0: the axes are logarithmic");
  }
  const Decades data = x;
  for (const ReferenceSlope& reference : plot.slopes) {
    const Point through = place_of(reference, series);
    y.add(through.y + reference.slope * (data.low - through.x));
    y.add(through.y + reference.slope * (data.high - through.x));
  }
  x.widen();
  y.widen();
  AtomicFiles files;
  Chart chart(files.add(path), x, y);
  chart.axes(plot);
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    chart.series(log_points(plot.series[i]), i, plot.series[i].label);
  }
  for (const ReferenceSlope& r : plot.slopes) chart.slope(r, place_of(r, series), data);
  chart.end();
  files.commit();
}

}  // namespace lepp

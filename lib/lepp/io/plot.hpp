#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lepp {

struct PlotSeries {
  std::string label;
  std::vector<double> x, y;  ///< as many of each; points with x or y not above 0 are left out
};

/// A dashed line y = C x^slope with a label, placed a little below the series that rises most like
/// it.
struct ReferenceSlope {
  double slope = 1;
  std::string label;
};

/// A diagram with logarithmic axes, as for errors against mesh sizes.
struct LogLogPlot {
  std::string title, x_label, y_label;
  std::vector<PlotSeries> series;
  std::vector<ReferenceSlope> slopes;
};

/// Draws the plot as SVG.
/// \throw OutputError; InputError when no point is left to draw
void write_plot(const LogLogPlot& plot, const std::filesystem::path& path);

}  // namespace lepp

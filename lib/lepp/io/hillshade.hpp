#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "lepp/terrain/tin.hpp"

namespace lepp {

struct HillshadeOptions {
  double width = 1000;    ///< longest side of the picture, in SVG units or pixels, 1 to 20000
  double cell_width = 1;  ///< unit of x and y in units of height: HeightGrid::cell_width
  /// The lowest and the highest tint; else the heights of the TIN. Pictures of parts match by it.
  std::optional<std::array<double, 2>> heights = {};
  std::optional<bool> edges = {};  ///< drawn; else if triangles are large enough to see them
};

using Color = std::array<std::uint8_t, 3>;

/// The colours of triangles: a tint by height, from green over brown to white, times the light from
/// the north-west, 45 degrees high. Flat land is stretched in height until slopes show.
class Hillshade {
 public:
  /// \param heights  as in HillshadeOptions
  Hillshade(const Tin& tin, double cell_width,
            const std::optional<std::array<double, 2>>& heights = {});
  Color operator()(TriangleId t) const;
  double exaggeration() const { return exaggeration_; }

 private:
  std::array<double, 2> gradient(TriangleId t) const;

  const Tin& tin_;
  double cell_width_, exaggeration_ = 1, low_ = 0, high_ = 0;
};

/// Draws a TIN in grid space (x to the east, y to the north) as a hill-shaded picture: .svg with a
/// polygon per triangle, or .png.
/// \throw OutputError
void write_hillshade(const Tin& tin, const std::filesystem::path& path,
                     const HillshadeOptions& options = {});

}  // namespace lepp

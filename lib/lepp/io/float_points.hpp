#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "lepp/io/tin_files.hpp"

namespace lepp {

using FloatPoint = std::array<float, 3>;

/// The vertices less `offset`, as files of 32-bit coordinates hold them.
/// \throw InputError  naming `path`, where a triangle loses its area
std::vector<FloatPoint> float_points(const WorldTin& tin, Point offset,
                                     const std::filesystem::path& path);

}  // namespace lepp

#pragma once

#include <filesystem>

#include "lepp/geometry/pslg.hpp"

namespace lepp::test {

/// A PSLG from a file in one of the formats that other projects keep their inputs in:
/// - .poly and .node, as read_poly() reads them;
/// - .json with points_x, points_y, region_boundary and additional_constraints;
/// - .json of points and edges, as an object or as a list of two lists, or of points alone;
/// - .json of rings, one polygon; GeoJSON of polygons and lines;
/// - .dat: a ring of points, one per line; a single word starts the next ring;
/// - .json with subjPaths and clipPaths, lists of rings;
/// - .txt: "vertices edges", then points, then pairs of points, each from 0;
/// - .txt that starts with CAPTION: rings and, below SUBJECTS_OPEN, lines, as "x,y, x,y";
/// - .xml with well-known text: rings and lines, all in one.
/// Rings are closed, the points of each are its own, and there are no holes in Pslg::holes: what is
/// inside is the caller's question.
/// \throw InputError, or nlohmann::json::exception, if the file is none of these
Pslg read_foreign_pslg(const std::filesystem::path& path);

}  // namespace lepp::test

#include "read_lines.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <utility>
#include <vector>

#include "gdal_failure.hpp"

namespace lepp::gdal_helper {
namespace {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
struct DestroyGeometry {
  void operator()(OGRGeometry* geometry) const { OGRGeometryFactory::destroyGeometry(geometry); }
};

void add_line(const OGRLineString& line, GdalPart& part) {
  auto& points = part.rings.emplace_back();
  for (int i = 0; i < line.getNumPoints(); ++i) points.push_back({line.getX(i), line.getY(i)});
  if (line.Is3D() == 0) return;
  auto& heights = part.heights.emplace_back();
  for (int i = 0; i < line.getNumPoints(); ++i) heights.push_back(line.getZ(i));
}

void add_parts(const OGRGeometry& whole, std::vector<GdalPart>& parts) {
  std::vector<const OGRGeometry*> waiting = {&whole};
  while (!waiting.empty()) {
    const OGRGeometry& geometry = *waiting.back();
    waiting.pop_back();
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
      const OGRGeometryCollection& all = *geometry.toGeometryCollection();
      for (int i = all.getNumGeometries(); i-- > 0;) waiting.push_back(all.getGeometryRef(i));
      continue;
    }
    GdalPart& part = parts.emplace_back();
    if (type == wkbLineString || type == wkbLinearRing) {
      part.kind = "LineString";
      add_line(*geometry.toLineString(), part);
    } else if (type == wkbPolygon || type == wkbTriangle) {
      part.kind = "Polygon";
      for (const OGRLinearRing* ring : *geometry.toPolygon()) add_line(*ring, part);
    } else {
      part.kind = OGRGeometryTypeToName(geometry.getGeometryType());
    }
  }
}

void add_layer(OGRLayer& layer, const std::string& before, GdalLines& lines) {
  layer.ResetReading();
  CPLErrorReset();
  for (auto& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    GdalFeature& added = lines.features.emplace_back();
    added.name = before + "feature " + std::to_string(feature->GetFID());
    if (geometry == nullptr || geometry->IsEmpty()) continue;
    // Arcs become chains within GDAL's own tolerance.
    const std::unique_ptr<OGRGeometry, DestroyGeometry> straight(geometry->getLinearGeometry());
    if (straight) add_parts(*straight, added.parts);
  }
  if (CPLGetLastErrorType() == CE_Failure)
    throw GdalFailure{ErrorKind::input, "", said("its features cannot be read"),
                      "the file is damaged: get it again"};
}

void compare(const OGRSpatialReference& crs, const std::string& grid_wkt, GdalLines& lines) {
  lines.crs = wkt_of(crs);
  lines.crs_name = crs.GetName() == nullptr ? "" : crs.GetName();
  OGRSpatialReference grid;
  if (grid_wkt.empty() || grid.importFromWkt(grid_wkt.c_str()) != OGRERR_NONE) return;
  grid.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference own(crs);
  own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  lines.grid_crs_name = grid.GetName() == nullptr ? "" : grid.GetName();
  const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                 "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS", nullptr};
  if (own.IsSame(&grid, options) != 0) return;
  // Files of one system may spell it in two ways (.prj of ESRI): compare what they are known as.
  own.AutoIdentifyEPSG();
  grid.AutoIdentifyEPSG();
  const char *a = own.GetAuthorityCode(nullptr), *b = grid.GetAuthorityCode(nullptr);
  lines.other_crs = a == nullptr || b == nullptr || std::string(a) != b;
}

}  // namespace

GdalLines read_lines(const std::string& file, const std::string& grid_wkt) {
  GdalLines lines;
  CPLErrorReset();
  const std::unique_ptr<GDALDataset, CloseDataset> dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (!dataset)
    throw GdalFailure{ErrorKind::input, "", said("is no vector file that GDAL reads"),
                      "give lines or polygons; ogrinfo shows what GDAL makes of it"};
  const int layers = dataset->GetLayerCount();
  for (int i = 0; i < layers; ++i) {
    OGRLayer& layer = *dataset->GetLayer(i);
    if (const auto* crs = layer.GetSpatialRef(); crs != nullptr && lines.crs.empty())
      compare(*crs, grid_wkt, lines);
    add_layer(layer, layers == 1 ? "" : "layer " + std::string(layer.GetName()) + ", ", lines);
  }
  return lines;
}

}  // namespace lepp::gdal_helper

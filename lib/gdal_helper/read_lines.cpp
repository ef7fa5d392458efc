#include "read_lines.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>
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

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

void convert(OGRCoordinateTransformation& transformation, GdalFeature& feature) {
  for (GdalPart& part : feature.parts) {
    for (auto& ring : part.rings) {
      for (Point& p : ring) {
        if (transformation.Transform(1, &p.x, &p.y) != 0) continue;
        throw GdalFailure{ErrorKind::input, feature.name,
                          said("cannot be converted to the coordinate system of the grid"),
                          "convert the file with ogr2ogr -t_srs"};
      }
    }
  }
}

void add_layer(OGRLayer& layer, const std::string& before,
               OGRCoordinateTransformation* transformation, GdalLines& lines) {
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
    if (transformation != nullptr) convert(*transformation, added);
  }
  if (CPLGetLastErrorType() == CE_Failure)
    throw GdalFailure{ErrorKind::input, "", said("its features cannot be read"),
                      remedy_for_reading()};
}

bool are_same(const OGRSpatialReference& a, const OGRSpatialReference& b) {
  const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                 "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS", nullptr};
  if (a.IsSame(&b, options) != 0) return true;
  // One system may be spelt in two ways (.prj of ESRI): compare what they are known as.
  OGRSpatialReference p(a), q(b);
  p.AutoIdentifyEPSG();
  q.AutoIdentifyEPSG();
  const char *of_p = p.GetAuthorityCode(nullptr), *of_q = q.GetAuthorityCode(nullptr);
  return of_p != nullptr && of_q != nullptr && std::string(of_p) == of_q;
}

std::string name_of(const OGRSpatialReference& crs) {
  return crs.GetName() == nullptr ? "one without a name" : crs.GetName();
}

// From the layer's coordinate system to the grid's; nothing if they are the same or not known.
Transformation to_grid(OGRLayer& layer, const std::string& grid_wkt, GdalLines& lines) {
  const OGRSpatialReference* const of_layer = layer.GetSpatialRef();
  OGRSpatialReference grid;
  if (of_layer == nullptr || grid_wkt.empty()) return nullptr;
  CPLErrorReset();
  if (grid.importFromWkt(grid_wkt.c_str()) != OGRERR_NONE) {
    throw GdalFailure{ErrorKind::input, "",
                      said("its coordinate system is " + name_of(*of_layer) +
                           ", and the coordinate system of the grid is no WKT that GDAL reads"),
                      "correct the grid's .prj file, or remove it if their coordinates agree"};
  }
  OGRSpatialReference own(*of_layer);
  own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);  // x first, as files have it
  grid.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (are_same(own, grid)) return nullptr;
  CPLErrorReset();
  Transformation transformation(OGRCreateCoordinateTransformation(&own, &grid));
  if (!transformation)
    throw GdalFailure{ErrorKind::input, "",
                      said("its coordinate system is " + name_of(own) + ", that of the grid " +
                           name_of(grid) + ", and it cannot be converted"),
                      "convert it with ogr2ogr -t_srs"};
  lines.converted_from.push_back(name_of(own));
  lines.converted_to = name_of(grid);
  return transformation;
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
    const Transformation transformation = to_grid(layer, grid_wkt, lines);
    add_layer(layer, layers == 1 ? "" : "layer " + std::string(layer.GetName()) + ", ",
              transformation.get(), lines);
  }
  return lines;
}

}  // namespace lepp::gdal_helper

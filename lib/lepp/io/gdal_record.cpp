#include "lepp/io/gdal_record.hpp"

namespace lepp {

void fields(auto& archive, Is<Point> auto& p) { archive(p.x, p.y); }
void fields(auto& archive, Is<GdalFailure> auto& f) {
  archive(f.kind, f.where, f.problem, f.remedy);
}
void fields(auto& archive, Is<GdalRaster> auto& r) {
  archive(r.failure, r.columns, r.rows, r.georeferenced, r.degrees, r.origin, r.step_x, r.step_y,
          r.crs, r.doubles, r.warnings, r.files);
}
void fields(auto& archive, Is<GdalRasterEnd> auto& e) { archive(e.failure); }
void fields(auto& archive, Is<GdalPart> auto& p) { archive(p.kind, p.rings, p.heights); }
void fields(auto& archive, Is<GdalFeature> auto& f) { archive(f.name, f.parts); }
void fields(auto& archive, Is<GdalLines> auto& l) {
  archive(l.failure, l.converted_from, l.converted_to, l.features);
}

namespace {

template <class Record>
std::vector<std::byte> encode_as(const RecordKind& kind, const Record& record) {
  RecordWriter payload;
  payload(record);
  return framed(kind, payload.take());
}

template <class Record>
bool decode_as(const RecordKind& kind, std::span<const std::byte> bytes, Record& record) {
  const auto payload = payload_of(kind, bytes);
  if (!payload) return false;
  RecordReader reader(*payload);
  reader(record);
  return reader.complete();
}

}  // namespace

std::vector<std::byte> encode(const GdalRaster& record) {
  return encode_as(gdal_raster_kind, record);
}
std::vector<std::byte> encode(const GdalRasterEnd& record) {
  return encode_as(gdal_end_kind, record);
}
std::vector<std::byte> encode(const GdalLines& record) {
  return encode_as(gdal_lines_kind, record);
}

bool decode(std::span<const std::byte> bytes, GdalRaster& record) {
  return decode_as(gdal_raster_kind, bytes, record);
}
bool decode(std::span<const std::byte> bytes, GdalRasterEnd& record) {
  return decode_as(gdal_end_kind, bytes, record);
}
bool decode(std::span<const std::byte> bytes, GdalLines& record) {
  return decode_as(gdal_lines_kind, bytes, record);
}

}  // namespace lepp

#pragma once

#include <cpl_conv.h>
#include <cpl_error.h>
#include <ogr_spatialref.h>

#include <cstdint>
#include <string>

#include "lepp/io/gdal_record.hpp"

namespace lepp::gdal_helper {

/// A sentence, and what GDAL said last, if anything, on one line.
inline std::string said(std::string sentence) {
  std::string last = CPLGetLastErrorMsg();
  for (char& c : last) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return last.empty() ? sentence : sentence + " (" + last + ")";
}

/// What to do about a file that opens and then cannot be read, as GDAL said last. A mosaic opens
/// without its parts.
inline std::string remedy_for_reading() {
  if (CPLGetLastErrorNo() == CPLE_OpenFailed)
    return "put the file that it names there, or make the file that names it again";
  return "the file is damaged: get it again";
}

inline GdalFailure out_of_memory(std::uint64_t memory_bytes) {
  return {ErrorKind::refused, "",
          "reading it takes more than " + std::to_string(memory_bytes >> 20) + " MiB of memory",
          "give a smaller file, or read it in parts: of a raster by --tiles ROWSxCOLUMNS"};
}

inline std::string wkt_of(const OGRSpatialReference& crs) {
  char* text = nullptr;
  std::string wkt;
  if (crs.exportToWkt(&text) == OGRERR_NONE && text != nullptr) wkt = text;
  CPLFree(text);
  return wkt;
}

}  // namespace lepp::gdal_helper

#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/height_grid_read.hpp"

namespace lepp::test {

/// Numbers as bytes of a file.
template <class T>
std::string bytes_of_values(const std::vector<T>& values, bool big_endian) {
  std::string text;
  for (const T value : values) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (big_endian != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
    text += bytes;
  }
  return text;
}

/// A file of NumPy.
inline std::string npy(const std::string& type, const std::string& order, const std::string& shape,
                       const std::string& samples, int version = 1) {
  const std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
  std::string text = "\x93NUMPY";
  text += {static_cast<char>(version), '\0', static_cast<char>(header.size()), '\0'};
  if (version > 1) text += std::string(2, '\0');
  return text + header + samples;
}

/// The grid that a file of this name and content holds.
inline HeightGrid read(const std::string& name, const std::string& text,
                       const HeightGridOptions& options = {}) {
  const ScratchFolder folder;
  return read_height_grid(folder.put(name, text), options);
}

/// What is said about such a file; empty if it is read.
inline std::string refusal(const std::string& name, const std::string& text) {
  return error_of<Error>([&] { read(name, text); });
}

inline const std::string asc_head = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\n";
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The same heights, and NaN at the same places.
inline bool same(const Heights& a, const std::vector<double>& b) {
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < b.size(); ++i)
    equal = a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]));
  return equal;
}

}  // namespace lepp::test

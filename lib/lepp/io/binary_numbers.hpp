#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

#include "lepp/io/atomic_files.hpp"

namespace lepp {

/// The bytes of a number in the order that a format asks for, whatever the machine's is.
template <std::endian order, class Number>
std::array<char, sizeof(Number)> bytes_of(Number number) {
  static_assert(std::is_trivially_copyable_v<Number> && sizeof(Number) <= 8);
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (order != std::endian::native) {
    for (std::size_t i = 0; i < bytes.size() / 2; ++i) {
      std::swap(bytes[i], bytes[bytes.size() - 1 - i]);
    }
  }
  return bytes;
}

/// Writes numbers as bytes.
template <std::endian order>
class BinaryFile {
 public:
  explicit BinaryFile(OutputFile& out) : out_(out) {}

  template <class Number>
  void put(Number number) {
    const auto bytes = bytes_of<order>(number);
    out_ << std::string_view(bytes.data(), bytes.size());
  }
  void text(std::string_view text) { out_ << text; }

 private:
  OutputFile& out_;
};

}  // namespace lepp

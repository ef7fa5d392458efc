#pragma once

#include <cstdint>
#include <span>

namespace lepp::test {

/// The fuzz targets. Each aborts, after a message on stderr, if the library breaks a promise.

/// Bytes to a PSLG of at most 40 points, triangulated with both ways to treat crossings.
void fuzz_pslg_to_cdt(std::span<const std::uint8_t> bytes);

/// Bytes as a .poly file: read, triangulated, written, read again.
void fuzz_poly_reader(std::span<const std::uint8_t> bytes);

/// Ends the program with a message, so that the fuzzer keeps the input.
[[noreturn]] void fail(const char* what);

}  // namespace lepp::test
